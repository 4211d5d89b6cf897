import { describe, expect, it } from "vitest";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type DecalLayer, parseDesign, type StrokeLayer } from "../../web/editor/document/index.ts";

const planar = { kind: "planar", position: [1, 2, 3], rotation: [0, 0, 0, 1], size: [0.1, 0.2, 0.3] };

const read = (layer: object) => {
  const assets = { logo: { type: "image/png", uri: "logo.png" } };
  return parseDesign({ format: "texelcast-design", version: 1, assets, layers: [layer] }).layers[0];
};
const readDab = (dab: unknown) => (read({ type: "stroke", brush: {}, dabs: [planar, dab] }) as StrokeLayer).dabs[1];
const readProjector = (projector: unknown) =>
  (read({ type: "decal", asset: "logo", projector }) as DecalLayer).projector;

/** What is said, and at which field and value. */
function refusal(act: () => unknown): Pick<TexelcastError, "message" | "field" | "value"> {
  try {
    act();
  } catch (thrown) {
    const { message, field, value } = thrown as TexelcastError;
    return { message, field, value };
  }
  throw new Error("It was taken.");
}

const edited = (path: readonly [keyof typeof planar, number?], value: unknown): object => {
  const [field, at] = path;
  const list = [...planar[field]];
  if (at !== undefined) list[at] = value as never;
  return { ...planar, [field]: at === undefined ? value : list };
};

const WRONG = [undefined, null, "1", true, [], [1], {}, Number.NaN, Infinity, -Infinity, 1e9 + 1, -1e9 - 1, "planar"];
const holed: number[] = [1, 2];
holed.length = 3;

describe("planar dabs", () => {
  it.each([
    ...WRONG.flatMap((value) => [
      edited(["position"], value),
      edited(["position", 1], value),
      edited(["rotation"], value),
      edited(["rotation", 3], value),
      edited(["size"], value),
      edited(["size", 2], value),
    ]),
    edited(["position"], holed),
    edited(["position"], [1, 2, 3, 4]),
    edited(["rotation"], [0, 0, 1]),
    edited(["rotation"], [0, 0, 0, 0]),
    edited(["rotation"], [0, 0, 0, 9e-4]),
    edited(["rotation"], [600, 600, 600, 600]),
    edited(["size", 0], 0),
    edited(["size", 1], -0.1),
    edited(["size", 2], 9e-10),
    { ...planar, opacity: 1 },
    { ...planar, kind: "plane" },
    [planar],
    null,
  ])("are refused in the words that refuse a decal's projector: %j", (wrong) => {
    const dab = typeof wrong === "object" && wrong !== null && !Array.isArray(wrong) ? { ...wrong, flow: 1 } : wrong;
    const [asDab, asProjector] = [refusal(() => readDab(dab)), refusal(() => readProjector(wrong))];
    // A dab knows one field more.
    const known = (message: string) => message.replace("size, flow)", "size)");
    expect(asDab.field).toMatch(/^layers\[0\]\.dabs\[1\]/);
    expect({ ...asDab, message: known(asDab.message.replaceAll("dabs[1]", "projector")) }).toEqual({
      ...asProjector,
      field: asDab.field,
    });
    expect(asDab.field?.replace("dabs[1]", "projector")).toBe(asProjector.field);
  });

  it.each([[Number.NaN], [-0.1], [1.1], ["1"], [null]])("are refused with a flow of %j", (flow) => {
    expect(refusal(() => readDab({ ...planar, flow }))).toMatchObject({
      field: "layers[0].dabs[1].flow",
      message: expect.stringContaining("must be a number from 0 to 1, is"),
    });
  });

  it("that have a flow and a field that nobody knows are refused by the field's name", () => {
    const { position: _, ...without } = planar;
    const inherited = Object.assign(Object.create({ position: [1, 2, 3] }), { ...without, flow: 1, opacity: 1 });
    for (const dab of [{ ...planar, flow: 1, opacity: 1 }, inherited]) {
      expect(refusal(() => readDab(dab))).toMatchObject({
        field: "layers[0].dabs[1].opacity",
        message: expect.stringContaining("is not a known field (known here: kind, position, rotation, size, flow)"),
      });
    }
  });

  it("are taken at the very bounds, as projectors are", () => {
    for (const dab of [
      planar,
      edited(["position"], [1e9, -1e9, 0]),
      edited(["rotation"], [0, 0, 0, 1e-3]),
      edited(["rotation"], [500, 500, 500, 500]),
      edited(["size"], [1e-9, 1e9, 1]),
    ]) {
      expect(readDab({ ...dab, flow: 0 })).toEqual({ ...readProjector(dab), flow: 0 });
      expect(readDab(dab)).toEqual({ ...readProjector(dab), flow: 1 });
    }
  });

  it("have their fields in one order, and share nothing with the data that they were read from", () => {
    const [position, rotation, size] = [
      [1, 2, 3],
      [0, 0, 0, 1],
      [0.1, 0.2, 0.3],
    ];
    const dab = readDab({ flow: 0.5, size, rotation, position, kind: "planar" });
    position[0] = rotation[0] = size[0] = 7;
    expect(JSON.stringify(dab)).toBe(JSON.stringify({ ...planar, flow: 0.5 }));
  });
});

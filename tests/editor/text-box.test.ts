import { describe, expect, it } from "vitest";
import { emptyDesign, makeTextLayer, parseDesign, type TextLayer } from "../../web/editor/document/index.ts";
import { emBounds, emOf, fitsClosely, fitted, refitted, withEm } from "../../web/editor/state/text-box.ts";
import type { Projector } from "../../web/engine/engine-api.ts";

const ROTATION = [0, 0, 0, 1] as const;
const PLANAR: Projector = { kind: "planar", position: [1, 2, 3], rotation: ROTATION, size: [0.4, 0.1, 0.2] };
const OTHERS: Projector[] = [
  { kind: "cylindrical", position: [0, 0, 0], rotation: ROTATION, radius: 0.5, height: 0.1, arc: 60, depth: 0.1 },
  { kind: "perspective", position: [0, 0, 1], rotation: ROTATION, fov: 20, aspect: 4, near: 0.1, far: 10 },
  { kind: "uv", center: [0.5, 0.5], size: [0.4, 0.1], angle: 0 },
];
const FONT = { type: "font/ttf", uri: "texelcast:fonts/inter-700" };
const ROOM = { width: 5, height: 1.25 };

function textOn(projector: Projector, more: Partial<TextLayer> = {}): TextLayer {
  return makeTextLayer({ id: "a", text: "Ada", font: "inter", projector, fontSize: 1 / ROOM.height, ...more });
}

describe("a text's box", () => {
  it.each([PLANAR, ...OTHERS])("is laid close about the words, its height as it is: $kind", (projector) => {
    const layer = { ...textOn(projector), ...fitted(textOn(projector), ROOM, 1) };
    expect(fitsClosely(layer, ROOM, 1)).toBe(true);
    expect(fitsClosely(layer, { width: 6, height: 1.25 }, 1)).toBe(false);
  });

  it("of words that are longer than the way round a cylinder is made as low as goes with going round it once", () => {
    const layer = textOn(OTHERS[0] as Projector);
    const room = { width: 200, height: 1.25 };
    const after = { ...layer, ...fitted(layer, room, 1) };
    expect(after.projector).toMatchObject({ arc: 360, height: expect.closeTo((Math.PI * 1.25) / 200, 9) });
    expect(fitsClosely(after, room, 1)).toBe(true);
  });

  it.each([PLANAR, ...OTHERS])("follows words that change, and letters keep their size: $kind", (projector) => {
    const before = { ...textOn(projector), ...fitted(textOn(projector), ROOM, 1) };
    const room = { width: 8, height: 2.5 };
    const after = { ...before, ...refitted(before, ROOM, room) };
    expect(fitsClosely(after, room, 1)).toBe(true);
    // A lens sees a height by its tangent, so that its degrees grow a little less.
    expect(emOf(after) / emOf(before)).toBeCloseTo(1, projector.kind === "perspective" ? 1 : 9);
  });

  it.each([
    ["left", "left", -0.2],
    ["right", "right", 0.2],
    ["centred", "center", null],
  ] as const)("keeps the side that lines are aligned to: %s", (_name, align, side) => {
    const layer = textOn(PLANAR, { align });
    const { projector } = refitted(layer, ROOM, { width: 10, height: 1.25 });
    if (projector.kind !== "planar") throw new Error("the projector became another");
    expect(projector.size).toEqual([0.8, 0.1, 0.4]);
    if (side === null) expect(projector.position).toEqual([1, 2, 3]);
    else expect(projector.position[0] + Math.sign(side) * 0.4).toBeCloseTo(1 + side, 12);
  });

  it("grows as a whole when the letters are made larger", () => {
    const layer = textOn(PLANAR);
    expect(withEm(layer, 2 * emOf(layer))).toMatchObject({ size: [0.8, 0.2, 0.4], position: [1, 2, 3] });
  });

  it.each([PLANAR, ...OTHERS])("lies close about letters of any size that they can be given: $kind", (projector) => {
    const layer = { ...textOn(projector), ...fitted(textOn(projector), ROOM, 1) };
    const { min, max } = emBounds(layer);
    for (const em of [min, emOf(layer) * 1.3, max]) {
      const grown = { ...layer, projector: withEm(layer, em) };
      expect(emOf(grown) / em).toBeCloseTo(1, 9);
      expect(fitsClosely(grown, ROOM, 1), `${em}`).toBe(true);
      const design = { ...emptyDesign(), assets: { inter: FONT }, layers: [grown] };
      expect(() => parseDesign(design), `${em}`).not.toThrow();
    }
  });

  it("that a user made otherwise is known by it", () => {
    expect(fitsClosely(textOn({ ...PLANAR, size: [0.4, 0.2, 0.2] }), ROOM, 1)).toBe(false);
    expect(fitsClosely(textOn(PLANAR, { fontSize: 0.5 }), ROOM, 1)).toBe(false);
    expect(fitsClosely(textOn(OTHERS[2] as Projector), ROOM, 2)).toBe(false);
  });
});

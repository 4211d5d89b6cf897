import { afterEach, describe, expect, it } from "vitest";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  type Gradient,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  parseDesign,
  resolveLayers,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import { fadingGradient } from "../../web/editor/state/aligned-gradient.ts";
import { invertMask } from "../../web/editor/state/layer-edits.ts";
import {
  hidesNothing,
  type MaskStart,
  maskFade,
  maskStartOf,
  stopsAsGreys,
  stopsOfGreys,
  withMaskStart,
} from "../../web/editor/state/mask-edits.ts";
import { allTexels, endHosts, paintablePlane, SIZE } from "../support/painted-plane.ts";

afterEach(endHosts);

const designOf = (...layers: DesignLayer[]): Design => ({ ...emptyDesign(), layers });
const red = makeFillLayer({ id: "red", color: "#ff0000" });
const painted = makeFillLayer({ id: "painted", color: "#000000" });
/** Across the plane of the tests, which lies from -0.5 to 0.5: black hides at the left, white shows at the right. */
const fadeOf = (invert: boolean): Gradient => ({
  kind: "linear",
  from: [-0.5, 0, 0],
  to: [0.5, 0, 0],
  stops: stopsOfGreys(
    [
      { offset: 0, color: "#000000" },
      { offset: 1, color: "#ffffff" },
    ],
    { invert },
  ),
});
const maskOf = (design: Design, id = "red"): NonNullable<DesignLayer["mask"]> => {
  const mask = design.layers.find((layer) => layer.id === id)?.mask;
  if (!mask) throw new Error("It has no mask.");
  return mask;
};

describe("what a mask begins with", () => {
  it("lies below all that is painted on it, and can be changed without losing that", () => {
    let design = designOf({ ...red, mask: { layers: [painted], invert: false, linked: true } });
    const starts: readonly MaskStart[] = ["nothing", fadeOf(false), "nothing", fadeOf(false), "all"];
    for (const start of starts) {
      design = withMaskStart(design, "red", start);
      expect(maskStartOf(maskOf(design))).toEqual(start);
      expect(maskOf(design).layers.at(-1)).toBe(painted);
      expect(maskOf(design).layers).toHaveLength(start === "all" ? 1 : 2);
    }
  });

  it("is what it says where the mask is inverted, too", () => {
    const inverted = designOf({ ...red, mask: { layers: [], invert: true, linked: true } });
    expect(maskStartOf(maskOf(inverted))).toBe("nothing");
    expect(maskStartOf(maskOf(withMaskStart(inverted, "red", "all")))).toBe("all");
    expect(withMaskStart(inverted, "red", "nothing")).toBe(inverted);
    expect(maskStartOf(maskOf(invertMask(withMaskStart(designOf(red), "red", "nothing"), "red")))).toBe("all");
  });

  it("is put on layers of every kind, groups too, and is read from a file as it was", () => {
    const decal = makeDecalLayer({
      id: "decal",
      asset: "logo",
      projector: { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] },
    });
    for (const layer of [red, decal, makeGroupLayer({ id: "group", layers: [red] })]) {
      const assets = { logo: { type: "image/png", uri: "logo.png" } } as const;
      const design = withMaskStart({ ...designOf(layer), assets }, layer.id, fadeOf(false));
      const fade = maskFade(design.layers[0]);
      expect(fade).toMatchObject({ type: "fill", blend: "erase", gradient: fadeOf(false) });
      expect(maskFade(parseDesign(JSON.parse(serialiseDesign(design)), "a file").layers[0])).toEqual(fade);
    }
  });

  it.each([false, true])("a gradient fades the layer from its black to its white (inverted: %s)", async (invert) => {
    const { engine } = await paintablePlane();
    const bare = await allTexels(engine);
    const start = designOf({ ...red, mask: { layers: [], invert, linked: true } });
    engine.setLayers(resolveLayers(withMaskStart(start, "red", fadeOf(invert))), 1);
    await engine.idle();
    const faded = await allTexels(engine);
    for (let x = 0; x < SIZE; x += 1) {
      const at = (SIZE / 2) * SIZE * 4 + x * 4;
      const shown = (x + 0.5) / SIZE;
      const expected = (bare[at + 1] as number) * (1 - shown);
      expect(Math.abs((faded[at + 1] as number) - expected), `column ${x}`).toBeLessThanOrEqual(1);
    }
  });

  it("of a decal fades along its own height, of other layers along the model's", () => {
    const projector = {
      kind: "planar",
      position: [1, 2, 3],
      rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2],
      size: [1, 10, 1],
    } as const;
    const decal = makeDecalLayer({ id: "decal", asset: "logo", projector });
    expect(fadingGradient(null, decal)).toMatchObject({ from: [5, 2, 3], to: [-3, 2, 3] });
    expect(fadingGradient(null, red)).toMatchObject({ from: [0, -0.5, 0], to: [0, 0.5, 0] });
  });
});

describe("a mask's gradient", () => {
  it("is shown in greys, white where it shows the layer, and comes back from them byte for byte", () => {
    for (const invert of [false, true]) {
      for (let grey = 0; grey < 256; grey += 1) {
        const color = `#${grey.toString(16).padStart(2, "0").repeat(3)}`;
        expect(stopsAsGreys(stopsOfGreys([{ offset: 0.5, color }], { invert }), { invert })).toEqual([
          { offset: 0.5, color },
        ]);
      }
    }
  });

  it("takes other colours by their lightness", () => {
    const [green, blue] = stopsAsGreys(
      stopsOfGreys(
        [
          { offset: 0, color: "#00ff00" },
          { offset: 1, color: "#0000ff" },
        ],
        { invert: false },
      ),
      { invert: false },
    );
    expect([green?.color, blue?.color]).toEqual(["#969696", "#1d1d1d"]);
  });
});

it("a mask that nothing was hidden by shows all, and no other does", () => {
  const hidden = withMaskStart(designOf(red), "red", "nothing");
  expect(hidesNothing({ layers: [painted], invert: false, linked: true })).toBe(true);
  expect(hidesNothing({ layers: [], invert: true, linked: true })).toBe(false);
  expect(hidesNothing(maskOf(hidden))).toBe(false);
});

/** Every blend mode under the name that designs have for it, through the engine to the texels. */
import { afterEach, describe, expect, it } from "vitest";
import { BLEND_MODES } from "../../web/editor/document/index.ts";
import type { BlendMode, EngineFillLayer } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { decal, fill } from "../support/layers.ts";
import { buildGlb } from "../support/model-builder.ts";
import { allTexels, endHosts, paintablePlane, startHost, texturedPlane } from "../support/painted-plane.ts";

afterEach(endHosts);

type Rgb = readonly [number, number, number];
type Rgba = readonly [number, number, number, number];

const BACKDROP: Rgb = [112, 211, 134];
const SOURCE: Rgb = [176, 82, 91];

/** What the standard's formulas give for these two, worked out apart from this program: in sRGB, in linear light. */
const MIXED: readonly (readonly [BlendMode, Rgb, Rgb])[] = [
  ["normal", [176, 82, 91], [176, 82, 91]],
  ["multiply", [77, 68, 48], [75, 66, 44]],
  ["screen", [211, 225, 177], [192, 215, 153]],
  ["overlay", [155, 195, 99], [105, 162, 63]],
  ["darken", [112, 82, 91], [112, 82, 91]],
  ["lighten", [176, 211, 134], [176, 211, 134]],
  ["color-dodge", [255, 255, 208], [146, 219, 141]],
  ["color-burn", [48, 118, 0], [0, 0, 0]],
  ["hard-light", [166, 136, 96], [105, 93, 63]],
  ["soft-light", [134, 198, 116], [106, 181, 87]],
  ["difference", [64, 129, 43], [142, 198, 102]],
  ["exclusion", [133, 157, 129], [180, 207, 147]],
  ["hue", [241, 142, 152], [231, 151, 157]],
  ["saturation", [115, 209, 136], [136, 203, 149]],
  ["color", [238, 144, 153], [218, 160, 164]],
  ["luminosity", [50, 149, 72], [0, 152, 63]],
];

const units = ([red, green, blue]: Rgb, alpha = 1): Rgba => [red / 255, green / 255, blue / 255, alpha];

/** An engine whose plane has one colour. */
async function plainPlane(base: Rgba): Promise<EngineHost> {
  const engine = startHost();
  await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
  await engine.openTarget({ material: 0, width: 16, height: 16, base });
  return engine;
}

async function mix(base: Rgba, changes: Partial<EngineFillLayer>, color = units(SOURCE)): Promise<number[]> {
  const engine = await plainPlane(base);
  engine.setLayers([fill("f", color, changes)], 1);
  return Array.from(await engine.readTexels(0, 5, 5, 1, 1));
}

describe("blend modes", () => {
  it.each(MIXED)("%s gives what the standard says, in sRGB and in linear light", async (blend, inSrgb, inLinear) => {
    expect(await mix(units(BACKDROP), { blend })).toEqual([...inSrgb, 255]);
    expect(await mix(units(BACKDROP), { blend, blendSpace: "linear" })).toEqual([...inLinear, 255]);
  });

  it("are all of the design's, erase being the one that takes away", async () => {
    expect([...MIXED.map(([blend]) => blend), "erase"]).toEqual([...BLEND_MODES]);
    expect(await mix(units(BACKDROP), { blend: "erase", opacity: 0.4 })).toEqual([...BACKDROP, 153]);
    expect(await mix(units(BACKDROP), { blend: "erase" })).toEqual([...BACKDROP, 0]);
  });

  it("leave a locked alpha as it was", async () => {
    for (const blend of BLEND_MODES) {
      const [, , , alpha] = await mix(units(BACKDROP, 100 / 255), { blend, lockAlpha: true });
      expect(alpha, blend).toBe(100);
    }
  });

  it("change without projecting again", async () => {
    const { engine } = await paintablePlane();
    const seen = new Set<string>();
    engine.setLayers([decal("a", "logo")], 1);
    await engine.idle();
    const { projectionCount } = await engine.stats();
    for (const [revision, blend] of BLEND_MODES.entries()) {
      engine.setLayers([decal("a", "logo", { blend })], 2 + revision);
      seen.add(Buffer.from(await allTexels(engine)).toString("base64"));
    }
    expect(seen.size).toBe(BLEND_MODES.length);
    expect((await engine.stats()).projectionCount).toBe(projectionCount);
  });
});

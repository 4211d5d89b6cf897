import { afterEach, describe, expect, it } from "vitest";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import { dab, fill, group, stroke } from "../support/layers.ts";
import { endHosts, paintablePlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const SIDE = 33;
const RED = { tip: "round", color: [1, 0, 0, 1], hardness: 1, flow: 1 } as const;

const pixel = (rgba: Uint8Array, x: number, y: number): number[] => [
  ...rgba.subarray((y * SIDE + x) * 4, (y * SIDE + x) * 4 + 4),
];

async function draw(
  layers: readonly EngineLayer[],
  id: string,
  of: "layer" | "mask" = "layer",
): Promise<Uint8Array | null> {
  const { engine } = await paintablePlane();
  engine.setLayers(layers, 1);
  return await engine.layerMiniature(id, of, SIDE);
}

describe("the small picture of a layer", () => {
  it("shows what the layer itself paints, enlarged, without its opacity and what is below", async () => {
    const small = dab(0.2, 0.1, 0.2);
    const rgba = await draw([fill("f", [0, 1, 0, 1]), stroke("s", [small], { brush: RED, opacity: 0.3 })], "s");
    const pixels = Array.from({ length: SIDE * SIDE }, (_, i) =>
      pixel(rgba as Uint8Array, i % SIDE, Math.floor(i / SIDE)),
    );
    const painted = pixels.filter(([, , , alpha]) => alpha !== 0);
    expect(painted.every(([red, green, blue]) => red === 255 && green === 0 && blue === 0)).toBe(true);
    expect(painted.some(([, , , alpha]) => alpha === 255)).toBe(true);
    // The dab is three hundredths of the texture.
    expect(painted.length).toBeGreaterThan(pixels.length / 10);
    expect(painted.length).toBeLessThan(pixels.length);
  });

  it("has the holes that an eraser left in a paint layer", async () => {
    const painted = stroke("s", [dab(0, 0, 0.6)], { brush: RED });
    const erased = stroke("e", [dab(0, 0, 0.2)], { blend: "erase" });
    const rgba = (await draw([group("g", [painted, erased], { isolated: true })], "g")) as Uint8Array;
    expect(pixel(rgba, 16, 16)[3]).toBe(0);
    expect(pixel(rgba, 16, 8)).toEqual([255, 0, 0, 255]);
  });

  it("of a mask is black where it hides the layer", async () => {
    const hole = stroke("h", [dab(0, 0, 0.3)], { blend: "erase" });
    const masked = fill("f", [0, 0, 1, 1], { mask: { layers: [hole], invert: false } });
    const rgba = (await draw([masked], "f", "mask")) as Uint8Array;
    expect(pixel(rgba, 16, 16)).toEqual([0, 0, 0, 255]);
    expect(pixel(rgba, 1, 1)).toEqual([255, 255, 255, 255]);
    const inverted = fill("f", [0, 0, 1, 1], { mask: { layers: [hole], invert: true } });
    expect(pixel((await draw([inverted], "f", "mask")) as Uint8Array, 16, 16)).toEqual([255, 255, 255, 255]);
  });

  it("is none for a layer that paints nothing, is hidden, or is not known", async () => {
    expect(await draw([stroke("s", [], { brush: RED })], "s")).toBeNull();
    expect(await draw([stroke("s", [dab(0, 0, 0.4)], { brush: RED, visible: false })], "s")).toBeNull();
    expect(await draw([], "s")).toBeNull();
  });

  it("of another size than 1 to 256 pixels is refused by name", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([fill("f", [0, 1, 0, 1])], 1);
    await expect(engine.layerMiniature("f", "layer", 257)).rejects.toThrow(/side is 257; it may be 1 to 256/);
  });
});

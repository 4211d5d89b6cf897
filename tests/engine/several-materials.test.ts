import { afterEach, describe, expect, it } from "vitest";
import type { EngineLayer, TargetUpdate } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { decal, fill } from "../support/layers.ts";
import { endHosts, LOGO, startHost } from "../support/painted-plane.ts";
import { halvesGlb, ROOF } from "../support/two-halves.ts";

afterEach(endHosts);

const SIDE = 128;
const WHITE = [1, 1, 1, 1] as const;

/** Leans, and lies over the border between the halves. */
const CROSSING = decal("a", "logo", {
  material: [0, 1],
  projector: { kind: "planar", position: [0.03, 0.05, 0], rotation: [0, 0, 0.2588, 0.9659], size: [0.6, 0.4, 0.5] },
});

async function paint(glb: Uint8Array, materials: readonly number[], layers: readonly EngineLayer[]) {
  const engine = startHost();
  const updates: TargetUpdate[] = [];
  engine.onUpdate((update) => updates.push(update));
  await engine.loadModel({ name: "halves.glb", bytes: glb });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  for (const material of materials) await engine.openTarget({ material, width: SIDE, height: SIDE, base: WHITE });
  engine.setLayers(layers, 1);
  await engine.idle();
  return { engine, updates };
}

const texelsOf = (engine: EngineHost, material: number) => engine.readTexels(material, 0, 0, SIDE, SIDE);

/** Those of a picture that are not white. */
function paintedTexels(rgba: Uint8Array): number[] {
  const painted: number[] = [];
  for (let texel = 0; texel < rgba.length / 4; texel++) {
    if (rgba.subarray(4 * texel, 4 * texel + 4).some((value) => value !== 255)) painted.push(texel);
  }
  return painted;
}
const columnOf = (texel: number): number => texel % SIDE;

describe("a decal of several materials", () => {
  it("paints both sides of a border as it paints the same surface of one material, texel by texel", async () => {
    const whole = await paint(halvesGlb({ materials: 1 }), [0], [{ ...CROSSING, material: 0 }]);
    const halves = await paint(halvesGlb({ materials: 2 }), [0, 1], [CROSSING]);
    const expected = await texelsOf(whole.engine, 0);
    const [left, right] = [await texelsOf(halves.engine, 0), await texelsOf(halves.engine, 1)];
    const together = new Uint8Array(expected.length);
    for (let texel = 0; texel < SIDE * SIDE; texel++) {
      const half = columnOf(texel) < SIDE / 2 ? left : right;
      together.set(half.subarray(4 * texel, 4 * texel + 4), 4 * texel);
    }
    expect(together).toEqual(expected);
    for (const [half, isOwn] of [
      [left, (column: number) => column < SIDE / 2],
      [right, (column: number) => column >= SIDE / 2],
    ] as const) {
      const painted = paintedTexels(half).filter((texel) => isOwn(columnOf(texel)));
      expect(painted.length).toBeGreaterThan(1000);
    }
  });

  it("paints past the border in each texture no further than its gutter", async () => {
    const { engine } = await paint(halvesGlb({ materials: 2 }), [0, 1], [CROSSING]);
    const columns = async (material: number) => paintedTexels(await texelsOf(engine, material)).map(columnOf);
    expect(Math.max(...(await columns(0)))).toBe(SIDE / 2 - 1 + 2);
    expect(Math.min(...(await columns(1)))).toBe(SIDE / 2 - 2);
  });

  it("leaves the other half alone where it names one material", async () => {
    const { engine } = await paint(halvesGlb({ materials: 2 }), [0, 1], [{ ...CROSSING, material: [1] }]);
    expect(paintedTexels(await texelsOf(engine, 0))).toEqual([]);
    expect(paintedTexels(await texelsOf(engine, 1)).length).toBeGreaterThan(1000);
  });

  it("goes from a texture when the layer gives the material up, and reports both textures under one revision", async () => {
    const { engine, updates } = await paint(halvesGlb({ materials: 2 }), [0, 1], [CROSSING]);
    updates.length = 0;
    engine.setLayers([{ ...CROSSING, opacity: 0.5 }], 2);
    await engine.idle();
    expect(updates.map(({ material, revision }) => [material, revision])).toEqual([
      [0, 2],
      [1, 2],
    ]);
    updates.length = 0;
    engine.setLayers([{ ...CROSSING, opacity: 0.5, material: 0 }], 3);
    await engine.idle();
    expect(updates.map(({ material }) => material)).toEqual([1]);
    expect(paintedTexels(await texelsOf(engine, 1))).toEqual([]);
  });

  it("paints a material whose target is opened later", async () => {
    const { engine } = await paint(halvesGlb({ materials: 2 }), [0], [CROSSING]);
    await engine.openTarget({ material: 1, width: SIDE, height: SIDE, base: WHITE });
    await engine.idle();
    expect(paintedTexels(await texelsOf(engine, 1)).length).toBeGreaterThan(1000);
  });

  it("keeps its place among the layers in each texture", async () => {
    const under = fill("u", [0, 0, 1, 1], { material: [0, 1] });
    const over = fill("o", [1, 0, 0, 1], { material: 1 });
    const { engine } = await paint(halvesGlb({ materials: 2 }), [0, 1], [under, CROSSING, over]);
    const texel = async (material: number, x: number) => [...(await engine.readTexels(material, x, 60, 1, 1))];
    expect(await texel(0, 2)).toEqual([0, 0, 255, 255]);
    expect(await texel(0, 60)).not.toEqual([0, 0, 255, 255]);
    expect(await texel(1, 70)).toEqual([255, 0, 0, 255]);
  });
});

describe("occlusion between materials", () => {
  const below = { x: Math.round(0.375 * SIDE), y: SIDE / 2 };
  const square = {
    ...CROSSING,
    projector: { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [0.8, 0.8, 0.5] },
  } as const;

  it("hides a surface behind one of another material, which is painted in its place", async () => {
    const glb = halvesGlb({ materials: 2, more: [ROOF] });
    const { engine } = await paint(glb, [0, 1], [square]);
    expect([...(await engine.readTexels(0, below.x, below.y, 1, 1))]).toEqual([255, 255, 255, 255]);
    expect([...(await engine.readTexels(1, 10, 10, 1, 1))]).not.toEqual([255, 255, 255, 255]);
  });

  it("hides it too where the decal does not paint that other material", async () => {
    const glb = halvesGlb({ materials: 2, more: [ROOF] });
    const { engine } = await paint(glb, [0, 1], [{ ...square, material: 0 }]);
    expect([...(await engine.readTexels(0, below.x, below.y, 1, 1))]).toEqual([255, 255, 255, 255]);
    expect(paintedTexels(await texelsOf(engine, 1))).toEqual([]);
  });

  it("is not looked at where the decal paints through", async () => {
    const glb = halvesGlb({ materials: 2, more: [ROOF] });
    const { engine } = await paint(glb, [0, 1], [{ ...square, occlusion: "none" }]);
    expect([...(await engine.readTexels(0, below.x, below.y, 1, 1))]).not.toEqual([255, 255, 255, 255]);
    expect([...(await engine.readTexels(1, 10, 10, 1, 1))]).not.toEqual([255, 255, 255, 255]);
  });
});

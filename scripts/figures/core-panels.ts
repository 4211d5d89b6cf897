/** The panels that are pictures of the core itself: maps, textures, and models with another texture inside. */
import { type Design, resolveLayers } from "../../web/editor/document/index.ts";
import type { TargetOptions } from "../../web/engine/engine-api.ts";
import { createEngineHost, type EngineHost } from "../../web/engine/engine-host.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { frontOf, strokesDesign } from "./brush-strokes.ts";
import { avatar, designOf, type Stamp } from "./subject.ts";

/** Texels along a side: the avatar's own. */
export const SIZE = 1024;
const WHITE = [1, 1, 1, 1] as const;
const CLAY = [0.66, 0.7, 0.76, 1] as const;

async function withAvatar<Result>(
  base: TargetOptions["base"],
  work: (engine: EngineHost) => Promise<Result>,
): Promise<Result> {
  const engine = createEngineHost();
  try {
    await engine.loadModel({ name: "avatar.glb", bytes: await avatar() });
    await engine.openTarget({ material: 0, width: SIZE, height: SIZE, base });
    return await work(engine);
  } finally {
    engine.dispose();
  }
}

async function paint(engine: EngineHost, design: Design): Promise<void> {
  for (const [key, { uri }] of Object.entries(design.assets)) {
    const bytes = Buffer.from(uri.slice(uri.indexOf(",") + 1), "base64");
    await engine.setAsset(key, { name: `${key}.png`, bytes });
  }
  engine.setLayers(resolveLayers(design), 1);
  await engine.idle();
}

/** The local space texture as the paper shows it, and the mesh's edges in texture space. */
export function mapPanels(): Promise<{ positions: Uint8Array; normals: Uint8Array; uvTriangles: Float32Array }> {
  return withAvatar("model", async (engine) => ({
    positions: await encodePng(await engine.viewMap(0, "positions")),
    normals: await encodePng(await engine.viewMap(0, "normals")),
    uvTriangles: await engine.uvTriangles(0),
  }));
}

/** The finished texture of a design. */
export function targetPanel(design: Design): Promise<Uint8Array> {
  return withAvatar("model", async (engine) => {
    await paint(engine, design);
    return engine.exportPng(0);
  });
}

/** The model without its picture. */
export function blankModel(): Promise<Uint8Array> {
  return withAvatar(CLAY, (engine) => engine.exportGlb());
}

/** A design of strokes painted on the avatar by hand. */
export function handPainted(): Promise<Design> {
  return withAvatar("model", async (engine) => strokesDesign(await frontOf(engine, SIZE)));
}

/**
 * A decal laid flat into the texture, where and as large as the projected one is in its middle: what painting without the
 * local space texture comes to.
 */
export async function flatStamp(stamp: Stamp): Promise<Design> {
  const projected = await designOf([stamp]);
  const { center, side } = await placeInTexture(stamp);
  const projector = { kind: "uv", center, size: [side, side], angle: 0 } as const;
  const layers = projected.layers.map((layer) => (layer.type === "decal" ? { ...layer, projector } : layer));
  return { ...projected, layers };
}

/** In u and v. */
interface Place {
  readonly center: readonly [number, number];
  readonly side: number;
}

/** Found by a stamp a tenth as large: the middle of what it paints, and how many texels wide that is. */
async function placeInTexture(stamp: Stamp): Promise<Place> {
  const small = await designOf([{ ...stamp, decal: "badge", size: stamp.size / 10 }]);
  return withAvatar(WHITE, async (engine) => {
    await paint(engine, small);
    const rgba = await engine.readTexels(0, 0, 0, SIZE, SIZE);
    let [left, top, right, bottom] = [SIZE, SIZE, 0, 0];
    for (let at = 0; at < SIZE * SIZE; at++) {
      if (rgba[at * 4] + rgba[at * 4 + 1] + rgba[at * 4 + 2] === 3 * 255) continue;
      const [x, y] = [at % SIZE, Math.floor(at / SIZE)];
      [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)];
    }
    if (right < left) throw new Error("The stamp misses the avatar.");
    const middle = (from: number, to: number): number => (from + to + 1) / 2 / SIZE;
    return { center: [middle(left, right), middle(top, bottom)], side: ((right - left + 1) * 10) / SIZE };
  });
}

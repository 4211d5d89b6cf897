/** The panels that are pictures of the core itself: maps, textures, and models with another texture inside. */
import { type Design, resolveLayers } from "../../web/editor/document/index.ts";
import type { Picture, TargetOptions } from "../../web/engine/engine-api.ts";
import { createEngineHost, type EngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { avatar, decalPng, designOf, type Stamp } from "./subject.ts";

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

/**
 * A decal laid flat into the texture, where and as large as the projected one is in its middle: what painting without the
 * local space texture comes to.
 */
export async function flatStamp(stamp: Stamp): Promise<{ texture: Uint8Array; model: Uint8Array }> {
  const place = await placeInTexture(stamp);
  const decal = await decodePicture(await decalPng(stamp.decal), stamp.decal);
  const texture = await withAvatar("model", async (engine) => {
    const rgba = await engine.readTexels(0, 0, 0, SIZE, SIZE);
    layFlat({ width: SIZE, height: SIZE, rgba }, decal, place);
    return encodePng({ width: SIZE, height: SIZE, rgba });
  });
  const model = await withAvatar({ name: "flat.png", bytes: texture }, (engine) => engine.exportGlb());
  return { texture, model };
}

interface Place {
  /** Texels. */
  readonly x: number;
  readonly y: number;
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
    return { x: (left + right + 1) / 2, y: (top + bottom + 1) / 2, side: (right - left + 1) * 10 };
  });
}

/** Source over, each texel the mean of the decal's pixels under it. */
function layFlat(target: Picture, decal: Picture, { x, y, side }: Place): void {
  const scale = decal.width / side;
  for (let row = Math.floor(y - side / 2); row < y + side / 2; row++) {
    for (let column = Math.floor(x - side / 2); column < x + side / 2; column++) {
      if (row < 0 || column < 0 || row >= target.height || column >= target.width) continue;
      const [u, v] = [(column - x + side / 2) * scale, (row - y + side / 2) * scale];
      const [red, green, blue, alpha] = meanOf(decal, u, v, scale);
      const at = (row * target.width + column) * 4;
      for (const [channel, value] of [red, green, blue].entries()) {
        target.rgba[at + channel] = value + target.rgba[at + channel] * (1 - alpha);
      }
    }
  }
}

/** Premultiplied, 0 to 255; alpha 0 to 1. */
function meanOf(picture: Picture, left: number, top: number, side: number): [number, number, number, number] {
  const sum: [number, number, number, number] = [0, 0, 0, 0];
  let count = 0;
  for (let y = Math.floor(top); y < top + side; y++) {
    for (let x = Math.floor(left); x < left + side; x++) {
      count++;
      if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      const at = (y * picture.width + x) * 4;
      const alpha = picture.rgba[at + 3] / 255;
      for (let channel = 0; channel < 3; channel++) sum[channel] += picture.rgba[at + channel] * alpha;
      sum[3] += alpha;
    }
  }
  return [sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count];
}

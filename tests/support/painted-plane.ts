/** A plane that is open for painting on an engine in this thread: what most claims about the engine start from. */
import type { EngineDecalLayer, TargetUpdate } from "../../web/engine/engine-api.ts";
import { createEngineHost, type EngineHost, type EngineHostOptions } from "../../web/engine/engine-host.ts";
import { FRONT } from "./layers.ts";
import { buildGlb, type ModelParts, plane } from "./model-builder.ts";
import { paintPng } from "./png-file.ts";

/** Texels along a side of the plane's texture. */
export const SIZE = 64;
export const CHART = paintPng(SIZE, SIZE, (x, y) => [x * 4, y * 4, (x * y) % 256, 255]);
export const LOGO = paintPng(16, 16, (x, y) => [255 - x, y * 9, 40, x < 2 ? 0 : 200]);

export const texturedPlane = {
  meshes: [plane(1, 0)],
  materials: [{ name: "label", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  textures: [{ source: 0 }],
  images: [{ bytes: CHART, mimeType: "image/png" }],
} satisfies ModelParts;

const engines: EngineHost[] = [];

export function startHost(options: EngineHostOptions = {}): EngineHost {
  const engine = createEngineHost(options);
  engines.push(engine);
  return engine;
}

/** For `afterEach`: ends all engines that `startHost` started. */
export function endHosts(): void {
  for (const engine of engines.splice(0)) engine.dispose();
}

/** A host with the plane open for painting, a logo to paint with, and all updates since. */
export async function paintablePlane(): Promise<{ engine: EngineHost; updates: TargetUpdate[] }> {
  const engine = startHost();
  const updates: TargetUpdate[] = [];
  engine.onUpdate((update) => updates.push(update));
  await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  await engine.openTarget({ material: 0 });
  await engine.idle();
  return { engine, updates };
}

export const allTexels = (engine: EngineHost): Promise<Uint8Array> => engine.readTexels(0, 0, 0, SIZE, SIZE);

/** Where a decal lies on the plane, metres. */
export function at(x: number, y: number, size = 0.25): Partial<EngineDecalLayer> {
  return { projector: { ...FRONT, position: [x, y, 0], size: [size, size, 0.5] } };
}

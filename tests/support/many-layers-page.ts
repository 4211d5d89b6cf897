/** The recipe of tests/golden/README.md painted by the engine of an open editor page, whichever browser it is in. */
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import { manyLayers, manyLayersModel, manyLayersPictures, manyLayersSize } from "./many-layers.ts";

/** What can be sent to a page: bytes are in base64. */
export interface ManyLayersInput {
  readonly model: string;
  readonly pictures: readonly { readonly key: string; readonly png: string }[];
  readonly layers: EngineLayer[];
  readonly size: number;
}

export function manyLayersInput(): ManyLayersInput {
  const base64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString("base64");
  return {
    model: base64(manyLayersModel()),
    pictures: manyLayersPictures().map(({ key, bytes }) => ({ key, png: base64(bytes) })),
    layers: manyLayers(),
    size: manyLayersSize,
  };
}

/** For the driver's `page.evaluate`: runs in the page, so it uses nothing from outside itself. */
export async function hashManyLayersInPage({ model, pictures, layers, size }: ManyLayersInput): Promise<string> {
  const bytes = (text: string): Uint8Array => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const { engine } = window.texelcast;
  await engine.loadModel({ name: "many-layers.glb", bytes: bytes(model) });
  for (const { key, png } of pictures) await engine.setAsset(key, { name: `${key}.png`, bytes: bytes(png) });
  await engine.openTarget({ material: 0, width: size, height: size, base: [1, 1, 1, 1] });
  engine.setLayers(layers, 1_000_000);
  await engine.idle();
  return engine.hash(0);
}

/** A stored design as the file that is printed: the same engine as on the page, so the same bytes. */
import { parseDesign, resolveLayers } from "../../web/editor/document/index.ts";
import type { ModelSource } from "../../web/engine/engine-api.ts";
import { fontsOf, picturesOf } from "../../web/engine/layer-picture.ts";
import { openEngine } from "../open-engine.ts";
import type { AssetStore } from "./asset-store.ts";
import { fileOfAddress } from "./line-intake.ts";
import { notFound } from "./shop-error.ts";

export interface PrintFile {
  /** PNG. */
  readonly bytes: Uint8Array;
  /** Texels. */
  readonly width: number;
  readonly height: number;
}

/**
 * @param design as the cart keeps it: its assets' addresses are those of stored files
 * @throws TexelcastError as the engine does; "not-found" for a file that is not stored.
 */
export async function renderPrintFile(
  model: ModelSource,
  material: number,
  design: unknown,
  store: AssetStore,
): Promise<PrintFile> {
  const document = parseDesign(design);
  const layers = resolveLayers(document).filter((layer) => layer.visible);
  const fileOf = async (key: string): Promise<{ name: string; bytes: Uint8Array }> => {
    const file = fileOfAddress(document.assets[key]?.uri ?? "");
    if (file === null) throw notFound("file", key);
    return { name: key, bytes: await store.read(file) };
  };
  const engine = openEngine();
  try {
    await engine.loadModel(model);
    for (const key of picturesOf(layers)) await engine.setAsset(key, await fileOf(key));
    for (const key of fontsOf(layers)) await engine.setFont(key, await fileOf(key));
    const { width, height } = await engine.openTarget({ material });
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    engine.setLayers(layers, 1);
    await engine.idle();
    if (errors[0] !== undefined) throw errors[0];
    return { bytes: await engine.exportPng(material), width, height };
  } finally {
    engine.dispose();
  }
}

/** What a shop gets of a design: the texture as it is printed, and what the printer would say of it. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { contentHash } from "../../editor/storage/content-hash.ts";
import { readPictureHeader } from "../../engine/picture-header.ts";
import type { ExportedTexture, ExportTextureOptions, LayerArea, PrintReport } from "../element-api.ts";
import type { Mode } from "../mode.ts";
import type { DeskSettings } from "./desk-settings.ts";

export async function exportTexture(
  mode: Mode,
  options: ExportTextureOptions,
  settings: DeskSettings,
): Promise<ExportedTexture> {
  await mode.idle();
  const material = options.material ?? settings.material ?? mode.store.state.material ?? 0;
  const bytes = await mode.engine.exportPng(material);
  const { width, height } = readPictureHeader(bytes, "texture");
  return { bytes, width, height, sha256: await contentHash(bytes) };
}

export async function printReport(_mode: Mode): Promise<PrintReport> {
  throw new TexelcastError("unsupported", "There is no print report yet.");
}

export async function layerAreas(_mode: Mode): Promise<readonly LayerArea[]> {
  return [];
}

/** Whether a model is compressed, told without what undoes it. */
import { extensionsUsed, type JsonObject } from "./gltf-json.ts";
import { MESHOPT_EXTENSIONS } from "./gltf-packer.ts";

export const DRACO = "KHR_draco_mesh_compression";

/** The compression extensions that a model uses. */
export function compressionOf(json: JsonObject): readonly string[] {
  const used = extensionsUsed(json);
  return [DRACO, ...MESHOPT_EXTENSIONS].filter((extension) => used.includes(extension));
}

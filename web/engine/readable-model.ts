/** What few models have, undone, each by what is loaded for it alone: KTX2 textures, compressed geometry, instances. */
import { writeGlb } from "./gltf-container.ts";
import { extensionsUsed } from "./gltf-json.ts";
import type { PackedGltf } from "./gltf-packer.ts";
import { COMPRESSION, INSTANCES } from "./model-extensions.ts";
import { BASISU_TEXTURE } from "./model-textures.ts";

export interface ReadableModel {
  /** Geometry as in the file; pictures that were KTX2 alone are PNG. */
  readonly packed: PackedGltf;
  /** Uncompressed, each instance a node of its own. */
  readonly glb: Uint8Array;
}

/** `given.json` may change. Rejects as `loadModelFile` says. */
export async function readableModel(given: PackedGltf, name: string): Promise<ReadableModel> {
  const used = extensionsUsed(given.json);
  const packed = used.includes(BASISU_TEXTURE)
    ? await (await import("./basis-textures.ts")).withoutBasis(given, name)
    : given;
  const glb = COMPRESSION.some((extension) => used.includes(extension))
    ? await (await import("./model-decoder.ts")).decodeModel(packed, name)
    : writeGlb(packed.json, packed.binary);
  // What says where instances stand may be compressed itself.
  return {
    packed,
    glb: used.includes(INSTANCES) ? (await import("./mesh-instances.ts")).withoutInstances(glb, name) : glb,
  };
}

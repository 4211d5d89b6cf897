/**
 * What few models have, undone, each by what is loaded for it alone: colours of another kind, KTX2 textures, compressed geometry,
 * hidden nodes, instances.
 */
import { writeGlb } from "./gltf-container.ts";
import { extensionsUsed } from "./gltf-json.ts";
import type { PackedGltf } from "./gltf-packer.ts";
import { COMPRESSION, INSTANCES, NODE_VISIBILITY, SPECULAR_GLOSSINESS } from "./model-extensions.ts";
import { BASISU_TEXTURE } from "./model-textures.ts";

export interface ReadableModel {
  /** Geometry as in the file; pictures that were KTX2 alone are PNG. */
  readonly packed: PackedGltf;
  /** Uncompressed, each instance a node of its own, nothing on hidden nodes. */
  readonly glb: Uint8Array<ArrayBuffer>;
}

/** `given.json` may change. Rejects as `loadModelFile` says. */
export async function readableModel(given: PackedGltf, name: string): Promise<ReadableModel> {
  const used = extensionsUsed(given.json);
  if (used.includes(SPECULAR_GLOSSINESS)) {
    (await import("./specular-glossiness.ts")).withoutSpecularGlossiness(given.json, name);
  }
  const packed = used.includes(BASISU_TEXTURE)
    ? await (await import("./basis-textures.ts")).withoutBasis(given, name)
    : given;
  let glb = COMPRESSION.some((extension) => used.includes(extension))
    ? await (await import("./model-decoder.ts")).decodeModel(packed, name)
    : writeGlb(packed.json, packed.binary);
  if (used.includes(NODE_VISIBILITY)) glb = (await import("./hidden-nodes.ts")).withoutHidden(glb, name);
  // What says where instances stand may be compressed itself.
  if (used.includes(INSTANCES)) glb = (await import("./mesh-instances.ts")).withoutInstances(glb, name);
  return { packed, glb };
}

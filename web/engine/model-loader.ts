/** A model file made ready: its parts for writing it back, and an uncompressed, self-contained GLB for the core and viewers. */
import type { ModelSource } from "./engine-api.ts";
import { type GltfContainer, readContainer, writeGlb } from "./gltf-container.ts";
import { extensionsUsed } from "./gltf-json.ts";
import { type PackedGltf, packGltf } from "./gltf-packer.ts";
import { COMPRESSION, INSTANCES, NODE_VISIBILITY, SPECULAR_GLOSSINESS } from "./model-extensions.ts";
import { BASISU_TEXTURE, findBaseTexture, imageBytes } from "./model-textures.ts";
import { readPictureHeader } from "./picture-header.ts";

/** What `readableModel` undoes. */
const UNUSUAL: readonly string[] = [BASISU_TEXTURE, ...COMPRESSION, INSTANCES, NODE_VISIBILITY, SPECULAR_GLOSSINESS];

/** No glTF does. */
const ZIP_BEGINS = 0x50;

export interface LoadedModel {
  readonly name: string;
  /** The user's own file, for writing back. */
  readonly original: GltfContainer;
  /**
   * Self-contained, geometry compressed as in the file. Its materials, textures and images are the file's; what only KTX2 textures
   * have, they have as PNG, and what stood in KHR_materials_pbrSpecularGlossiness, as their base colour.
   */
  readonly packed: PackedGltf;
  /** Of its images by their index, once asked for: a PNG is read to its end for it, and materials share images. */
  readonly sizes: Map<number, Promise<PixelSize | null>>;
  /** Of those, the ones that EXIF would turn. */
  readonly turned: Set<number>;
}

type PixelSize = readonly [width: number, height: number];

/** A model just read, with what is needed of it once. */
export interface ReadModel extends LoadedModel {
  /** Self-contained and uncompressed, each instance of a mesh a node of its own, nothing on hidden nodes; memory of its own. */
  readonly glb: Uint8Array<ArrayBuffer>;
}

/**
 * Reads a model, also from a zip, and in the look of a variant (`chosenModel`). The source's bytes are copied, so the caller may do
 * with them what it likes, or taken over. Throws "bad-container", "missing-file" (naming the side file), "bad-model",
 * "out-of-budget", and "bad-picture" (naming a KTX2 image).
 */
export async function loadModelFile(given: ModelSource, takesOver = false): Promise<ReadModel> {
  const mayBeChosen = given.bytes[0] === ZIP_BEGINS || given.name.includes("#");
  const source = mayBeChosen ? await (await import("./chosen-model.ts")).chosenModel(given) : given;
  // Not by `slice`, which of Node's Buffers gives the same memory again.
  const own = (bytes: Uint8Array): Uint8Array => (takesOver ? bytes : new Uint8Array(bytes));
  const resources = new Map<string, Uint8Array>();
  for (const [uri, bytes] of source.resources ?? []) resources.set(uri, own(bytes));
  const original = readContainer({ name: source.name, bytes: own(source.bytes), resources });
  const packed = packGltf(original);
  const unusual = extensionsUsed(packed.json).some((extension) => UNUSUAL.includes(extension));
  const readable = unusual
    ? await (await import("./readable-model.ts")).readableModel(packed, source.name)
    : { packed, glb: writeGlb(packed.json, packed.binary) };
  return { name: source.name, original, sizes: new Map(), turned: new Set(), ...readable };
}

/** Pixels of a material's base colour picture as its header says; null without a picture, or when it cannot be read. */
export async function baseTextureSize(model: LoadedModel, material: number): Promise<PixelSize | null> {
  const image = findBaseTexture(model.packed.json, material, model.name)?.image ?? null;
  if (image === null) return null;
  const size = model.sizes.get(image) ?? imageSize(model, image);
  model.sizes.set(image, size);
  return size;
}

async function imageSize({ packed, name, turned }: LoadedModel, index: number): Promise<PixelSize | null> {
  const image = imageBytes(packed.json, packed.binary, index, name);
  if (image === null) return null;
  try {
    const { width, height, orientation } = await readPictureHeader(image.bytes, image.name);
    if (orientation > 1) turned.add(index);
    return [width, height];
  } catch {
    // What is wrong with the picture is said when it is opened for painting; a model may be looked at without.
    return null;
  }
}

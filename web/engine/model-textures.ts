/** Which picture a material's base colour comes from, as the model's JSON says it (glTF 2.0, 3.8 and 3.9). */
import { indexAt, isObject, type JsonObject, listOf, objectAt, textAt } from "./gltf-json.ts";

/** Sampler filter NEAREST, GL's number. */
const NEAREST = 9728;

/** Extensions that name a texture's picture in place of `source`. */
export const WEBP_TEXTURE = "EXT_texture_webp";
export const BASISU_TEXTURE = "KHR_texture_basisu";
export const AVIF_TEXTURE = "EXT_texture_avif";
/** All extensions of that kind that are known here; DDS pictures cannot be decoded. */
export const TEXTURE_SOURCE_EXTENSIONS = [WEBP_TEXTURE, BASISU_TEXTURE, AVIF_TEXTURE, "MSFT_texture_dds"] as const;

export interface BaseTexture {
  readonly texture: number;
  /** Index into "images"; null when only a picture format that cannot be decoded is offered. */
  readonly image: number | null;
  /** The extension of such a format, "" otherwise. */
  readonly undecodable: string;
  /** The sampler magnifies with NEAREST: pixel art. */
  readonly nearest: boolean;
}

/** The base colour texture of a material; null without one (or with one that the file does not have). */
export function findBaseTexture(json: JsonObject, material: number, name: string): BaseTexture | null {
  const pbr = objectAt(listOf(json, "materials", name)[material], "pbrMetallicRoughness");
  const texture = indexAt(objectAt(pbr, "baseColorTexture"), "index");
  const definition = texture === undefined ? undefined : listOf(json, "textures", name)[texture];
  if (texture === undefined || definition === undefined) return null;
  const sampler = listOf(json, "samplers", name)[indexAt(definition, "sampler") ?? -1];
  const nearest = indexAt(sampler, "magFilter") === NEAREST;
  const extensions = objectAt(definition, "extensions");
  const image = imageOfTexture(definition);
  if (image !== undefined) return { texture, image, undecodable: "", nearest };
  const undecodable = TEXTURE_SOURCE_EXTENSIONS.find((extension) => isObject(extensions?.[extension]));
  return undecodable === undefined ? null : { texture, image: null, undecodable, nearest };
}

/** The image that a texture shows; undefined when only a picture format that cannot be decoded is offered. */
export function imageOfTexture(definition: JsonObject): number | undefined {
  const extensions = objectAt(definition, "extensions");
  // WebP before the plain source: viewers that know the extension show that one. AVIF after it: its decoder is large.
  return (
    indexAt(objectAt(extensions, WEBP_TEXTURE), "source") ??
    indexAt(definition, "source") ??
    indexAt(objectAt(extensions, AVIF_TEXTURE), "source")
  );
}

/** A picture of a model, with the name that errors show. */
export interface EncodedImage {
  readonly bytes: Uint8Array;
  readonly name: string;
}

/** Image `index` of a packed model; null when it has no bytes. */
export function imageBytes(
  json: JsonObject,
  binary: Uint8Array | null,
  index: number,
  name: string,
): EncodedImage | null {
  const image = listOf(json, "images", name)[index];
  const view = listOf(json, "bufferViews", name)[indexAt(image, "bufferView") ?? -1];
  const length = indexAt(view, "byteLength");
  if (binary === null || view === undefined || length === undefined) return null;
  const offset = indexAt(view, "byteOffset") ?? 0;
  const label = textAt(image, "name") || `images[${index}]`;
  return { bytes: binary.subarray(offset, offset + length), name: `${name}, ${label}` };
}

/** Where a material's textures lie: their UV set and KHR_texture_transform. */
import { turnBy } from "./exact-turn.ts";
import { indexAt, type JsonObject, listOf, objectAt } from "./gltf-json.ts";

export const TEXTURE_TRANSFORM = "KHR_texture_transform";

export interface TexturePlace {
  readonly texCoord: number;
  /** u and v as the picture is asked for them. */
  readonly apply: (u: number, v: number) => readonly [number, number];
}

/** Of a material that may have no texture, or be the implied one: then set 0 as it is. */
export function texturePlace(json: JsonObject, material: number, name: string): TexturePlace {
  const pbr = objectAt(listOf(json, "materials", name)[material], "pbrMetallicRoughness");
  return placeOfTexture(objectAt(pbr, "baseColorTexture"));
}

/** @param info what names the texture in a material; undefined: set 0 as it is */
export function placeOfTexture(info: JsonObject | undefined): TexturePlace {
  const transform = objectAt(objectAt(info, "extensions"), TEXTURE_TRANSFORM);
  const texCoord = indexAt(transform, "texCoord") ?? indexAt(info, "texCoord") ?? 0;
  if (transform === undefined) return { texCoord, apply: (u, v) => [u, v] };
  const { sin, cos } = turnBy(typeof transform.rotation === "number" ? transform.rotation : 0);
  const [scaleX, scaleY] = pairOf(transform.scale, 1);
  const [x, y] = pairOf(transform.offset, 0);
  return {
    texCoord,
    apply: (u, v) => [cos * scaleX * u + sin * scaleY * v + x, -sin * scaleX * u + cos * scaleY * v + y],
  };
}

function pairOf(value: unknown, otherwise: number): readonly [number, number] {
  const at = (i: number): number =>
    Array.isArray(value) && typeof value[i] === "number" ? (value[i] as number) : otherwise;
  return [at(0), at(1)];
}

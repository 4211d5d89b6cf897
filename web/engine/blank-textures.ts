/** Textures without a picture: their place still says which coordinates a material has, but not every reader takes them. */
import { indexAt, type JsonObject, listForWriting, listOf, objectAt } from "./gltf-json.ts";
import { AVIF_TEXTURE, BASISU_TEXTURE, WEBP_TEXTURE } from "./model-textures.ts";

/** One white pixel, which shows nothing. */
const BLANK =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4DwABAQEAHLCMmQAAAABJRU5ErkJggg==";

/** Gives textures that name no picture of a known format a blank one; `json` is changed. `name` is the file that errors name. */
export function fillTextures(json: JsonObject, name: string): void {
  const textures = listOf(json, "textures", name);
  const bare = new Set<unknown>([...textures.keys()].filter((index) => !hasPicture(textures[index])));
  if (bare.size === 0) return;
  const source = listForWriting(json, "images", name).push({ uri: BLANK }) - 1;
  for (const index of bare) Object.assign(textures[index as number] as JsonObject, { source });
  // As a direction, white would tilt the surface.
  for (const material of listOf(json, "materials", name))
    if (bare.has(objectAt(material, "normalTexture")?.index)) delete material.normalTexture;
}

function hasPicture(texture: JsonObject | undefined): boolean {
  const extensions = objectAt(texture, "extensions");
  const places = [texture, ...[AVIF_TEXTURE, BASISU_TEXTURE, WEBP_TEXTURE].map((key) => objectAt(extensions, key))];
  return places.some((place) => indexAt(place, "source") !== undefined);
}

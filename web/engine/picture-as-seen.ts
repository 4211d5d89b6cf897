/** A picture as its file asks for it to be shown: upright, and in sRGB. What a model's own textures are spared, as glTF asks. */
import { mentionsColors } from "./color-mention.ts";
import type { Picture } from "./engine-api.ts";
import { orientPixels } from "./orient-pixels.ts";
import type { PictureHeader } from "./picture-header.ts";

/**
 * @param rgba of the stored size; changed in place.
 * @param bytes the file.
 * Rejects with "bad-picture" naming the file for a profile that cannot be followed.
 */
export async function asSeen(
  rgba: Uint8Array<ArrayBuffer>,
  { format, width, height, orientation }: PictureHeader,
  bytes: Uint8Array,
  name: string,
): Promise<Picture> {
  if (mentionsColors(bytes)) await (await import("./picture-profile.ts")).toSrgb(rgba, format, bytes, name);
  return orientPixels(rgba, width, height, orientation);
}

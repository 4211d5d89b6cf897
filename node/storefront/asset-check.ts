/** What a file that arrives is, told by its content and never by what its sender says, and whether the shop takes it. */

import type { AssetType } from "../../web/editor/document/design.ts";
import { readFontHeader, sniffFont } from "../../web/engine/font-file.ts";
import { checkJpegScans } from "../../web/engine/jpeg-scans.ts";
import { readPictureHeader, sniffPicture } from "../../web/engine/picture-header.ts";
import { readSvgFile } from "../../web/engine/svg-file.ts";
import { cleanSvg } from "../../web/engine/svg-safety.ts";
import { isSvg } from "../../web/engine/svg-start.ts";
import { SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { shopError } from "./shop-error.ts";

/**
 * The media type of a picture, drawing or font, after its header was read in full: a file that passes can be printed.
 *
 * @throws TexelcastError "bad-picture", "bad-font"; "unsafe-file" for a drawing that would run something; "too-large" above `SHOP_LIMITS`.
 */
export async function checkAsset(bytes: Uint8Array, name: string): Promise<AssetType> {
  if (sniffFont(bytes) !== null) return `font/${readFontHeader(bytes, name).format}`;
  if (sniffPicture(bytes) === null && isSvg(bytes)) {
    await readSvgFile(bytes, name);
    // As the editor and the press: what they would not take is not kept either.
    cleanSvg(bytes, name);
    return "image/svg+xml";
  }
  const { format, width, height } = await readPictureHeader(bytes, name);
  if (format === "jpeg") checkJpegScans(bytes, name);
  if (width * height > SHOP_LIMITS.assetPixels) {
    throw shopError("too-large", `the picture has ${width} × ${height} pixels`, {
      subject: name,
      value: String(width * height),
      hint: `Make it smaller: ${SHOP_LIMITS.assetPixels} pixels are the most.`,
    });
  }
  return `image/${format}`;
}

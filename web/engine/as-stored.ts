/**
 * A model's pictures as glTF has them, for viewers too: browsers turn what they decode as EXIF says the camera was held, and the engine
 * lays a texture as it is stored. Nothing is moved: what holds the EXIF is made what readers pass over.
 */

import { asciiAt } from "./ascii-codes.ts";
import { viewOf } from "./byte-view.ts";
import { crc32 } from "./crc32.ts";
import { readContainer } from "./gltf-container.ts";
import { listOf } from "./gltf-json.ts";
import { imageBytes } from "./model-textures.ts";
import { sniffPicture } from "./picture-header.ts";

/** Changes a self-contained `glb` where it lies; it is as long as before. `name` is the file that errors name. */
export function layAsStored(glb: Uint8Array, name: string): void {
  const { json, binary } = readContainer({ name, bytes: glb });
  for (const index of listOf(json, "images", name).keys()) {
    const bytes = imageBytes(json, binary, index, name)?.bytes ?? new Uint8Array();
    const format = sniffPicture(bytes);
    try {
      if (format === "jpeg") hideInJpeg(bytes);
      if (format === "png") hideInPng(bytes);
      if (format === "webp") hideInWebp(bytes);
    } catch (fault) {
      // It ends too early, so no viewer shows it: what is wrong with it is said when it is opened for painting.
      if (!(fault instanceof RangeError)) throw fault;
    }
  }
}

const JPEG = { app1: 0xe1, scan: 0xda, comment: 0xfe } as const;

/** Up to the first scan (ITU-T T.81, annex B): the segment becomes a comment. */
function hideInJpeg(bytes: Uint8Array): void {
  const view = viewOf(bytes);
  for (let at = 2; view.getUint8(at) === 0xff; ) {
    const marker = view.getUint8(at + 1);
    if (marker === JPEG.scan) return;
    if (marker === JPEG.app1 && asciiAt(bytes, at + 4, 6) === "Exif\0\0") view.setUint8(at + 1, JPEG.comment);
    // A fill byte before a marker is none itself.
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
}

/** The chunk gets a private name (PNG 3rd edition, 5.4), and the checksum that goes with it. */
function hideInPng(bytes: Uint8Array): void {
  const view = viewOf(bytes);
  for (let at = 8; at < bytes.length; ) {
    const length = view.getUint32(at);
    const end = at + 8 + length;
    if (asciiAt(bytes, at + 4, 4) === "eXIf") {
      view.setUint8(at + 5, "x".charCodeAt(0));
      view.setUint32(end, crc32(bytes.subarray(at + 4, end)));
    }
    at = end + 4;
  }
}

/** RFC 9649, 2.7: readers pass over chunks that they do not know; the header no longer says that there is EXIF. */
function hideInWebp(bytes: Uint8Array): void {
  const view = viewOf(bytes);
  for (let at = 12; at < bytes.length; ) {
    const type = asciiAt(bytes, at, 4);
    const length = view.getUint32(at + 4, true);
    if (type === "VP8X") view.setUint8(at + 8, view.getUint8(at + 8) & ~0x08);
    if (type === "EXIF") view.setUint8(at, "e".charCodeAt(0));
    at += 8 + length + (length & 1);
  }
}

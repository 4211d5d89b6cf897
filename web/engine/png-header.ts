/** PNG's header and its chunks (PNG 3rd edition, 5): size, wholeness, checksums. */
import { crc32 } from "./crc32.ts";
import { readExifOrientation } from "./exif-orientation.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";

/**
 * Walks all chunks to the end. The checksums are compared here because the decoder does not: it would give a damaged
 * file's pixels without a word.
 */
export function readPngHeader(bytes: Uint8Array): RawHeader {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let orientation = 1;
  let hasData = false;
  for (let at = 8; ; ) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (at === 8 && (type !== "IHDR" || length !== 13)) throw new PictureFault("damaged", "its PNG header is missing");
    const data = bytes.subarray(at + 8, at + 8 + length);
    const stored = view.getUint32(at + 8 + length);
    // Critical chunks have a capital first letter; a damaged comment harms nobody.
    if (type < "a" && crc32(bytes.subarray(at + 4, at + 8 + length)) !== stored) {
      throw new PictureFault(
        "damaged",
        `its ${type} data is damaged (the checksum differs)`,
        "Copy or download it again.",
      );
    }
    if (type === "IDAT") hasData = true;
    if (type === "eXIf") orientation = readExifOrientation(data);
    if (type === "IEND") break;
    at += 12 + length;
  }
  if (!hasData) throw new PictureFault("no-pixels", "it holds no pixels");
  return { width: view.getUint32(16), height: view.getUint32(20), orientation };
}

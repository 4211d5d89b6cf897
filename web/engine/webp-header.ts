/** WebP's container (RFC 9649, 2): size, EXIF, and whether it is a still picture. */
import { readExifOrientation } from "./exif-orientation.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";

const VP8X_ANIMATED = 0x02;

/** Throws a PictureFault where the picture cannot be used, a RangeError where the file ends too early. */
export function readWebpHeader(bytes: Uint8Array): RawHeader {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = 8 + view.getUint32(4, true);
  if (end > bytes.length) throw new PictureFault("cut-short", "it was cut short", "Copy or download it again.");
  let size: { width: number; height: number } | null = null;
  let orientation = 1;
  for (let at = 12; at + 8 <= end; ) {
    const type = String.fromCharCode(...bytes.subarray(at, at + 4));
    const length = view.getUint32(at + 4, true);
    if (length > end - at - 8) throw new PictureFault("cut-short", "it was cut short", "Copy or download it again.");
    if (type === "VP8X" && (view.getUint8(at + 8) & VP8X_ANIMATED) !== 0) {
      throw new PictureFault("animated", "it is animated", "Save one frame of it as a still picture.");
    }
    if (type === "VP8 ") size = readLossy(view, at + 8);
    if (type === "VP8L") size = readLossless(view, at + 8);
    if (type === "EXIF") orientation = readExifOrientation(withoutExifMark(bytes.subarray(at + 8, at + 8 + length)));
    at += 8 + length + (length & 1);
  }
  if (size === null) throw new PictureFault("no-pixels", "it holds no pixels");
  return { ...size, orientation };
}

/** RFC 6386, 9.1: a key frame's start code, then 14 bits each. */
function readLossy(view: DataView, at: number): { width: number; height: number } {
  if (view.getUint8(at + 3) !== 0x9d || view.getUint8(at + 4) !== 0x01 || view.getUint8(at + 5) !== 0x2a) {
    throw new PictureFault("damaged", "its WebP frame is damaged");
  }
  return { width: view.getUint16(at + 6, true) & 0x3fff, height: view.getUint16(at + 8, true) & 0x3fff };
}

/** RFC 9649, 3.4: the signature, then 14 bits each, less one. */
function readLossless(view: DataView, at: number): { width: number; height: number } {
  if (view.getUint8(at) !== 0x2f) throw new PictureFault("damaged", "its WebP frame is damaged");
  const bits = view.getUint32(at + 1, true);
  return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
}

/** Some writers put JPEG's "Exif\0\0" in front of the TIFF block. */
function withoutExifMark(block: Uint8Array): Uint8Array {
  return String.fromCharCode(...block.subarray(0, 6)) === "Exif\0\0" ? block.subarray(6) : block;
}

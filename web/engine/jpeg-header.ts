/** JPEG's marker segments up to the first scan (ITU-T T.81, annex B): size, colour channels, EXIF. */
import { readExifOrientation } from "./exif-orientation.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";

const START_OF_SCAN = 0xda;
const END_OF_IMAGE = 0xd9;
const APP1 = 0xe1;

/** Throws a PictureFault where the picture cannot be used, a RangeError where the file ends too early. */
export function readJpegHeader(bytes: Uint8Array): RawHeader {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let size: { width: number; height: number } | null = null;
  let orientation = 1;
  for (let at = 2; ; ) {
    if (view.getUint8(at) !== 0xff) throw new PictureFault("damaged", "its JPEG segments are damaged");
    const marker = view.getUint8(at + 1);
    if (marker === 0xff) {
      at++; // A fill byte before a marker.
      continue;
    }
    if (marker === END_OF_IMAGE) throw new PictureFault("no-pixels", "it holds no pixels");
    const length = view.getUint16(at + 2);
    if (length < 2) throw new PictureFault("damaged", "its JPEG segments are damaged");
    const segment = bytes.subarray(at + 4, at + 2 + length);
    if (isStartOfFrame(marker)) size = readFrame(view, at + 4, marker);
    if (marker === APP1 && String.fromCharCode(...segment.subarray(0, 6)) === "Exif\0\0") {
      orientation = readExifOrientation(segment.subarray(6));
    }
    at += 2 + length;
    if (marker === START_OF_SCAN) {
      if (size === null) throw new PictureFault("damaged", "its size is missing");
      // Inside a scan every 0xff is stuffed, so the end marker cannot occur by chance. Without it the decoder
      // would fill the missing part with grey.
      if (!hasEnd(bytes, at)) throw new PictureFault("cut-short", "it was cut short", "Copy or download it again.");
      return { ...size, orientation };
    }
  }
}

/** SOF0 to SOF15 without the tables that lie between them (DHT, JPG, DAC), and SOF55, of JPEG-LS. */
function isStartOfFrame(marker: number): boolean {
  return (marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc) || marker === 0xf7;
}

/** Beyond these, frames are without losses, one upon the other, or coded arithmetically, which the decoder takes for damage. */
const SOF2 = 0xc2;

function readFrame(view: DataView, at: number, marker: number): { width: number; height: number } {
  if (marker > SOF2) {
    const kind = marker === 0xc9 || marker === 0xca ? "of arithmetic coding" : "without losses or in layers";
    throw new PictureFault("jpeg-kind", `it is a JPEG ${kind}, which cannot be read`);
  }
  const precision = view.getUint8(at);
  const channels = view.getUint8(at + 5);
  if (precision !== 8) throw new PictureFault("bits", `its colours have ${precision} bits, and only 8 can be read`);
  if (channels === 4)
    throw new PictureFault("cmyk", "its colours are CMYK, made for printing presses", "Save it in RGB colours.");
  if (channels !== 1 && channels !== 3) throw new PictureFault("channels", `it has ${channels} colour channels`);
  return { height: view.getUint16(at + 1), width: view.getUint16(at + 3) };
}

function hasEnd(bytes: Uint8Array, from: number): boolean {
  for (let at = bytes.indexOf(0xff, from); at >= 0; at = bytes.indexOf(0xff, at + 1)) {
    if (bytes[at + 1] === END_OF_IMAGE) return true;
  }
  return false;
}

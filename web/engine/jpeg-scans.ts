/** How often a JPEG goes over its picture (ITU-T T.81, annex G): what its header does not tell. */
import { badPicture } from "./picture-header.ts";

const START_OF_SCAN = 0xda;
const END_OF_IMAGE = 0xd9;
/** Real ones have about ten. Each goes over the whole picture, however few bytes it has: a megabyte of them takes minutes. */
const MOST_SCANS = 100;

/** Throws "bad-picture" naming the file where there are more scans than any real one has. */
export function checkJpegScans(bytes: Uint8Array, name: string): void {
  let scans = 0;
  for (let at = bytes.indexOf(0xff, 2); at >= 0 && at + 4 <= bytes.length; at = bytes.indexOf(0xff, at)) {
    const [, marker = 0, high = 0, low = 0] = bytes.subarray(at, at + 4);
    if (marker === END_OF_IMAGE) return;
    if (marker === START_OF_SCAN) scans++;
    if (scans > MOST_SCANS) {
      throw badPicture(name, "scans", `it has more than ${MOST_SCANS} scans`, "Save it again, as JPEG or PNG.");
    }
    at += hasSegment(marker) ? 2 + high * 256 + low : 1;
  }
}

/** Not within a scan's data: stuffed and fill bytes, TEM, RST0 to RST7. */
function hasSegment(marker: number): boolean {
  return marker > 0x01 && marker < 0xff && !(marker >= 0xd0 && marker <= 0xd7);
}

/** A PNG file with what shows alone (picture-metadata.ts). */
import { orientationBlock } from "./exif-block.ts";
import { joinBytes } from "./join-bytes.ts";
import type { KeptMetadata } from "./picture-metadata.ts";
import { pngChunk } from "./png-chunk.ts";

/** What the pixels need; an animation (acTL, fcTL, fdAT) loses all but its first picture, which is what is painted. */
const PNG_CHUNKS: ReadonlySet<string> = new Set(["IHDR", "PLTE", "tRNS", "IDAT", "IEND"]);

/** By default what the pixels need alone. */
export function cleanPng(
  bytes: Uint8Array,
  { orientation, colors }: KeptMetadata = { orientation: 1, colors: null },
): Uint8Array<ArrayBuffer> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts: Uint8Array[] = [bytes.subarray(0, 8)];
  for (let at = 8; ; ) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (PNG_CHUNKS.has(type)) parts.push(bytes.subarray(at, at + 12 + length));
    if (type === "IHDR" && colors !== null) parts.push(colors);
    if (type === "IHDR" && orientation !== 1) parts.push(pngChunk("eXIf", orientationBlock(orientation)));
    if (type === "IEND") return joinBytes(parts);
    at += 12 + length;
  }
}

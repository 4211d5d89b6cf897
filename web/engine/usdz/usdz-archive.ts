/** A USDZ package: a zip of stored files, each of which begins at a multiple of 64 bytes (openusd.org, "USDZ File Format"). */
import { type Zippable, zipSync } from "fflate";
import { zipDay } from "../zip-day.ts";

export interface PackedFile {
  readonly path: string;
  readonly bytes: Uint8Array;
}

const ALIGNMENT = 64;
/** Of a file's own header in a zip, and of an extra field's. */
const HEADER = 30;
const FIELD_HEADER = 4;
/** Nobody's: what fills the space up to a file's beginning says nothing. */
const FILLING = 0x1986;

/** The first is the layer that viewers open. Paths are ASCII. */
export function packUsdz(files: readonly PackedFile[]): Uint8Array<ArrayBuffer> {
  const entries: Zippable = {};
  const mtime = zipDay();
  let at = 0;
  for (const { path, bytes } of files) {
    const first = at + HEADER + path.length + FIELD_HEADER;
    const filling = (ALIGNMENT - (first % ALIGNMENT)) % ALIGNMENT;
    entries[path] = [bytes, { level: 0, mtime, extra: { [FILLING]: new Uint8Array(filling) } }];
    at = first + filling + bytes.length;
  }
  return zipSync(entries) as Uint8Array<ArrayBuffer>;
}

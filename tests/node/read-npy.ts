/** NumPy array files, read by the book: what the tests of `bake` hold its output against. */
import { readFileSync } from "node:fs";

export interface NpyArray {
  readonly descr: string;
  readonly shape: readonly number[];
  /** Where the values begin. */
  readonly headerBytes: number;
  readonly values: Float32Array | Uint8Array;
}

export function readNpy(file: string): NpyArray {
  const bytes = readFileSync(file);
  if (bytes.subarray(0, 8).toString("latin1") !== "\x93NUMPY\x01\x00") throw new Error(`${file}: not .npy 1.0`);
  const headerBytes = 10 + bytes.readUInt16LE(8);
  const header = bytes.subarray(10, headerBytes).toString("latin1");
  const match = /^\{'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]+)\), \} *\n$/.exec(header);
  if (match === null) throw new Error(`${file}: header not understood: ${header}`);
  const descr = match[1] as string;
  const shape = (match[2] as string).split(",").map(Number);
  // Copied: a view of floats must begin at a multiple of four bytes of its buffer.
  const data = new Uint8Array(bytes.subarray(headerBytes));
  const values = descr === "<f4" ? new Float32Array(data.buffer) : data;
  const count = shape.reduce((product, size) => product * size, 1);
  if (values.length !== count) throw new Error(`${file}: ${values.length} values for ${count}`);
  return { descr, shape, headerBytes, values };
}

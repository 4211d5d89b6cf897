/** The PNG codec of @jsquash (Rust's `png`), started once, by the decoder and the encoder alike. */
import startPng, { decode } from "@jsquash/png/codec/pkg/squoosh_png.js";
import { compileCodec } from "./codec-wasm.ts";

/** What of the codec's exports is used here. */
export interface PngExports {
  __wbindgen_add_to_stack_pointer(bytes: number): number;
}

let started: Promise<PngExports> | null = null;

/** The codec, ready for `@jsquash/png`'s own functions. Rejects with "missing-file"; a later call tries again. */
export function pngCodec(): Promise<PngExports> {
  started ??= start().catch((error: unknown) => {
    started = null;
    throw error;
  });
  return started;
}

async function start(): Promise<PngExports> {
  // The codec hands its pixels over as ImageData, which Node does not have.
  if (typeof ImageData === "undefined") Object.assign(globalThis, { ImageData: PixelRecord });
  return (await startPng(await compileCodec("png"))) as unknown as PngExports;
}

class PixelRecord {
  readonly data: Uint8ClampedArray;
  readonly width: number;
  readonly height: number;

  constructor(data: Uint8ClampedArray, width: number, height: number) {
    this.data = data;
    this.width = width;
    this.height = height;
  }
}

/** Where the header says how many bits a channel has (PNG 3rd edition, 11.2.1). */
const BIT_DEPTH = 24;

/** Rejects with "missing-file", and with what the codec says of bytes that it cannot read. */
export async function decodePng(bytes: Uint8Array): Promise<Pick<ImageData, "data">> {
  const codec = await pngCodec();
  const isDeep = bytes[BIT_DEPTH] === 16;
  try {
    if (!isDeep) return keepStack(codec, () => decode(bytes));
  } catch {
    // It minds faults of texts and the like, at which no viewer looks: once more without them.
  }
  return (await import("./special-png.ts")).decodeSpecialPng(codec, bytes, isDeep);
}

/**
 * Runs a call that may throw out of the codec. Rust's panic leaves the codec's stack where it was; without putting it
 * back, some hundreds of broken pictures would use the stack up and every later one would fail.
 */
export function keepStack<Result>(codec: PngExports, run: () => Result): Result {
  const before = codec.__wbindgen_add_to_stack_pointer(0);
  try {
    return run();
  } catch (error) {
    codec.__wbindgen_add_to_stack_pointer(before - codec.__wbindgen_add_to_stack_pointer(0));
    throw error;
  }
}

/** A GLB's BIN chunk under change: bytes are put behind it, and old ones taken out. */
import { padded } from "./gltf-container.ts";
import { type JsonObject, listForWriting } from "./gltf-json.ts";

export class GrowingBinary {
  #old: Uint8Array;
  readonly #added: { readonly offset: number; readonly bytes: Uint8Array }[] = [];
  #length: number;

  /** `binary` is only read; null is a file without that chunk. */
  constructor(binary: Uint8Array | null) {
    this.#old = binary ?? new Uint8Array();
    this.#length = this.#old.length;
  }

  /** What is left of the bytes that it began with. */
  get old(): Uint8Array {
    return this.#old;
  }

  /** Bytes, with those that were added. */
  get length(): number {
    return this.#length;
  }

  /** Puts bytes behind all others, and returns the offset where they begin: a multiple of `alignment`. */
  append(bytes: Uint8Array, alignment: number): number {
    const offset = padded(this.#length, alignment);
    this.#added.push({ offset, bytes });
    this.#length = offset + bytes.length;
    return offset;
  }

  /** Takes `length` old bytes out; what lies behind them moves up by as many. */
  cut(start: number, length: number): void {
    const kept = new Uint8Array(this.#old.length - length);
    kept.set(this.#old.subarray(0, start));
    kept.set(this.#old.subarray(start + length), start);
    this.#old = kept;
    this.#length -= length;
    for (const [i, { offset, bytes }] of this.#added.entries()) this.#added[i] = { offset: offset - length, bytes };
  }

  /** All of it in one, and `json` with its length in "buffers"; `name` is the file that errors name. */
  finish(json: JsonObject, name: string): Uint8Array {
    const joined = new Uint8Array(padded(this.#length));
    joined.set(this.#old);
    for (const { offset, bytes } of this.#added) joined.set(bytes, offset);
    const buffers = listForWriting(json, "buffers", name);
    buffers[0] = { ...buffers[0], byteLength: this.#length };
    return joined;
  }
}

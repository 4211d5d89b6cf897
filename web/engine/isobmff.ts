/** Boxes of an ISO base media file (ISO/IEC 14496-12, 4.2), which AVIF is made of. */

/** Reads numbers one behind the other, and no further than its box: a RangeError tells of one that ends too early. */
export class BoxReader {
  readonly bytes: Uint8Array;
  readonly #view: DataView;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get left(): number {
    return this.bytes.length - this.#at;
  }

  /** A number of so many bytes, 0 to 8, the high ones first. */
  uint(size: number): number {
    let value = 0;
    for (let i = 0; i < size; i++) value = value * 256 + this.#view.getUint8(this.#at++);
    return value;
  }

  /** A number of 32 bits with its sign. */
  int32(): number {
    return this.uint(4) | 0;
  }

  /** Four characters, of types and brands. */
  type(): string {
    return String.fromCharCode(...this.take(4));
  }

  take(length: number): Uint8Array {
    if (length > this.left) throw new RangeError("The box ends too early.");
    this.#at += length;
    return this.bytes.subarray(this.#at - length, this.#at);
  }
}

export interface Box {
  readonly type: string;
  /** Without the head. */
  readonly content: Uint8Array;
  readonly whole: Uint8Array;
}

/** The boxes that follow one another. Throws a RangeError at one that ends too early. */
export function* boxesIn(bytes: Uint8Array): Generator<Box> {
  for (let at = 0; at < bytes.length; ) {
    const reader = new BoxReader(bytes.subarray(at));
    const small = reader.uint(4);
    const type = reader.type();
    const length = small === 1 ? reader.uint(8) : small === 0 ? bytes.length - at : small;
    const head = bytes.length - at - reader.left;
    if (length < head || length > bytes.length - at) throw new RangeError(`The box “${type}” does not fit.`);
    const whole = bytes.subarray(at, at + length);
    yield { type, content: whole.subarray(head), whole };
    at += length;
  }
}

/** A full box's version and what follows its flags. */
export function versioned(content: Uint8Array): { version: number; flags: number; reader: BoxReader } {
  const reader = new BoxReader(content);
  const version = reader.uint(1);
  return { version, flags: reader.uint(3), reader };
}

/** How many frames a piece of AV1 has, and how large they may be: what decoding it takes (AV1 bitstream specification, 5.3 to 5.5). */

export interface Av1Frames {
  readonly frames: number;
  /** The largest that a sequence header of it allows; 0 without one. */
  readonly width: number;
  readonly height: number;
}

const OBU = { sequenceHeader: 1, frameHeader: 3, frame: 6 } as const;

/** Throws a RangeError where the data ends too early. */
export function av1Frames(data: Uint8Array): Av1Frames {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  let [frames, width, height] = [0, 0, 0];
  for (let at = 0; at < data.length; ) {
    const head = view.getUint8(at);
    const type = (head >> 3) & 15;
    at += head & 4 ? 2 : 1;
    let length = data.length - at;
    if (head & 2) [length, at] = leb128(view, at);
    if (length > data.length - at) throw new RangeError("The unit is longer than its data.");
    if (type === OBU.frame || type === OBU.frameHeader) frames++;
    if (type === OBU.sequenceHeader) {
      const size = sequenceSize(data.subarray(at, at + length));
      width = Math.max(width, size.width);
      height = Math.max(height, size.height);
    }
    at += length;
  }
  return { frames, width, height };
}

/** Seven bits a byte, the low ones first. */
function leb128(view: DataView, from: number): [value: number, after: number] {
  let value = 0;
  for (let i = 0; i < 8; i++) {
    const byte = view.getUint8(from + i);
    value += (byte & 0x7f) * 2 ** (7 * i);
    if (byte < 0x80) return [value, from + i + 1];
  }
  throw new RangeError("The length has no end.");
}

/** Of `sequence_header_obu()`, as far as the size. */
function sequenceSize(data: Uint8Array): { width: number; height: number } {
  const bits = new Bits(data);
  bits.take(4); // Profile and still_picture.
  if (bits.take(1)) bits.take(5);
  else skipOperatingPoints(bits);
  const [wide, high] = [bits.take(4) + 1, bits.take(4) + 1];
  return { width: bits.take(wide) + 1, height: bits.take(high) + 1 };
}

function skipOperatingPoints(bits: Bits): void {
  let delayBits = 0;
  if (bits.take(1)) {
    bits.take(32);
    bits.take(32);
    if (bits.take(1)) bits.skipUvlc();
    if (bits.take(1)) {
      delayBits = bits.take(5) + 1;
      bits.take(32);
      bits.take(10);
    }
  }
  const hasDisplayDelay = bits.take(1);
  const points = bits.take(5) + 1;
  for (let i = 0; i < points; i++) {
    bits.take(12);
    if (bits.take(5) > 7) bits.take(1);
    if (delayBits > 0 && bits.take(1)) {
      bits.take(delayBits);
      bits.take(delayBits);
      bits.take(1);
    }
    if (hasDisplayDelay && bits.take(1)) bits.take(4);
  }
}

class Bits {
  readonly #data: Uint8Array;
  #at = 0;

  constructor(data: Uint8Array) {
    this.#data = data;
  }

  /** The highest bit first. */
  take(count: number): number {
    let value = 0;
    for (let i = 0; i < count; i++, this.#at++) {
      const byte = this.#data[this.#at >> 3];
      if (byte === undefined) throw new RangeError("The sequence header ends too early.");
      value = value * 2 + ((byte >> (7 - (this.#at & 7))) & 1);
    }
    return value;
  }

  skipUvlc(): void {
    let zeros = 0;
    while (!this.take(1)) zeros++;
    if (zeros < 32) this.take(zeros);
  }
}

/** A grey progressive JPEG of as many scans as one wishes (ITU-T T.81, annex G): the first says black, the others nothing. */

/** A run of blocks without coefficients: its length's lower bits, after the code. */
const EOB14 = 0xe0;
const MOST_BLOCKS = 2 ** 15 - 1;

/** @param side of the square, at most 65535 pixels */
export function jpegOfScans(side: number, scans: number): Uint8Array<ArrayBuffer> {
  const blocks = Math.ceil(side / 8) ** 2;
  const oneCode = (table: number, symbol: number): number[] =>
    segment(0xc4, [table, 1, ...Array<number>(15).fill(0), symbol]);
  const runs = Math.ceil(blocks / MOST_BLOCKS);
  const empty = [...segment(0xda, [1, 1, 0, 1, 63, 0]), ...packed(`0${"1".repeat(14)}`.repeat(runs))];
  const first = [...segment(0xda, [1, 1, 0, 0, 0, 0]), ...packed("0".repeat(blocks))];
  const [high, low] = [side >> 8, side & 255];
  return Uint8Array.from([
    ...[0xff, 0xd8],
    ...segment(0xdb, [0, ...Array<number>(64).fill(1)]),
    ...segment(0xc2, [8, high, low, high, low, 1, 1, 0x11, 0]),
    ...oneCode(0x00, 0),
    ...oneCode(0x10, EOB14),
    ...first,
    ...Array.from({ length: scans - 1 }, () => empty).flat(),
    ...[0xff, 0xd9],
  ]);
}

const segment = (marker: number, data: readonly number[]): number[] => {
  const length = data.length + 2;
  return [0xff, marker, length >> 8, length & 255, ...data];
};

/** Bits as bytes, filled up with ones; 0xff is stuffed. */
function packed(bits: string): number[] {
  const whole = bits.padEnd(Math.ceil(bits.length / 8) * 8, "1");
  return (whole.match(/.{8}/g) ?? []).flatMap((byte) => (byte === "11111111" ? [255, 0] : [Number.parseInt(byte, 2)]));
}

/** A zlib stream (RFC 1950) that stores its data as it is: browsers and Node compress each in a way of its own. */

/** A block's length has 16 bits. */
const MOST_OF_BLOCK = 0xffff;

export function storedZlib(data: Uint8Array): Uint8Array {
  const blocks = Math.max(Math.ceil(data.length / MOST_OF_BLOCK), 1);
  const stream = new Uint8Array(2 + 5 * blocks + data.length + 4);
  const view = new DataView(stream.buffer);
  view.setUint16(0, 0x7801);
  let at = 2;
  for (let i = 0; i < blocks; i++) {
    const block = data.subarray(i * MOST_OF_BLOCK, (i + 1) * MOST_OF_BLOCK);
    stream[at] = i === blocks - 1 ? 1 : 0;
    view.setUint16(at + 1, block.length, true);
    view.setUint16(at + 3, ~block.length, true);
    stream.set(block, at + 5);
    at += 5 + block.length;
  }
  view.setUint32(at, adler32(data));
  return stream;
}

function adler32(data: Uint8Array): number {
  let [low, high] = [1, 0];
  for (const byte of data) {
    low = (low + byte) % 65521;
    high = (high + low) % 65521;
  }
  return high * 65536 + low;
}

/** NumPy's array files, version 1.0 (numpy.lib.format): a header of text, then the values, C order, little-endian. */

export type NpyType = "float32" | "uint8";

const DESCRIPTORS: Readonly<Record<NpyType, string>> = { float32: "<f4", uint8: "|u1" };

/** The header is padded so that the values begin at a multiple of this, which lets them be mapped into memory. */
const ALIGNMENT = 64;

/** What comes before the values of an array of that shape, slowest axis first; its length is a multiple of 64 bytes. */
export function npyHeader(type: NpyType, shape: readonly number[]): Uint8Array {
  const sizes = shape.length === 1 ? `${shape[0]},` : shape.join(", ");
  const description = `{'descr': '${DESCRIPTORS[type]}', 'fortran_order': False, 'shape': (${sizes}), }`;
  const preamble = 10;
  const length = Math.ceil((preamble + description.length + 1) / ALIGNMENT) * ALIGNMENT;
  const header = new Uint8Array(length).fill(0x20);
  header.set([0x93, ...new TextEncoder().encode("NUMPY"), 1, 0]);
  new DataView(header.buffer).setUint16(8, length - preamble, true);
  header.set(new TextEncoder().encode(description), preamble);
  header[length - 1] = 0x0a;
  return header;
}

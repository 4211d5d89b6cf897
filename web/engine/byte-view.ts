/** Bytes as a view for reading numbers, of just those, as their buffer may be longer. */
export const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

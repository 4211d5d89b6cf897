/** A text's characters as bytes, where all are of ASCII: the names of chunks and tags. */
export const asciiCodes = (text: string): Uint8Array => Uint8Array.from(text, (character) => character.charCodeAt(0));

/** The other way round: so many bytes as the characters that they stand for. */
export const asciiAt = (bytes: Uint8Array, at: number, length: number): string =>
  String.fromCharCode(...bytes.subarray(at, at + length));

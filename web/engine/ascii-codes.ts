/** A text's characters as bytes, where all are of ASCII: the names of chunks and tags. */
export const asciiCodes = (text: string): Uint8Array => Uint8Array.from(text, (character) => character.charCodeAt(0));

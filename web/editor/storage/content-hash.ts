/** Names for bytes: the same bytes have one name, so that they are stored once. */

/** SHA-256 as 64 hex digits. */
export async function contentHash(bytes: Uint8Array): Promise<string> {
  // The browser's own is several times as fast, but a page that came by plain http from another machine has none.
  const subtle = globalThis.crypto?.subtle;
  if (!subtle) return bytesToHex((await import("@noble/hashes/sha2.js")).sha256(bytes));
  return bytesToHex(new Uint8Array(await subtle.digest("SHA-256", bytes as Uint8Array<ArrayBuffer>)));
}

/** A new name that nothing else has: 32 hex digits. */
export function randomId(): string {
  return bytesToHex(crypto.getRandomValues(new Uint8Array(16)));
}

const bytesToHex = (bytes: Uint8Array): string =>
  Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");

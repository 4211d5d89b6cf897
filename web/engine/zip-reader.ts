/**
 * Reads zip archives that come from strangers. The directory is checked as a whole before anything is inflated: names that
 * lead out of the archive or stand twice, sizes that lie or that no honest archive has. (APPNOTE 6.3.3, without encryption,
 * several disks and 64-bit sizes.)
 */

import { Inflate } from "fflate";
import { TexelcastError } from "../core/texelcast-error.ts";
import { viewOf } from "./byte-view.ts";
import { crc32 } from "./crc32.ts";

export interface ZipEntry {
  /** Relative, with "/"; never "..", never twice in an archive. */
  readonly name: string;
  /** Inflated bytes, as the archive says; `read` holds it to that. */
  readonly size: number;
  readonly compressedSize: number;
  readonly method: number;
  readonly crc: number;
  readonly offset: number;
  /** It stands for another file, by whose path Unix took it for one. */
  readonly isLink: boolean;
}

export interface ZipLimits {
  readonly entries: number;
  /** Inflated bytes of all entries together. */
  readonly totalSize: number;
}

export const ZIP_LIMITS: ZipLimits = { entries: 20_000, totalSize: 2 ** 31 - 1 };

/** What is said of an archive that is refused. */
export interface ZipTerms {
  readonly code: string;
  readonly hint: string;
}

const END_SIGNATURE = 0x06054b50;
const DIRECTORY_SIGNATURE = 0x02014b50;
const LOCAL_SIGNATURE = 0x04034b50;
const STORED = 0;
const DEFLATED = 8;
/** Deflate's best is 1032 to 1. */
const MOST_RATIO = 1032;
/** Names that are not said to be UTF-8, and are none, are in the PC's old letters (APPNOTE, D.1): from 128 on. */
const OLD_LETTERS =
  "ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜ¢£¥₧ƒáíóúñÑªº¿⌐¬½¼¡«»░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀αßΓπΣσµτΦΘΩδ∞φε∩≡±≥≤⌠⌡÷≈°∙·√ⁿ²■\u00a0";
const UTF8_NAME = 1 << 11;
const MADE_ON_UNIX = 3;
/** The upper four bits of a file's mode. */
const LINK_TYPE = 0o12;
/** Compressed bytes fed at once: what a lying entry can inflate to beyond its size is at most 1032 times this. */
const PIECE = 1 << 15;

/** `message` reads on from the entry's name where there is one. */
type Refuse = (message: string, entry?: string, value?: string, cause?: unknown) => TexelcastError;

export class ZipReader {
  readonly name: string;
  readonly entries: ReadonlyMap<string, ZipEntry>;
  readonly #bytes: Uint8Array;
  readonly #refuse: Refuse;

  /** @throws TexelcastError as `terms` says, that names the archive and the entry at fault. */
  constructor(bytes: Uint8Array, name: string, terms: ZipTerms) {
    this.#bytes = bytes;
    this.#refuse = (message, entry, value, cause) => zipError(terms, name, message, entry, value, cause);
    this.name = name;
    this.entries = readDirectory(bytes, this.#refuse, ZIP_LIMITS);
  }

  /**
   * An entry's bytes; undefined for one that is not there.
   *
   * @throws TexelcastError for one above `maxSize` (before it is inflated), broken, or longer than it says.
   */
  read(entryName: string, maxSize: number): Uint8Array | undefined {
    const entry = this.entries.get(entryName);
    if (entry === undefined) return undefined;
    const refuse: Refuse = (message, _, value, cause) => this.#refuse(message, entryName, value, cause);
    if (entry.isLink) throw refuse("is a link to another file, and links are not followed");
    if (entry.size > maxSize) {
      throw refuse(`inflates to ${entry.size} bytes, the limit there is ${maxSize}`, entryName, `${entry.size} bytes`);
    }
    const packed = this.#packed(entry);
    const bytes = entry.method === STORED ? packed.slice() : inflate(packed, entry.size, refuse);
    if (bytes.length !== entry.size) throw refuse(`has ${bytes.length} bytes, but the archive says ${entry.size}`);
    if (crc32(bytes) !== entry.crc) throw refuse("is damaged: its checksum does not match");
    return bytes;
  }

  #packed(entry: ZipEntry): Uint8Array {
    const refuse: Refuse = (message) => this.#refuse(message, entry.name);
    const { offset, compressedSize } = entry;
    const view = viewOf(this.#bytes);
    if (offset + 30 > view.byteLength || view.getUint32(offset, true) !== LOCAL_SIGNATURE) {
      throw refuse("is not where the archive says");
    }
    const start = offset + 30 + view.getUint16(offset + 26, true) + view.getUint16(offset + 28, true);
    if (start + compressedSize > view.byteLength) throw refuse("is cut off");
    return this.#bytes.subarray(start, start + compressedSize);
  }
}

function readDirectory(bytes: Uint8Array, refuse: Refuse, limits: ZipLimits): Map<string, ZipEntry> {
  const view = viewOf(bytes);
  const end = findEnd(view, refuse);
  const count = view.getUint16(end + 10, true);
  const split = view.getUint16(end + 4, true) !== 0 || view.getUint16(end + 8, true) !== count;
  if (split || count === 0xffff) throw refuse("the archive is split or too large for this page");
  if (count > limits.entries) {
    throw refuse(`the archive has ${count} entries, the limit is ${limits.entries}`);
  }
  const entries = new Map<string, ZipEntry>();
  const names = new Set<string>();
  let at = view.getUint32(end + 16, true);
  let packed = 0;
  let total = 0;
  for (let index = 0; index < count; index++) {
    if (at + 46 > end || view.getUint32(at, true) !== DIRECTORY_SIGNATURE) {
      throw refuse("the archive's directory is broken");
    }
    const next =
      at + 46 + view.getUint16(at + 28, true) + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    if (next > end) throw refuse("the archive's directory is broken");
    const entry = readEntry(bytes, view, at, refuse);
    at = next;
    checkName(entry.name, names, refuse);
    checkSizes(entry, refuse);
    packed += entry.compressedSize;
    total += entry.size;
    // Entries that share their bytes make a small archive inflate without end.
    if (packed > bytes.length) throw refuse("shares its bytes with other entries", entry.name);
    if (total > limits.totalSize) {
      const message = `makes the archive inflate to more than ${limits.totalSize} bytes`;
      throw refuse(message, entry.name, `${entry.size} bytes`);
    }
    if (!entry.name.endsWith("/")) entries.set(entry.name, entry);
  }
  return entries;
}

function findEnd(view: DataView, refuse: Refuse): number {
  const first = Math.max(0, view.byteLength - 22 - 0xffff);
  for (let at = view.byteLength - 22; at >= first; at--) {
    if (view.getUint32(at, true) === END_SIGNATURE) return at;
  }
  throw refuse("this is no zip archive, or it is cut off");
}

function readEntry(bytes: Uint8Array, view: DataView, at: number, refuse: Refuse): ZipEntry {
  const nameLength = view.getUint16(at + 28, true);
  const flags = view.getUint16(at + 8, true);
  const name = decodeName(bytes.subarray(at + 46, at + 46 + nameLength), (flags & UTF8_NAME) !== 0, refuse);
  if ((flags & 1) !== 0) throw refuse("is encrypted", name);
  return {
    name,
    method: view.getUint16(at + 10, true),
    crc: view.getUint32(at + 16, true),
    compressedSize: view.getUint32(at + 20, true),
    size: view.getUint32(at + 24, true),
    offset: view.getUint32(at + 42, true),
    isLink: view.getUint8(at + 5) === MADE_ON_UNIX && view.getUint16(at + 40, true) >> 12 === LINK_TYPE,
  };
}

function decodeName(bytes: Uint8Array, isUtf8: boolean, refuse: Refuse): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch (cause) {
    if (isUtf8) throw refuse("an entry's name is not UTF-8 text", undefined, undefined, cause);
    return Array.from(bytes, (byte) => (byte < 128 ? String.fromCharCode(byte) : OLD_LETTERS[byte - 128])).join("");
  }
}

function checkName(name: string, names: Set<string>, refuse: Refuse): void {
  const parts = name.replace(/\/$/, "").split("/");
  const strange = parts.some((part) => part === "" || part === "." || part === "..");
  const control = [...name].some((character) => character < " " || character === "\\" || character === "\u007f");
  if (strange || control || /^[a-z]:/i.test(name)) throw refuse("is not a path inside the archive", name);
  // File systems that fold case, or write letters apart from their accents, would take them for one.
  const folded = name.normalize("NFC").toLowerCase();
  if (names.has(folded)) throw refuse("stands twice in the archive", name);
  names.add(folded);
}

function checkSizes({ name, method, size, compressedSize }: ZipEntry, refuse: Refuse): void {
  if (size === 0xffffffff || compressedSize === 0xffffffff) {
    throw refuse("has a 64-bit size, which is not read", name);
  }
  if (method !== STORED && method !== DEFLATED) {
    throw refuse(`is compressed by method ${method}; only deflate is read`, name);
  }
  const impossible = method === STORED ? size !== compressedSize : size > compressedSize * MOST_RATIO;
  if (impossible) {
    const message = `says it inflates from ${compressedSize} to ${size} bytes, which is not possible`;
    throw refuse(message, name, `${size} bytes`);
  }
}

function inflate(packed: Uint8Array, size: number, refuse: Refuse): Uint8Array {
  const bytes = new Uint8Array(size);
  let length = 0;
  const inflater = new Inflate((piece) => {
    if (length + piece.length > size) throw refuse(`inflates to more than the ${size} bytes that the archive says`);
    bytes.set(piece, length);
    length += piece.length;
  });
  try {
    for (let at = 0; at < packed.length; at += PIECE) {
      inflater.push(packed.subarray(at, at + PIECE), at + PIECE >= packed.length);
    }
  } catch (thrown) {
    throw thrown instanceof TexelcastError ? thrown : refuse("is damaged", undefined, undefined, thrown);
  }
  return bytes.subarray(0, length);
}

/** `message` reads on from the entry's name where there is one. */
export function zipError(
  terms: ZipTerms,
  archive: string,
  message: string,
  entry?: string,
  value?: string,
  cause?: unknown,
): TexelcastError {
  return new TexelcastError(terms.code, entry === undefined ? message : `${JSON.stringify(entry)} ${message}`, {
    subject: archive,
    ...(entry !== undefined && { field: entry }),
    ...(value !== undefined && { value }),
    hint: terms.hint,
    cause,
  });
}

/** What a font file says of itself before it is used: its kind by its first bytes, and whether the file is whole. */
import { TexelcastError } from "../core/texelcast-error.ts";

export type FontFormat = "ttf" | "otf";

/** Bytes. The largest fonts of East Asia's scripts stay below. */
export const MAX_FONT_BYTES = 32 * 2 ** 20;

/** A font that lacks one of these cannot be set. */
const NEEDED_TABLES = ["cmap", "head", "hhea", "hmtx", "maxp"];
/** TrueType's outlines, and where each begins: instead of them a font may have one of OpenType's own. */
const OUTLINE_TABLES = ["glyf", "loca"];
const COMPACT_OUTLINE_TABLES = ["CFF ", "CFF2"];
const DIRECTORY_START = 12;
const DIRECTORY_ENTRY = 16;

/**
 * @param reason the error's (`TexelcastErrorDetails`)
 * @param problem the end of the sentence “The font … cannot be used: …”
 */
export function badFont(name: string, reason: string, problem: string, hint?: string, cause?: unknown): TexelcastError {
  return new TexelcastError("bad-font", `The font “${name}” cannot be used: ${problem}.`, {
    subject: name,
    reason,
    ...(hint !== undefined && { hint }),
    ...(cause !== undefined && { cause }),
  });
}

/** The format that the first bytes show, or null. */
export function sniffFont(bytes: Uint8Array): FontFormat | null {
  const start = tagAt(bytes, 0);
  if (start === "\0\x01\0\0" || start === "true") return "ttf";
  return start === "OTTO" ? "otf" : null;
}

/**
 * Checks a font file's header. Throws "bad-font" naming the file: not a TrueType or OpenType font, too large, cut short, or
 * without what a text needs.
 */
export function readFontHeader(bytes: Uint8Array, name: string): { readonly format: FontFormat } {
  const format = sniffFont(bytes);
  if (format === null) throw badFont(name, ...describeUnknown(bytes), "Use a .ttf or .otf file.");
  if (bytes.length > MAX_FONT_BYTES) {
    throw badFont(
      name,
      "too-many-bytes",
      `it has ${bytes.length} bytes, and ${MAX_FONT_BYTES} is the most`,
      "Use a smaller font.",
    );
  }
  const tables = readDirectory(bytes, name);
  const isCompact = COMPACT_OUTLINE_TABLES.some((tag) => tables.has(tag));
  const lacking = [...NEEDED_TABLES, ...(isCompact ? [] : OUTLINE_TABLES)].filter((tag) => !tables.has(tag));
  if (lacking.length > 0) {
    throw badFont(
      name,
      "tables",
      `it lacks the table ${lacking.map((tag) => `“${tag}”`).join(", ")}`,
      "Use another font.",
    );
  }
  return { format };
}

function readDirectory(bytes: Uint8Array, name: string): Set<string> {
  const short = (): TexelcastError =>
    badFont(name, "cut-short", "it ends too early, so it was cut short", "Copy or download it again.");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < DIRECTORY_START) throw short();
  const count = view.getUint16(4);
  if (bytes.length < DIRECTORY_START + count * DIRECTORY_ENTRY) throw short();
  const tags = new Set<string>();
  for (let index = 0; index < count; index++) {
    const entry = DIRECTORY_START + index * DIRECTORY_ENTRY;
    if (view.getUint32(entry + 8) + view.getUint32(entry + 12) > bytes.length) throw short();
    tags.add(tagAt(bytes, entry));
  }
  return tags;
}

const tagAt = (bytes: Uint8Array, offset: number): string => String.fromCharCode(...bytes.subarray(offset, offset + 4));

function describeUnknown(bytes: Uint8Array): readonly [reason: string, problem: string] {
  const start = tagAt(bytes, 0);
  if (bytes.length === 0) return ["empty", "it is empty"];
  if (start === "wOFF" || start === "wOF2") return ["woff", "it is a web font (WOFF)"];
  if (start === "ttcf") return ["collection", "it is a collection of several fonts"];
  return ["unknown", "it is neither TrueType nor OpenType"];
}

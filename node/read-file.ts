/** Reading the user's files: typed errors, bounded sizes, and no way out of the folder that a document lies in. */
import { open, realpath, stat } from "node:fs/promises";
import path from "node:path";
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { systemReason } from "./system-reason.ts";

/** 2 GiB less one byte: Node reads no more in one go. */
export const MAX_FILE_BYTES = 2 ** 31 - 1;
/** JavaScript holds no longer text in one string on every platform; of a design, embedded pictures are the bulk of it. */
export const MAX_TEXT_BYTES = 256 * 2 ** 20;

export interface ReadOptions {
  /** Error code for a file that is there but cannot be used, e.g. "bad-model". */
  readonly code: string;
  readonly maxBytes?: number;
  /** The document that names the file; the user gave that one and looks there for the fault. */
  readonly namedBy?: Reference;
}

/** Where a document names another file; `field` is its path in the document, where that is known, and `uri` what stands there. */
export interface Reference {
  readonly file: string;
  readonly field?: string;
  readonly uri?: string;
}

/**
 * The bytes of a regular file; none of one that has no size, whatever could be read from it.
 *
 * @throws TexelcastError "missing-file" where there is none, `options.code` for folders, devices, files above the limit
 * (2 GiB without one) and files that the system will not read.
 */
export async function readFileBytes(filePath: string, options: ReadOptions): Promise<Uint8Array> {
  const { maxBytes = MAX_FILE_BYTES, namedBy } = options;
  const details = namedBy === undefined ? { subject: filePath || '""' } : detailsOf(namedBy);
  const about = namedBy === undefined ? "" : `${prefixOf(namedBy)}${quote(namedBy.uri ?? filePath)}: `;
  const refuse = (message: string, hint: string, value?: string) =>
    new TexelcastError(options.code, about + message, { ...details, hint, ...(value === undefined ? {} : { value }) });
  try {
    // Asked before opening: to open a named pipe would wait for its writer.
    const found = await stat(filePath);
    if (found.isDirectory()) throw refuse("is a folder", "Name a file in it.");
    if (!found.isFile()) throw refuse("is not a regular file", "Copy its content into a file first.");
    const file = await open(filePath);
    try {
      const { size } = await file.stat();
      if (size > maxBytes) {
        throw refuse(`has ${size} bytes, the limit is ${maxBytes}`, "Make the file smaller.", `${size} bytes`);
      }
      // What the system makes up as it is read, such as /proc/kmsg, has no size and may never end.
      return size === 0 ? new Uint8Array() : await file.readFile();
    } finally {
      await file.close();
    }
  } catch (cause) {
    if (cause instanceof TexelcastError) throw cause;
    const { code } = cause as NodeJS.ErrnoException;
    if (code === "ENOENT" || code === "ENOTDIR") {
      // In the place of bytes that are no UTF-8, which arguments lose on their way here.
      const isLost = filePath.includes("\ufffd");
      const hint = isLost
        ? "Its name is not written in UTF-8: rename it."
        : "Check the name; upper and lower case differ.";
      const value = namedBy === undefined ? {} : { value: namedBy.uri ?? filePath };
      throw new TexelcastError("missing-file", `${about}there is no such file`, { ...details, ...value, hint, cause });
    }
    throw new TexelcastError(options.code, `${about}cannot be read: ${systemReason(cause)}`, {
      ...details,
      hint: "Check that you may read the file.",
      cause,
    });
  }
}

/** Who is told where a document is no text. */
export interface TextReference {
  readonly code: string;
  /** As in "the design". */
  readonly what: string;
  readonly file: string;
  readonly hint: string;
}

/** @throws TexelcastError with the code that is given, for bytes that are not UTF-8: letters that stand for others would pass for the author's. */
export function decodeText(bytes: Uint8Array, { code, what, file, hint }: TextReference): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch (cause) {
    throw new TexelcastError(code, `${what} is not UTF-8 text`, { subject: file, hint, cause });
  }
}

/**
 * The path of a file that a document names, which must lie in the document's own folder or below it, symbolic links
 * followed: a document from elsewhere must not be able to pull private files into what is shown or sent on.
 *
 * @param uri As written in the document: relative, may be percent-encoded.
 * @throws TexelcastError "outside-folder" for absolute addresses, other schemes than none, `..` and links that lead out.
 */
export async function resolveInFolder(uri: string, reference: Reference): Promise<string> {
  const folder = path.dirname(reference.file);
  // Exporters on Windows write backslashes; taken as letters, they would hide a way up from the checks below.
  const name = decodeUri(uri).replaceAll("\\", "/");
  const outside = (why: string, hint: string) =>
    new TexelcastError("outside-folder", `${prefixOf(reference)}${quote(uri)} ${why}`, {
      ...detailsOf(reference),
      value: uri,
      hint,
    });
  // One letter is a drive of Windows.
  const scheme = /^[a-z][a-z0-9+.-]+:/i.exec(name)?.[0];
  if (scheme !== undefined) {
    const hint =
      "The command line reads files only: download it, put it beside the file that names it, and name it there.";
    throw outside(`is a ${scheme.toLowerCase()} address, not a file beside it`, hint);
  }
  const putInside = `Put the file into ${quote(folder)} or below, and name it there.`;
  if (/^([a-z]:|\/)/i.test(name)) throw outside("is an absolute path", putInside);
  if (name.includes("\0")) throw outside("is not a file name", putInside);
  if (!contains(path.resolve(folder), path.resolve(folder, name))) throw outside("lies outside the folder", putInside);
  // Macs pack "ü" as a "u" and its dots, which the document has as one letter, and other systems keep names as they are.
  for (const spelling of new Set([name, name.normalize("NFC"), name.normalize("NFD")])) {
    try {
      const realFolder = await realpath(folder);
      const realTarget = await realpath(path.resolve(realFolder, spelling));
      if (!contains(realFolder, realTarget)) throw outside("is a link that leads outside the folder", putInside);
      return realTarget;
    } catch (cause) {
      if (cause instanceof TexelcastError) throw cause;
    }
  }
  // A name that leads nowhere is told as missing by the read that follows, with the path that was meant.
  // Not by `path.join`, which takes a way up behind a link in the folder's own path for none.
  return `${folder}${path.sep}${path.normalize(name)}`;
}

function contains(folder: string, target: string): boolean {
  const relative = path.relative(folder, target);
  return relative !== "" && relative !== ".." && !relative.startsWith(`..${path.sep}`) && !path.isAbsolute(relative);
}

/** A "%" that begins no escape is taken as it is: many exporters write names unescaped. */
function decodeUri(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

const prefixOf = ({ field }: Reference): string => (field === undefined ? "" : `${field}: `);
const detailsOf = ({ file, field }: Reference) => ({ subject: file, ...(field === undefined ? {} : { field }) });

const quote = (text: string): string => JSON.stringify(text.length > 120 ? `${text.slice(0, 119)}…` : text);

/** What is of use in an archive, wherever it is opened: libraries give models so, with their sources and their previews. */
import { ZipReader, type ZipTerms } from "./zip-reader.ts";

/** By the name of its file. */
export const MODEL = /\.(glb|gltf)$/i;
export const ARCHIVE = /\.zip$/i;

export const ARCHIVE_TERMS: ZipTerms = {
  code: "bad-archive",
  hint: "Unpack it, and open the files that were in it.",
};
/** Of one archive's files, together. */
export const MOST_BYTES = 2 ** 30;

/** What other systems put beside the files. */
const HIDDEN = /^(\.|__MACOSX$)/;
/** What no model, design or picture here asks for, and may be large: sources, other kinds of models, archives, films. */
const FOREIGN =
  /\.(fbx|obj|mtl|stl|ply|dae|usd[acz]?|blend\d*|max|c4d|m[ab]|spp|psd|exr|hdr|zip|rar|7z|mp4|mov|txt|md|pdf|html?|rtf|url)$/i;

/** @throws TexelcastError "bad-archive" that names the archive and the entry at fault. */
export const openArchive = (bytes: Uint8Array, name: string): ZipReader => new ZipReader(bytes, name, ARCHIVE_TERMS);

export const isOfUse = (name: string): boolean =>
  !FOREIGN.test(name) && !name.split("/").some((part) => HIDDEN.test(part));

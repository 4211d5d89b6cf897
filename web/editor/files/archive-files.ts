/** What a zip holds that the page can open, as if its folder had been dropped: libraries of models give them as such. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { PROJECT_EXTENSION } from "../document/index.ts";
import { ZipReader, type ZipTerms } from "../document/zip-reader.ts";
import { nameOf } from "./companions.ts";
import { ARCHIVE, MODEL } from "./file-intake.ts";

export interface UnzippedFile {
  /** Path below a folder that is called as the archive. */
  readonly path: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

const TERMS: ZipTerms = { code: "bad-archive", hint: "Unpack it, and open the files that were in it." };
/** More than an honest model has. */
const MOST_FILES = 2000;
const MOST_BYTES = 2 ** 30;
/** What other systems put beside the files. */
const HIDDEN = /^(\.|__MACOSX$)/;
/** What no model, design or picture here asks for, and may be large: sources, other kinds of models, archives, films. */
const FOREIGN =
  /\.(fbx|obj|mtl|stl|ply|dae|usd[acz]?|blend\d*|max|c4d|m[ab]|spp|psd|exr|hdr|zip|rar|7z|mp4|mov|txt|md|pdf|html?|rtf|url)$/i;
const DESIGN = /\.design\.json$/i;
/** The entry by which a project is known that was given another ending. */
const MANIFEST = "project.json";

/**
 * The files of an archive but for those that nothing here could ask for. A project that is called `.zip` comes back as the one file
 * that it is.
 *
 * @param path the archive's own, in the drop
 * @throws TexelcastError "bad-archive" that names the archive and the entry at fault
 */
export function unzipFiles(bytes: Uint8Array<ArrayBuffer>, path: string): UnzippedFile[] {
  const name = nameOf(path);
  const archive = new ZipReader(bytes, name, TERMS);
  const folder = path.replace(ARCHIVE, "");
  if (archive.entries.has(MANIFEST)) return [{ path: `${folder}${PROJECT_EXTENSION}`, bytes }];
  const entries = [...archive.entries.values()].filter((entry) => isOfUse(entry.name));
  // What tools say beside a model is JSON, too, and no design.
  const hasModel = entries.some((entry) => MODEL.test(entry.name));
  const wanted = entries.filter((entry) => !hasModel || !/\.json$/i.test(entry.name) || DESIGN.test(entry.name));
  const total = wanted.reduce((sum, { size }) => sum + size, 0);
  if (wanted.length > MOST_FILES) throw tooLarge(name, `${wanted.length} files`, `${MOST_FILES} files`);
  if (total > MOST_BYTES) throw tooLarge(name, `${Math.ceil(total / 2 ** 20)} MiB`, `${MOST_BYTES / 2 ** 20} MiB`);
  return wanted.map((entry) => ({
    path: `${folder}/${entry.name}`,
    bytes: archive.read(entry.name, MOST_BYTES) as Uint8Array<ArrayBuffer>,
  }));
}

const isOfUse = (name: string): boolean => !FOREIGN.test(name) && !name.split("/").some((part) => HIDDEN.test(part));

const tooLarge = (name: string, value: string, limit: string): TexelcastError =>
  new TexelcastError(TERMS.code, `“${name}” holds ${value}, and ${limit} are the most.`, {
    subject: name,
    value,
    hint: TERMS.hint,
  });

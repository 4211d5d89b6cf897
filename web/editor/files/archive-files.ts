/** What a zip holds that the page can open, as if its folder had been dropped: libraries of models give them as such. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { nameOf } from "../../engine/companion-files.ts";
import { ARCHIVE, ARCHIVE_TERMS, isOfUse, MODEL, MOST_BYTES, openArchive } from "../../engine/zipped-files.ts";
import { PROJECT_EXTENSION } from "../document/index.ts";

export interface UnzippedFile {
  /** Path below a folder that is called as the archive. */
  readonly path: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** More than an honest model has. */
const MOST_FILES = 2000;
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
  const archive = openArchive(bytes, name);
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

const tooLarge = (name: string, value: string, limit: string): TexelcastError =>
  new TexelcastError(ARCHIVE_TERMS.code, `“${name}” holds ${value}, and ${limit} are the most.`, {
    subject: name,
    value,
    hint: ARCHIVE_TERMS.hint,
  });

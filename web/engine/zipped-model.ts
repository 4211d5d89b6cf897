/** A model as it came from a library, zipped with its files. Loaded when one is opened. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { findCompanion } from "./companion-files.ts";
import type { ModelSource } from "./engine-api.ts";
import { listSideFiles } from "./gltf-container.ts";
import { isOfUse, MODEL, MOST_BYTES, openArchive } from "./zipped-files.ts";

/** Archives of whole libraries hold hundreds. */
const MOST_NAMED = 8;

/**
 * The model in an archive, with the files that it names, and no others inflated. An archive of several is told which one by its
 * path, behind its own name: "pack.zip#robot/scene.gltf". The model is called so, too.
 *
 * @throws TexelcastError "bad-archive" that names the archive, and the entry at fault or the models to choose from.
 */
export function unzipModel({ name, bytes }: Pick<ModelSource, "name" | "bytes">): ModelSource {
  const [, archiveName = name, wanted] = /^(.*?\.zip)#(.+)$/i.exec(name) ?? [];
  const archive = openArchive(bytes, archiveName);
  const files = [...archive.entries.keys()].filter(isOfUse).map((path) => ({ path }));
  const models = files.map(({ path }) => path).filter((path) => MODEL.test(path));
  const path = chooseModel(models, wanted, archiveName);
  let room = MOST_BYTES;
  const read = (entry: string): Uint8Array => {
    const content = archive.read(entry, room) as Uint8Array;
    room -= content.length;
    return content;
  };
  const model = { name: `${archiveName}#${path}`, bytes: read(path) };
  const resources = new Map<string, Uint8Array>();
  for (const address of listSideFiles(model)) {
    const companion = findCompanion(address, path, files);
    // What is missing is told by whoever needs it.
    if (companion !== undefined) resources.set(address, read(companion.path));
  }
  return { ...model, resources };
}

function chooseModel(models: readonly string[], wanted: string | undefined, archive: string): string {
  const [first, second] = models;
  const refuse = (reason: string, message: string, hint: string): TexelcastError =>
    new TexelcastError("bad-archive", message, {
      subject: archive,
      ...(wanted !== undefined && { value: wanted }),
      hint,
      reason,
    });
  if (first === undefined) {
    throw refuse(
      "without-model",
      `“${archive}” holds no model.`,
      "A model is a .glb file, or a .gltf file with its side files.",
    );
  }
  const told = models.slice(0, MOST_NAMED).map((path) => `“${path}”`);
  const more = models.length - told.length;
  const all = more > 0 ? `${told.join(", ")} and ${more} more` : told.join(", ");
  const example = `Choose one by its path behind a “#”, as in “${archive}#${first}”.`;
  if (wanted !== undefined) {
    if (models.includes(wanted)) return wanted;
    throw refuse("which-model", `“${archive}” holds no model “${wanted}”, but ${all}.`, example);
  }
  if (second !== undefined) throw refuse("which-model", `“${archive}” holds ${models.length} models: ${all}.`, example);
  return first;
}

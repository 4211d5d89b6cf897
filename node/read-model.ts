/** A model from disk, with the side files that a `.gltf` names, also in a zip. */
import { stat } from "node:fs/promises";
import type { ModelSource } from "../web/engine/engine-api.ts";
import { listSideFiles } from "../web/engine/gltf-container.ts";
import { isZip } from "../web/engine/model-loader.ts";
import { unzipModel } from "../web/engine/zipped-model.ts";
import { MAX_FILE_BYTES, readFileBytes, resolveInFolder } from "./read-file.ts";

export interface ReadModel extends ModelSource {
  /** All files that it was read from. */
  readonly files: readonly string[];
}

/**
 * @param name a file's, or of an archive's with the path of a model in it: "pack.zip#robot/scene.gltf"
 * @throws TexelcastError "missing-file", "outside-folder", "bad-container", "bad-archive", and "bad-model" for files that cannot be
 * read or are above 2 GiB, together too.
 */
export async function readModel(name: string): Promise<ReadModel> {
  const file = await fileOf(name);
  const bytes = await readFileBytes(file, { code: "bad-model" });
  if (isZip(bytes)) return { ...unzipModel({ name, bytes }), files: [file] };
  const resources = new Map<string, Uint8Array>();
  const files = [file];
  let room = MAX_FILE_BYTES - bytes.length;
  for (const uri of listSideFiles({ name: file, bytes })) {
    const target = await resolveInFolder(uri, { file });
    const side = await readFileBytes(target, { code: "bad-model", maxBytes: room, namedBy: { file, uri } });
    room -= side.length;
    resources.set(uri, side);
    files.push(target);
  }
  return { name: file, bytes, resources, files };
}

/** A "#" may stand in a file's own name. */
async function fileOf(name: string): Promise<string> {
  const [, archive] = /^(.*?\.zip)#/i.exec(name) ?? [];
  if (archive === undefined) return name;
  const isThere = await stat(name).then(
    () => true,
    () => false,
  );
  return isThere ? name : archive;
}

/** A model from disk, with the side files that a `.gltf` names, also in a zip, and in the look of one of its variants. */
import { stat } from "node:fs/promises";
import { chosenModel, splitVariant } from "../web/engine/chosen-model.ts";
import type { ModelSource } from "../web/engine/engine-api.ts";
import { listSideFiles } from "../web/engine/gltf-container.ts";
import { isZip } from "../web/engine/zip-signature.ts";
import { namingModel } from "./name-model.ts";
import { MAX_FILE_BYTES, readFileBytes, resolveInFolder } from "./read-file.ts";

export interface ReadModel extends ModelSource {
  /** All files that it was read from. */
  readonly files: readonly string[];
}

/**
 * @param name a file's, or of an archive's with the path of a model in it: "pack.zip#robot/scene.gltf"; of either with a variant of
 * the model's materials behind it: "shoe.glb#variant=street"
 * @throws TexelcastError "missing-file", "outside-folder", "bad-container", "bad-archive", and "bad-model" for files that cannot be
 * read or are above 2 GiB, together too, and for a variant that is not there.
 */
export function readModel(name: string): Promise<ReadModel> {
  return namingModel(name, readParts(name));
}

async function readParts(name: string): Promise<ReadModel> {
  const file = await fileOf(name);
  const bytes = await readFileBytes(file, { code: "bad-model" });
  if (isZip(bytes)) return { ...(await chosenModel({ name, bytes })), files: [file] };
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
  return { ...(await chosenModel({ name, bytes, resources })), files };
}

/** A "#" may stand in a file's own name, or in front of what is in an archive. */
async function fileOf(name: string): Promise<string> {
  const { address } = splitVariant(name);
  const [, archive] = /^(.*?\.zip)#/i.exec(address) ?? [];
  if (archive === undefined) return address;
  const isThere = await stat(address).then(
    () => true,
    () => false,
  );
  return isThere ? address : archive;
}

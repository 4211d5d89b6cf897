/** A model from disk, with the side files that a `.gltf` names. */
import type { ModelSource } from "../web/engine/engine-api.ts";
import { listSideFiles } from "../web/engine/gltf-container.ts";
import { MAX_FILE_BYTES, readFileBytes, resolveInFolder } from "./read-file.ts";

/**
 * @throws TexelcastError "missing-file", "outside-folder", "bad-container", and "bad-model" for files that cannot be
 * read or are above 2 GiB, together too.
 */
export async function readModel(file: string): Promise<ModelSource> {
  const bytes = await readFileBytes(file, { code: "bad-model" });
  const resources = new Map<string, Uint8Array>();
  let room = MAX_FILE_BYTES - bytes.length;
  for (const uri of listSideFiles({ name: file, bytes })) {
    const target = await resolveInFolder(uri, { file });
    const side = await readFileBytes(target, { code: "bad-model", maxBytes: room, namedBy: { file, uri } });
    room -= side.length;
    resources.set(uri, side);
  }
  return { name: file, bytes, resources };
}

/** The side files of a model that `readModel` has read. */
export const sideFilesOf = ({ name, resources }: ModelSource): Promise<string[]> =>
  Promise.all([...(resources?.keys() ?? [])].map((uri) => resolveInFolder(uri, { file: name })));

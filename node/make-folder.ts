/** Folders, made where they are missing. */
import { mkdir, stat } from "node:fs/promises";
import path from "node:path";

/**
 * Makes a folder and those above it that are missing. Node's own recursive mkdir takes ENOENT to mean that the folder above
 * is missing, and never ends where that one is there and the system says ENOENT all the same, as below /proc.
 */
export async function makeFolder(folder: string): Promise<void> {
  if (await isFolder(folder)) return;
  const above = path.dirname(folder);
  if (above !== folder) await makeFolder(above);
  await mkdir(folder).catch(async (cause: unknown) => {
    // Another process may have been quicker.
    if (!(await isFolder(folder))) throw cause;
  });
}

export async function isFolder(place: string): Promise<boolean> {
  const found = await stat(place).catch(() => null);
  return found?.isDirectory() ?? false;
}

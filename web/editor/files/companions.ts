/** Files that came together: one names another by a relative address. */
import type { CollectedFile } from "./file-collection.ts";

export async function bytesOf(file: Blob): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await file.arrayBuffer());
}

/**
 * The file that a relative address means: by its path beside `base`, else (files dropped without their folders) the
 * only one of that name.
 */
export function findCompanion(
  address: string,
  base: string,
  files: readonly CollectedFile[],
): CollectedFile | undefined {
  const wanted = decodeAddress(address).replace(/^\.\//, "");
  const folder = base.slice(0, base.lastIndexOf("/") + 1);
  const exact = files.find(({ path }) => path === folder + wanted);
  if (exact) return exact;
  const name = wanted.slice(wanted.lastIndexOf("/") + 1);
  const named = files.filter(({ path }) => path.slice(path.lastIndexOf("/") + 1) === name);
  return named.length === 1 ? named[0] : undefined;
}

function decodeAddress(address: string): string {
  try {
    return decodeURIComponent(address);
  } catch {
    return address;
  }
}

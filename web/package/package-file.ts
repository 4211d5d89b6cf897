/** As web/engine/package-file.ts, for the package: every file that it needs lies in its own `assets` folder. */
import { readBytes } from "../core/read-bytes.ts";
import type { PackageFile } from "../engine/package-file.ts";

export type { PackageFile } from "../engine/package-file.ts";

/** @param what names the file in the error. Rejects with "missing-file". */
export async function readPackageFile({ url }: PackageFile, what: string): Promise<Uint8Array<ArrayBuffer>> {
  return await readBytes(url(), what);
}

/**
 * Files that lie in npm packages: found by Node's resolver in Node, and by their address elsewhere. Found here and not by the
 * packages' own glue, so that the browser and Node read the very same bytes and a bundler sees every file.
 */
import { inNode, readBytes } from "../core/read-bytes.ts";

export interface PackageFile {
  /** For Node's resolver. */
  readonly specifier: string;
  /** For a bundler, which needs the address as a literal: `() => new URL("…", import.meta.url)`. */
  readonly url: () => URL;
}

/** @param what names the file in the error. Rejects with "missing-file". */
export async function readPackageFile({ specifier, url }: PackageFile, what: string): Promise<Uint8Array<ArrayBuffer>> {
  return await readBytes(inNode ? await resolveInNode(specifier) : url(), what);
}

async function resolveInNode(specifier: string): Promise<string> {
  // Not a literal, so that a bundler for the browser does not try to follow it.
  const moduleName = "node:module";
  const { createRequire } = (await import(/* @vite-ignore */ moduleName)) as typeof import("node:module");
  return createRequire(import.meta.url).resolve(specifier);
}

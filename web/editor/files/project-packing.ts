/** What the page and the worker that packs and unpacks projects and archives say to each other. */
import type { TexelcastErrorJson } from "../../core/texelcast-error.ts";
import { decodeDataUri } from "../document/data-uri.ts";
import { type ProjectFile, type ProjectToWrite, readProjectFile, writeProjectFile } from "../document/index.ts";
import type { UnzippedFile } from "./archive-files.ts";

/** A project whose pictures and fonts are inside the design, as `data:` URIs. */
export type ProjectToPack = Omit<ProjectToWrite, "assetBytes">;

/** A project as it comes out of its file, all of it inflated. */
export interface UnpackedProject extends Omit<ProjectFile, "assetBytes"> {
  /** Bytes of the pictures and fonts that are in the file, by the addresses that the design gives them. */
  readonly assets: ReadonlyMap<string, Uint8Array>;
}

export type ProjectWork =
  | { readonly pack: ProjectToPack }
  | { readonly unpack: { readonly bytes: Uint8Array; readonly fileName: string } }
  | { readonly unzip: { readonly bytes: Uint8Array<ArrayBuffer>; readonly path: string } };

/** A function cannot be sent, so each kind of work has its own answer. */
export type ProjectAnswer =
  | { readonly packed: Uint8Array<ArrayBuffer> }
  | { readonly unpacked: UnpackedProject }
  | { readonly unzipped: readonly UnzippedFile[] }
  | { readonly error: TexelcastErrorJson };

/** Throws a TexelcastError that names the asset which could not be read. */
export function packProject(project: ProjectToPack): Uint8Array<ArrayBuffer> {
  const assetBytes: ProjectToWrite["assetBytes"] = (key, { uri }) =>
    uri.startsWith("data:") ? decodeDataUri(uri, key) : undefined;
  return writeProjectFile({ ...project, assetBytes }) as Uint8Array<ArrayBuffer>;
}

/** Throws a TexelcastError, "bad-project" or "bad-design", that names file and entry. */
export function unpackProject(bytes: Uint8Array, fileName: string): UnpackedProject {
  const { assetBytes, ...project } = readProjectFile(bytes, fileName);
  const assets = new Map<string, Uint8Array>();
  for (const { uri } of Object.values(project.design.assets)) {
    const inside = assetBytes(uri);
    if (inside) assets.set(uri, inside);
  }
  return { ...project, assets };
}

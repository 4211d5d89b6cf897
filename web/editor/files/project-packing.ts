/** What the page and the worker that packs its project file say to each other. */
import type { TexelcastErrorJson } from "../../core/texelcast-error.ts";
import { type ProjectToWrite, writeProjectFile } from "../document/index.ts";
import { decodeDataUri } from "./data-uri.ts";

/** A project whose pictures and fonts are inside the design, as `data:` URIs. */
export type ProjectToPack = Omit<ProjectToWrite, "assetBytes">;

export type PackingAnswer = { readonly bytes: Uint8Array<ArrayBuffer> } | { readonly error: TexelcastErrorJson };

/** Throws a TexelcastError that names the asset which could not be read. */
export function packProject(project: ProjectToPack): Uint8Array<ArrayBuffer> {
  const assetBytes: ProjectToWrite["assetBytes"] = (key, { uri }) =>
    uri.startsWith("data:") ? decodeDataUri(uri, key) : undefined;
  return writeProjectFile({ ...project, assetBytes }) as Uint8Array<ArrayBuffer>;
}

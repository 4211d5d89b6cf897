/** A design from disk, and the pictures and fonts that it names. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { decodeDataUri } from "../web/editor/document/data-uri.ts";
import { formatPath } from "../web/editor/document/design-problem.ts";
import {
  type Design,
  PROJECT_EXTENSION,
  type ProjectFile,
  parseDesign,
  readProjectFile,
  resolveLayers,
} from "../web/editor/document/index.ts";
import type { EngineLayer } from "../web/engine/engine-api.ts";
import { decodeText, MAX_FILE_BYTES, MAX_TEXT_BYTES, readFileBytes, resolveInFolder } from "./read-file.ts";

export interface LoadedDesign {
  readonly file: string;
  readonly design: Design;
  readonly layers: readonly EngineLayer[];
  /** What the design came in; null for a plain document. */
  readonly project: ProjectFile | null;
}

/** By its name's ending alone. */
export const isProjectFile = (file: string): boolean => file.toLowerCase().endsWith(PROJECT_EXTENSION);

/**
 * Reads a design document, or the design of a project (`.texelcast`).
 *
 * @throws TexelcastError "missing-file", "bad-design", "bad-project".
 */
export async function readDesign(file: string): Promise<LoadedDesign> {
  if (isProjectFile(file)) {
    const project = readProjectFile(await readFileBytes(file, { code: "bad-project", maxBytes: MAX_FILE_BYTES }), file);
    return { file, design: project.design, layers: resolveLayers(project.design), project };
  }
  const bytes = await readFileBytes(file, { code: "bad-design", maxBytes: MAX_TEXT_BYTES });
  const hint = "A design is a JSON file; give the model first and the design second.";
  const text = decodeText(bytes, { code: "bad-design", what: "the design", file, hint });
  const design = parseDesign(text, file);
  return { file, design, layers: resolveLayers(design), project: null };
}

/**
 * The bytes of one of the design's pictures or fonts.
 *
 * @throws TexelcastError "outside-folder", "missing-file", "bad-project", "bad-design" for a `data:` address that is broken, and
 * "bad-picture" or "bad-font" for a file that cannot be read.
 */
export async function readAsset(
  { file, design, project }: LoadedDesign,
  key: string,
): Promise<{ name: string; bytes: Uint8Array }> {
  const uri = design.assets[key]?.uri ?? "";
  const field = formatPath(["assets", key, "uri"]);
  if (/^data:/i.test(uri)) return { name: `${file}: ${field}`, bytes: readDataUri(uri, file, field) };
  const inside = project?.assetBytes(uri);
  if (inside !== undefined) return { name: `${file}: ${uri}`, bytes: inside };
  const target = await resolveInFolder(uri, { file, field });
  const code = design.assets[key]?.type.startsWith("font/") ? "bad-font" : "bad-picture";
  return {
    name: `${file}: ${field}: ${uri}`,
    bytes: await readFileBytes(target, { code, namedBy: { file, field, uri } }),
  };
}

/** The files beside it that a design names, as far as they may be read. */
export async function assetFilesOf({ file, design, project }: LoadedDesign): Promise<string[]> {
  const uris = Object.values(design.assets).map(({ uri }) => uri);
  const beside = uris.filter((uri) => !/^data:/i.test(uri) && project?.assetBytes(uri) === undefined);
  const files = await Promise.allSettled(beside.map((uri) => resolveInFolder(uri, { file })));
  return files.flatMap((found) => (found.status === "fulfilled" ? [found.value] : []));
}

/** @throws TexelcastError "bad-design" for an address that is broken. */
export function readDataUri(uri: string, file: string, field: string): Uint8Array {
  try {
    return decodeDataUri(uri, field);
  } catch (cause) {
    throw new TexelcastError("bad-design", `${field}: is not a valid data: address`, {
      subject: file,
      field,
      hint: 'Write it as "data:image/png;base64,…".',
      cause,
    });
  }
}

/**
 * A project in one file, `.texelcast`: a zip of `project.json`, `design.json` with its pictures and fonts below `assets/`,
 * and, where it was asked for, the model below `model/`. The same project always makes the same bytes.
 */
import { type Zippable, zipSync } from "fflate";
import * as v from "valibot";
import { cutText } from "../../core/cut-text.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { zipDay } from "../../engine/zip-day.ts";
import { ZipReader, type ZipTerms, zipError } from "../../engine/zip-reader.ts";
import { ASSET_ENDINGS, type Design, type DesignAsset } from "./design.ts";
import { describeValue, formatPath } from "./design-problem.ts";
import { parseDesign } from "./parse-design.ts";
import { printJson } from "./print-json.ts";
import { repeatedKeys } from "./repeated-keys.ts";
import { serialiseDesign } from "./serialise-design.ts";

export const PROJECT_FORMAT = "texelcast-project";
export const PROJECT_VERSION = 1;
export const PROJECT_EXTENSION = ".texelcast";

const TERMS: ZipTerms = { code: "bad-project", hint: "Save the project again from the page that made it." };

/** Size and gutter of a material's texture; null: the default. */
export interface ProjectTarget {
  readonly material: number;
  readonly size: number | null;
  readonly gutter: number | null;
}

export interface ProjectToWrite {
  readonly name: string;
  readonly design: Design;
  /** Bytes of one of the design's assets; undefined leaves its address as it is. */
  readonly assetBytes: (key: string, asset: DesignAsset) => Uint8Array | undefined;
  readonly targets: readonly ProjectTarget[];
  readonly model: {
    readonly title: string;
    /** Id of the demo that it is; null for other models. */
    readonly demo: string | null;
    /** Null leaves the model out of the file. */
    readonly source: ModelSource | null;
  };
}

export interface ProjectFile {
  readonly name: string;
  /** The assets' addresses are relative to the archive. */
  readonly design: Design;
  /** Bytes of an asset by its address; undefined for one that is not in the archive. */
  readonly assetBytes: (uri: string) => Uint8Array | undefined;
  readonly targets: readonly ProjectTarget[];
  readonly model: ProjectToWrite["model"];
}

const MANIFEST = "project.json";
const DESIGN = "design.json";
const MAX_MANIFEST = 2 ** 20;
/** JavaScript holds no longer text in one string on every platform. */
const MAX_DESIGN = 256 * 2 ** 20;
const MAX_ASSET = 256 * 2 ** 20;
const MAX_MODEL = 2 ** 31 - 1;
/** Characters of a project's name, and of all else in the manifest that is not an address. */
const MAX_NAME = 1000;
/** Characters of a side file's address as the model spells it, folders and per cents included. */
const MAX_ADDRESS = 10_000;
/** Characters of an entry's name, without its folder and ending: file systems take 255 bytes, and a character has up to four. */
const MAX_STEM = 60;
const MAX_EXTENSION = 16;

/** What is compressed already, or as good as. */
const STORED = /\.(png|jpe?g|webp|avif|glb|ktx2)$/i;

export function writeProjectFile({ name, design, assetBytes, targets, model }: ProjectToWrite): Uint8Array {
  const files = new Map<string, Uint8Array>();
  const add = (stem: string, extension: string, bytes: Uint8Array): string => {
    const file = freeName(files, stem, extension);
    files.set(file, bytes);
    return file;
  };
  const assets: Record<string, DesignAsset> = {};
  for (const [key, asset] of Object.entries(design.assets)) {
    const bytes = assetBytes(key, asset);
    if (bytes === undefined) {
      assets[key] = asset;
      continue;
    }
    assets[key] = { ...asset, uri: add(`assets/${plainName(key)}`, ASSET_ENDINGS[asset.type], bytes) };
  }
  const { source } = model;
  const sideFiles: { uri: string; file: string }[] = [];
  let modelFile: string | null = null;
  if (source !== null) {
    const { stem, extension } = splitName(source.name);
    modelFile = add(`model/${plainName(stem)}`, extension, source.bytes);
    for (const [uri, bytes] of source.resources ?? []) {
      const side = splitName(uri);
      sideFiles.push({ uri, file: add(`model/${plainName(side.stem)}`, side.extension, bytes) });
    }
  }
  const manifest = {
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    name: cutText(name, MAX_NAME),
    model: {
      title: cutText(model.title, MAX_NAME),
      demo: model.demo,
      file: modelFile,
      name: source === null ? null : cutText(source.name, MAX_NAME),
      sideFiles,
    },
    targets: targets.map(({ material, size, gutter }) => ({ material, size, gutter })),
  };
  return zip([[MANIFEST, utf8(printJson(manifest))], [DESIGN, utf8(serialiseDesign({ ...design, assets }))], ...files]);
}

/**
 * Reads a project. Pictures and model are inflated when they are asked for, the model at once.
 *
 * @param fileName as the user knows it; errors name it.
 * @throws TexelcastError "bad-project" that names file and entry, "bad-design" for its design.
 */
export function readProjectFile(bytes: Uint8Array, fileName: string): ProjectFile {
  const archive = new ZipReader(bytes, fileName, TERMS);
  const manifest = parseManifest(requiredText(archive, MANIFEST, MAX_MANIFEST), fileName);
  const text = requiredText(archive, DESIGN, MAX_DESIGN);
  const design = parseDesign(text, `${fileName}: ${DESIGN}`);
  for (const [key, { uri }] of Object.entries(design.assets)) {
    const inside = !/^[a-z][a-z0-9+.-]*:/i.test(uri);
    if (inside && !archive.entries.has(uri)) {
      const field = `${DESIGN}: ${formatPath(["assets", key, "uri"])}`;
      throw missing(fileName, field, uri);
    }
  }
  const { model, name, targets } = manifest;
  return {
    name,
    design,
    targets,
    assetBytes: (uri) => archive.read(uri, MAX_ASSET),
    model: { title: model.title, demo: model.demo, source: readModel(archive, model) },
  };
}

function readModel(archive: ZipReader, { file, name, sideFiles }: Manifest["model"]): ModelSource | null {
  if (file === null) return null;
  const read = (entry: string, field: string): Uint8Array => {
    const bytes = archive.read(entry, MAX_MODEL);
    if (bytes === undefined) throw missing(archive.name, `${MANIFEST}: ${field}`, entry);
    return bytes;
  };
  const resources = sideFiles.map((side, index) => {
    return [side.uri, read(side.file, `model.sideFiles[${index}].file`)] as const;
  });
  return {
    name: name ?? file.slice(file.lastIndexOf("/") + 1),
    bytes: read(file, "model.file"),
    ...(resources.length > 0 && { resources: new Map(resources) }),
  };
}

const wholeNumber = (max: number) => v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(max));
const shortText = v.pipe(v.string(), v.maxCodePoints(MAX_NAME));
const address = v.pipe(v.string(), v.maxCodePoints(MAX_ADDRESS));
const manifestSchema = v.object({
  format: v.literal(PROJECT_FORMAT),
  version: v.literal(PROJECT_VERSION),
  name: shortText,
  model: v.object({
    title: shortText,
    demo: v.nullable(shortText),
    file: v.nullable(shortText),
    name: v.nullable(shortText),
    sideFiles: v.pipe(v.array(v.object({ uri: address, file: shortText })), v.maxLength(10_000)),
  }),
  targets: v.pipe(
    v.array(
      v.object({
        material: wholeNumber(65_535),
        size: v.nullable(v.pipe(wholeNumber(8192), v.minValue(1))),
        gutter: v.nullable(wholeNumber(64)),
      }),
    ),
    v.maxLength(65_536),
  ),
});
type Manifest = v.InferOutput<typeof manifestSchema>;

function parseManifest(text: string, archive: string): Manifest {
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (cause) {
    throw zipError(TERMS, archive, "is not valid JSON", MANIFEST, undefined, cause);
  }
  const [repeated] = repeatedKeys(text);
  if (repeated) throw zipError(TERMS, archive, `has ${formatPath(repeated)} twice in one object`, MANIFEST);
  const { format, version } = (typeof data === "object" && data !== null ? data : {}) as Record<string, unknown>;
  if (format !== PROJECT_FORMAT) {
    throw zipError(TERMS, archive, `must have the format "${PROJECT_FORMAT}"`, MANIFEST, describeValue(format));
  }
  if (version !== PROJECT_VERSION) {
    const newer = typeof version === "number" && version > PROJECT_VERSION;
    if (!newer) throw zipError(TERMS, archive, "has an unknown version", MANIFEST, describeValue(version));
    // The page that made it would make the same again.
    throw new TexelcastError(TERMS.code, `${JSON.stringify(MANIFEST)} was made by a newer Texelcast`, {
      subject: archive,
      field: MANIFEST,
      value: describeValue(version),
      reason: "newer",
      hint: "Update to open it.",
    });
  }
  const result = v.safeParse(manifestSchema, data);
  if (result.success) return result.output;
  const [issue] = result.issues;
  const path = formatPath((issue.path ?? []).map((item) => item.key as string | number));
  throw zipError(TERMS, archive, `has a fault at ${path}: ${issue.message}`, MANIFEST, describeValue(issue.input));
}

function requiredText(archive: ZipReader, entry: string, maxSize: number): string {
  const bytes = archive.read(entry, maxSize);
  if (bytes === undefined) throw zipError(TERMS, archive.name, `has no ${entry}, so it is no Texelcast project`);
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch (cause) {
    throw zipError(TERMS, archive.name, "is not UTF-8 text", entry, undefined, cause);
  }
}

function missing(archive: string, field: string, entry: string): TexelcastError {
  return new TexelcastError("bad-project", `${field} names ${JSON.stringify(entry)}, which is not in the archive`, {
    subject: archive,
    field,
    value: entry,
    hint: "Save the project again from the page that made it.",
  });
}

function zip(files: readonly (readonly [string, Uint8Array])[]): Uint8Array {
  const mtime = zipDay();
  const entries = files.map(([name, bytes]): [string, Zippable[string]] => [
    name,
    [bytes, { level: STORED.test(name) ? 0 : 6, mtime }],
  ]);
  return zipSync(Object.fromEntries(entries));
}

const utf8 = (text: string): Uint8Array => new TextEncoder().encode(text);

/** In lower case, which no two names share whatever the file system makes of them; "" becomes "file". */
function plainName(name: string): string {
  const base = name.slice(name.lastIndexOf("/") + 1).replace(/\.(png|jpe?g|webp|avif|svg|ttf|otf)$/i, "");
  const plain = base
    .normalize("NFC")
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]+/gu, "-");
  return cutText(plain.trim(), MAX_STEM) || "file";
}

function splitName(name: string): { stem: string; extension: string } {
  const base = name.slice(name.lastIndexOf("/") + 1);
  const dot = base.lastIndexOf(".");
  const extension =
    dot > 0
      ? base
          .slice(dot + 1)
          .replace(/[^A-Za-z0-9]/g, "")
          .toLowerCase()
      : "";
  return { stem: dot > 0 ? base.slice(0, dot) : base, extension: extension.slice(0, MAX_EXTENSION) || "bin" };
}

function freeName(taken: ReadonlyMap<string, unknown>, stem: string, extension: string): string {
  for (let number = 1; ; number++) {
    const name = `${stem}${number === 1 ? "" : `-${number}`}.${extension}`;
    if (!taken.has(name)) return name;
  }
}

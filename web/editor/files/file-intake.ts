/** What a handful of files means: a model with its side files, a design, pictures for decals. */

import { decodeAddress, findCompanion } from "../../engine/companion-files.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { listSideFiles } from "../../engine/gltf-container.ts";
import { MODEL } from "../../engine/zipped-files.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { bytesOf } from "./file-bytes.ts";
import type { CollectedFile } from "./file-collection.ts";

export interface Intake {
  readonly model?: ModelSource;
  /** What the model is called: the name of its file, or of its folder where many models' files have that name. */
  readonly title?: string;
  readonly design?: CollectedFile;
  /** A project in one file, which has its design and mostly its model inside. */
  readonly project?: CollectedFile;
  /** For decals: pictures that came alone, or loose beside a model that does not name them. A design's are its own. */
  readonly pictures: readonly CollectedFile[];
  /** For texts, as the pictures are for decals. Web fonts are among them: what is wrong with them is told when they are read. */
  readonly fonts: readonly CollectedFile[];
  /** Colours to paint with, which are no part of a design. */
  readonly palette?: CollectedFile;
  /** The paths of what came beside pictures, fonts and colours and is of no use: in folders, and beside a model, much is. */
  readonly useless: readonly string[];
  /** Everything that came along: a design's relative addresses are looked up here. */
  readonly companions: readonly CollectedFile[];
}

const PICTURE = /\.(png|jpe?g|jfif|webp|avif|svgz?)$/i;
/** What people take for pictures, and what is wrong with them is told when they are read. */
const OTHER_PICTURE = /\.(gif|bmp|tiff?|hei[cf]|jxl|psd|pdf|ai|eps)$/i;
const FONT = /\.(ttf|otf|ttc|otc|woff2?)$/i;
const DESIGN = /\.json$/i;
const PROJECT = /\.texelcast$/i;
const PALETTE = /\.gpl$/i;
/** One letter is a drive of Windows. */
const ON_THE_NET = /^[a-z][a-z0-9+.-]+:/i;
/** Files that are named where a model lacks several. */
const TOLD_MISSING = 6;
/** Of an address that is none of a file. */
const TOLD_LETTERS = 80;

/**
 * Throws a TexelcastError of code "unsupported" when nothing of it can be used or when it holds two models, and "missing-file"
 * where several files that the model names did not come with it.
 */
export async function sortFiles(files: readonly CollectedFile[], strings: Strings): Promise<Intake> {
  const [modelFile, secondModel] = files.filter(({ path }) => MODEL.test(path));
  if (modelFile && secondModel) {
    throw new ToldError("unsupported", strings.errors.twoModels(modelFile.path, secondModel.path), {
      subject: secondModel.path,
      hint: strings.errors.twoModelsHint,
    });
  }
  const designs = files.filter(({ path }) => DESIGN.test(path));
  const design = designs.find(({ path }) => path.endsWith(".design.json")) ?? designs[0];
  const project = files.find(({ path }) => PROJECT.test(path));
  const read = modelFile && (await readModel(modelFile, files, strings));
  const spare = design || project ? [] : read ? files.filter((file) => isBeside(file, read.own)) : files;
  const pictures = spare.filter(({ path }) => PICTURE.test(path) || (!read && OTHER_PICTURE.test(path)));
  const fonts = spare.filter(({ path }) => FONT.test(path));
  const palette = files.find(({ path }) => PALETTE.test(path));
  if (!modelFile && !design && !project && !palette && pictures.length + fonts.length === 0) {
    const first = files[0];
    throw new ToldError("unsupported", strings.errors.unknownFile(first?.path ?? ""), {
      ...(first && { subject: first.path }),
      hint: strings.errors.unknownFileHint,
    });
  }
  return {
    ...(read && { model: read.model, title: titleOf(read.model.name, modelFile.path) }),
    ...(design && { design }),
    ...(project && { project }),
    pictures,
    fonts,
    ...(palette && { palette }),
    useless: read || design || project ? [] : uselessOf(files, [...pictures, ...fonts, ...(palette ? [palette] : [])]),
    companions: files,
  };
}

const uselessOf = (files: readonly CollectedFile[], used: readonly CollectedFile[]): string[] =>
  files.filter((file) => !used.includes(file) && !file.path.includes("/")).map(({ path }) => path);

/** Beside a model, and not its own: in a folder lie previews and sources of its textures that it does not name either. */
function isBeside(file: CollectedFile, own: ReadonlySet<CollectedFile>): boolean {
  return !own.has(file) && !file.path.includes("/");
}

/** Libraries of models call each of them so, in a folder or an archive that has its name. */
const NAMELESS = /^(scene|model)\.(glb|gltf)$/i;

function titleOf(name: string, path: string): string {
  return (NAMELESS.test(name) && path.split("/").at(-2)) || name;
}

interface ReadModel {
  readonly model: ModelSource;
  /** The files that it names. */
  readonly own: ReadonlySet<CollectedFile>;
}

async function readModel(
  modelFile: CollectedFile,
  files: readonly CollectedFile[],
  strings: Strings,
): Promise<ReadModel> {
  const name = modelFile.file.name;
  const bytes = await bytesOf(modelFile.file);
  const resources = new Map<string, Uint8Array>();
  const own = new Set<CollectedFile>();
  const missing: string[] = [];
  for (const address of sideFilesOf(name, bytes)) {
    const companion = findCompanion(address, modelFile.path, files);
    if (companion) {
      own.add(companion);
      resources.set(address, await bytesOf(companion.file));
    } else missing.push(decodeAddress(address));
  }
  // A single one is the engine's to report, which knows what the file is for, and one on the net, which nobody fetches.
  if (missing.length > 1 && !missing.some((address) => ON_THE_NET.test(address)))
    throw severalMissing(name, missing, strings);
  return { model: { name, bytes, resources }, own };
}

/** So that whoever gathers them need not come once for each. */
function severalMissing(name: string, missing: readonly string[], { errors }: Strings): ToldError {
  const told = missing.slice(0, TOLD_MISSING);
  const list = told.map((address) => shortened(address)).join(", ");
  return new ToldError("missing-file", errors.filesMissing(name, list, missing.length - told.length), {
    subject: name,
    hint: errors.filesMissingHint,
  });
}

const shortened = (address: string): string =>
  address.length > TOLD_LETTERS ? `${address.slice(0, TOLD_LETTERS)}…` : address;

function sideFilesOf(name: string, bytes: Uint8Array): string[] {
  try {
    return listSideFiles({ name, bytes });
  } catch {
    // A broken container is refused by the engine too, with the whole story.
    return [];
  }
}

/** What a handful of files means: a model with its side files, a design, pictures for decals. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { listSideFiles } from "../../engine/gltf-container.ts";
import type { Strings } from "../strings.ts";
import { bytesOf, findCompanion } from "./companions.ts";
import type { CollectedFile } from "./file-collection.ts";

export interface Intake {
  readonly model?: ModelSource;
  readonly design?: CollectedFile;
  /** A project in one file, which has its design and mostly its model inside. */
  readonly project?: CollectedFile;
  readonly pictures: readonly CollectedFile[];
  /** For texts. Web fonts are among them: what is wrong with them is told when they are read. */
  readonly fonts: readonly CollectedFile[];
  /** Everything that came along: a design's relative addresses are looked up here. */
  readonly companions: readonly CollectedFile[];
}

const MODEL = /\.(glb|gltf)$/i;
const PICTURE = /\.(png|jpe?g|webp|svgz?)$/i;
const FONT = /\.(ttf|otf|ttc|otc|woff2?)$/i;
const DESIGN = /\.json$/i;
const PROJECT = /\.texelcast$/i;

/** Throws a TexelcastError of code "unsupported" when nothing of it can be used or when it holds two models. */
export async function sortFiles(files: readonly CollectedFile[], strings: Strings): Promise<Intake> {
  const [modelFile, secondModel] = files.filter(({ path }) => MODEL.test(path));
  if (modelFile && secondModel) {
    throw new TexelcastError("unsupported", strings.errors.twoModels(modelFile.path, secondModel.path), {
      subject: secondModel.path,
      hint: strings.errors.twoModelsHint,
    });
  }
  const designs = files.filter(({ path }) => DESIGN.test(path));
  const design = designs.find(({ path }) => path.endsWith(".design.json")) ?? designs[0];
  const project = files.find(({ path }) => PROJECT.test(path));
  // Pictures and fonts that come with a model, a design or a project are its own; alone they are for decals.
  const alone = modelFile || design || project ? [] : files;
  const pictures = alone.filter(({ path }) => PICTURE.test(path));
  const fonts = alone.filter(({ path }) => FONT.test(path));
  if (!modelFile && !design && !project && pictures.length + fonts.length === 0) {
    const first = files[0];
    throw new TexelcastError("unsupported", strings.errors.unknownFile(first?.path ?? ""), {
      ...(first && { subject: first.path }),
      hint: strings.errors.unknownFileHint,
    });
  }
  const model = modelFile && (await readModel(modelFile, files));
  return {
    ...(model && { model }),
    ...(design && { design }),
    ...(project && { project }),
    pictures,
    fonts,
    companions: files,
  };
}

async function readModel(modelFile: CollectedFile, files: readonly CollectedFile[]): Promise<ModelSource> {
  const name = modelFile.file.name;
  const bytes = await bytesOf(modelFile.file);
  const resources = new Map<string, Uint8Array>();
  for (const address of sideFilesOf(name, bytes)) {
    const companion = findCompanion(address, modelFile.path, files);
    // A missing one is the engine's to report: it knows what the file is for.
    if (companion) resources.set(address, await bytesOf(companion.file));
  }
  return { name, bytes, resources };
}

function sideFilesOf(name: string, bytes: Uint8Array): string[] {
  try {
    return listSideFiles({ name, bytes });
  } catch {
    // A broken container is refused by the engine too, with the whole story.
    return [];
  }
}

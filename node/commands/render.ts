/** `texelcast render`: a design replayed on a model, as the finished texture or as the model with it inside. */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { EngineLayer, ModelInfo, ModelSource, TargetOptions } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { fontsOf, picturesOf } from "../../web/engine/layer-picture.ts";
import { materialsIn } from "../../web/engine/layer-tree.ts";
import { checkFit, checkPaintable } from "../check-fit.ts";
import { findMaterial, findPaintable } from "../find-material.ts";
import { missingCharacters } from "../missing-characters.ts";
import { namingModel } from "../name-model.ts";
import { namingText } from "../name-text.ts";
import { openEngine } from "../open-engine.ts";
import { type BaseOption, fileOfMaterial, type RenderOutput, type Size } from "../options.ts";
import { Progress } from "../progress.ts";
import { assetFilesOf, type LoadedDesign, readAsset, readDesign } from "../read-design.ts";
import { readFileBytes } from "../read-file.ts";
import { readModel } from "../read-model.ts";
import { formatCount, plural, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";

export interface RenderOptions {
  readonly out: RenderOutput;
  /** Without it: material 0 for one .png, else every material that the design paints. */
  readonly material?: number;
  readonly size?: Size;
  /** Without it: the material's own picture or colour. */
  readonly base?: BaseOption;
}

const DEFAULT_MATERIAL = 0;

/** @param modelFile null: the model that is inside the project. */
export async function render(modelFile: string | null, designFile: string, options: RenderOptions): Promise<void> {
  const { out } = options;
  const given = [modelFile, designFile, options.base && "file" in options.base ? options.base.file : null];
  const inputs = given.filter((file) => file !== null);
  await checkOutputFile(out.kind === "pngs" ? fileOfMaterial(out.file, DEFAULT_MATERIAL) : out.file, inputs);
  const design = await readDesign(designFile);
  inputs.push(...(await assetFilesOf(design)));
  const read = modelFile === null ? null : await readModel(modelFile);
  inputs.push(...(read?.files ?? []));
  const model = read ?? modelInside(design);
  const base = await readBase(options.base);
  const engine = openEngine();
  const progress = new Progress();
  const files = new PendingFiles();
  try {
    progress.report("Reading the model");
    const info = await engine.loadModel(model);
    const materials = chooseMaterials(info, design, options);
    for (const result of resultsOf(out, materials)) await checkOutputFile(result.file, inputs);
    checkPaintable(info, design.design, design.file, materials);
    // No layer need ask for the one that --material names.
    for (const material of materials) findPaintable(info, material);
    const layers = design.layers.filter(
      (layer) => layer.visible && materialsIn(layer).some((material) => materials.includes(material)),
    );
    await setAssets(engine, design, layers, progress);
    const sizes = new Map<number, string>();
    for (const material of materials) {
      const target: TargetOptions = { material, ...(options.size ?? keptSize(design, material)), base };
      const opening = engine.openTarget(target, (share) => progress.report("Baking", share));
      const { width, height } = await namingModel(model.name, opening);
      sizes.set(material, `material ${material} at ${width} x ${height}`);
    }
    progress.report("Painting");
    await namingText(design.design, design.file, paint(engine, layers));
    progress.report("Writing");
    const lines: string[] = [];
    for (const result of resultsOf(options.out, materials)) {
      const bytes = await result.bytes(engine);
      await files.write(result.file, bytes);
      const drawn = layers.filter((layer) => materialsIn(layer).some((own) => result.materials.includes(own)));
      const where = result.materials.map((material) => sizes.get(material)).join(", ") || "no material";
      const what = `${formatCount(bytes.length)} bytes, ${plural(drawn.length, "layer")}, ${where}`;
      lines.push(`${printable(result.file)}: ${what}\n`);
    }
    await files.commit();
    progress.end();
    process.stderr.write(await missingCharacters(engine, layers));
    process.stdout.write(lines.join("") || "no material is painted, so there is no picture to write\n");
  } finally {
    progress.end();
    await files.discard();
    engine.dispose();
  }
}

/** Called after both, as a model in an archive is. */
function modelInside({ file, project }: LoadedDesign): ModelSource {
  const source = project?.model.source;
  if (source) return { ...source, name: `${file}#${source.name}` };
  throw new TexelcastError("missing-file", "the project was saved without its model", {
    subject: file,
    hint: `Give the model first: texelcast render MODEL ${file} --out FILE.`,
  });
}

/** The size and gutter that a project says its material's texture has. */
function keptSize({ project }: LoadedDesign, material: number): Pick<TargetOptions, "width" | "height" | "gutter"> {
  const { size = null, gutter = null } = project?.targets.find((target) => target.material === material) ?? {};
  return { ...(size !== null && { width: size, height: size }), ...(gutter !== null && { gutter }) };
}

async function readBase(base: BaseOption | undefined): Promise<NonNullable<TargetOptions["base"]>> {
  if (base === undefined) return "model";
  if (!("file" in base)) return base;
  return { name: base.file, bytes: await readFileBytes(base.file, { code: "bad-picture" }) };
}

function chooseMaterials(model: ModelInfo, design: LoadedDesign, options: RenderOptions): number[] {
  checkFit(model, design.design, design.file);
  if (options.material !== undefined) return [findMaterial(model, options.material).index];
  if (options.out.kind === "png") return [findMaterial(model, DEFAULT_MATERIAL).index];
  const painted = design.layers.filter((layer) => layer.visible).flatMap(materialsIn);
  return [...new Set(painted)].sort((a, b) => a - b);
}

interface Result {
  readonly file: string;
  /** Those whose textures it holds. */
  readonly materials: readonly number[];
  bytes(engine: EngineHost): Promise<Uint8Array>;
}

function resultsOf({ file, kind }: RenderOutput, materials: readonly number[]): Result[] {
  if (kind === "glb") return [{ file, materials, bytes: (engine) => engine.exportGlb() }];
  if (kind === "usdz") return [{ file, materials, bytes: (engine) => engine.exportUsdz() }];
  return materials.map((material) => ({
    file: fileOfMaterial(file, material),
    materials: [material],
    bytes: (engine) => engine.exportPng(material),
  }));
}

async function setAssets(
  engine: EngineHost,
  design: LoadedDesign,
  layers: readonly EngineLayer[],
  progress: Progress,
): Promise<void> {
  for (const key of picturesOf(layers)) {
    progress.report("Reading pictures");
    await engine.setAsset(key, await readAsset(design, key));
  }
  for (const key of fontsOf(layers)) {
    progress.report("Reading fonts");
    await engine.setFont(key, await readAsset(design, key));
  }
}

/** Draws the layers; what the engine refuses on its way is thrown, not lost in an event. */
async function paint(engine: EngineHost, layers: readonly EngineLayer[]): Promise<void> {
  const errors: Error[] = [];
  const unsubscribe = engine.onError((error) => errors.push(error));
  engine.setLayers(layers, 1);
  await engine.idle();
  unsubscribe();
  if (errors[0] !== undefined) throw errors[0];
}

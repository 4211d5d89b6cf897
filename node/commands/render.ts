/** `texelcast render`: a design replayed on a model, as the finished texture or as the model with it inside. */
import type { EngineLayer, ModelInfo, TargetOptions } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { findMaterial } from "../find-material.ts";
import { openEngine } from "../open-engine.ts";
import type { BaseOption, Size } from "../options.ts";
import { Progress } from "../progress.ts";
import { type LoadedDesign, readAsset, readDesign } from "../read-design.ts";
import { readFileBytes } from "../read-file.ts";
import { readModel } from "../read-model.ts";
import { formatCount, plural, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";

export interface RenderOptions {
  readonly out: { readonly file: string; readonly kind: "png" | "glb" };
  /** Without it: material 0 for a .png, every material that the design paints for a .glb. */
  readonly material?: number;
  readonly size?: Size;
  /** Without it: the material's own picture or colour. */
  readonly base?: BaseOption;
}

const DEFAULT_MATERIAL = 0;

export async function render(modelFile: string, designFile: string, options: RenderOptions): Promise<void> {
  const { out } = options;
  await checkOutputFile(out.file);
  const design = await readDesign(designFile);
  const model = await readModel(modelFile);
  const base = await readBase(options.base);
  const engine = openEngine();
  const progress = new Progress();
  const files = new PendingFiles();
  try {
    progress.report("Reading the model");
    const info = await engine.loadModel(model);
    const materials = chooseMaterials(info, design, options);
    const layers = design.layers.filter((layer) => layer.visible && materials.includes(layer.material));
    await setAssets(engine, design, layers, progress);
    const sizes = [];
    for (const material of materials) {
      const target: TargetOptions = { material, ...options.size, base };
      const { width, height } = await engine.openTarget(target, (share) => progress.report("Baking", share));
      sizes.push(`${width} x ${height}`);
    }
    progress.report("Painting");
    await paint(engine, layers);
    progress.report("Writing");
    const bytes = await (out.kind === "png" ? engine.exportPng(materials[0] ?? DEFAULT_MATERIAL) : engine.exportGlb());
    await files.write(out.file, bytes);
    await files.commit();
    progress.end();
    const painted = sizes.map((size, index) => `material ${materials[index]} at ${size}`).join(", ") || "no material";
    const made = `${formatCount(bytes.length)} bytes, ${plural(layers.length, "layer")}, ${painted}`;
    process.stdout.write(`${printable(out.file)}: ${made}\n`);
  } finally {
    progress.end();
    await files.discard();
    engine.dispose();
  }
}

async function readBase(base: BaseOption | undefined): Promise<NonNullable<TargetOptions["base"]>> {
  if (base === undefined) return "model";
  if (!("file" in base)) return base;
  return { name: base.file, bytes: await readFileBytes(base.file, { code: "bad-picture" }) };
}

/** Every material that a layer names must be there, even one that this run leaves out: the design is for another model. */
function chooseMaterials(model: ModelInfo, { file, design }: LoadedDesign, options: RenderOptions): number[] {
  design.layers.forEach(({ material }, index) => {
    findMaterial(model, material, { file, field: `layers[${index}].material` });
  });
  if (options.material !== undefined) return [findMaterial(model, options.material).index];
  if (options.out.kind === "png") return [findMaterial(model, DEFAULT_MATERIAL).index];
  const painted = design.layers.filter((layer) => layer.visible).map((layer) => layer.material);
  return [...new Set(painted)].sort((a, b) => a - b);
}

async function setAssets(
  engine: EngineHost,
  design: LoadedDesign,
  layers: readonly EngineLayer[],
  progress: Progress,
): Promise<void> {
  const keys = new Set(layers.flatMap((layer) => (layer.type === "decal" ? [layer.asset] : [])));
  for (const key of keys) {
    progress.report("Reading pictures");
    await engine.setAsset(key, await readAsset(design, key));
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

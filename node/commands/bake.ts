/** `texelcast bake`: the local space texture (spec.md, 2) as NumPy arrays, and as pictures to look at. */
import path from "node:path";
import type { MapView, MaterialInfo, TargetInfo } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { findPaintable } from "../find-material.ts";
import { namingModel } from "../name-model.ts";
import { type NpyType, npyHeader } from "../npy.ts";
import { openEngine } from "../open-engine.ts";
import type { Size } from "../options.ts";
import { Progress } from "../progress.ts";
import { readModel } from "../read-model.ts";
import { formatCount, formatShare, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";

export interface BakeOptions {
  readonly out: string;
  readonly material: number;
  readonly size?: Size;
  readonly gutter?: number;
}

/** Without a picture there is no size to take over. */
const DEFAULT_SIZE: Size = { width: 1024, height: 1024 };

/** One block of rows of the largest map (8192 texels wide, 12 bytes each) is then about 24 MB. */
const ROWS_PER_BLOCK = 256;

interface MapArray {
  readonly name: MapView;
  readonly type: NpyType;
  readonly components: 1 | 3;
  readRows(engine: EngineHost, material: number, row: number, rowCount: number): Promise<Float32Array | Uint8Array>;
}

const vectors = (name: "positions" | "normals"): MapArray => ({
  name,
  type: "float32",
  components: 3,
  readRows: (engine, material, row, rowCount) => engine.readMapRows(material, name, row, rowCount),
});

const counts = (name: "coverage" | "overlap"): MapArray => ({
  name,
  type: "uint8",
  components: 1,
  readRows: (engine, material, row, rowCount) => engine.readMapRows(material, name, row, rowCount),
});

const ARRAYS = [vectors("positions"), vectors("normals"), counts("coverage"), counts("overlap")];

/** Writes all of its files, or none. @throws TexelcastError for what cannot be read, painted or written */
export async function bake(file: string, options: BakeOptions): Promise<void> {
  const { out, gutter } = options;
  const pathOf = (name: MapView, extension: "npy" | "png"): string => inFolder(out, `${name}.${extension}`);
  const outputs = ARRAYS.flatMap(({ name }) => [pathOf(name, "npy"), pathOf(name, "png")]);
  for (const output of outputs) await checkOutputFile(output, [file]);
  const model = await readModel(file);
  const inputs = model.files;
  for (const output of outputs) await checkOutputFile(output, inputs);
  const engine = openEngine();
  const progress = new Progress();
  const files = new PendingFiles();
  try {
    progress.report("Reading the model");
    const material = findPaintable(await engine.loadModel(model), options.material);
    const size = options.size ?? textureSize(material);
    // The map does not hang on the picture, so a broken one need not stop the bake: a plain colour stands in for it.
    const opening = engine.openTarget(
      { material: material.index, ...size, ...(gutter === undefined ? {} : { gutter }), base: [1, 1, 1, 1] },
      (share) => progress.report("Baking", share),
    );
    const target = await namingModel(model.name, opening);
    for (const array of ARRAYS) {
      progress.report(`Writing ${array.name}`);
      await writeArray(engine, target, array, pathOf(array.name, "npy"), files);
      await writeView(engine, target, array.name, pathOf(array.name, "png"), files);
    }
    await files.commit();
    progress.end();
    process.stdout.write(summary(file, out, material, target));
  } finally {
    progress.end();
    await files.discard();
    engine.dispose();
  }
}

/** By `path.join` a way up behind a link to a folder would lead to where the link stands. */
const inFolder = (folder: string, name: string): string =>
  folder.includes("..") ? `${folder}${path.sep}${name}` : path.join(folder, name);

function textureSize({ textureSize }: MaterialInfo): Size {
  return textureSize === null ? DEFAULT_SIZE : { width: textureSize[0], height: textureSize[1] };
}

async function writeArray(
  engine: EngineHost,
  { material, width, height }: TargetInfo,
  { type, components, readRows }: MapArray,
  target: string,
  files: PendingFiles,
): Promise<void> {
  const npy = await files.create(target);
  await npy.append(npyHeader(type, components === 1 ? [height, width] : [height, width, components]));
  for (let row = 0; row < height; row += ROWS_PER_BLOCK) {
    const values = await readRows(engine, material, row, Math.min(ROWS_PER_BLOCK, height - row));
    await npy.append(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
  }
}

async function writeView(
  engine: EngineHost,
  { material }: TargetInfo,
  view: MapView,
  target: string,
  files: PendingFiles,
): Promise<void> {
  await files.write(target, await encodePng(await engine.viewMap(material, view)));
}

function summary(file: string, out: string, { index, name }: MaterialInfo, target: TargetInfo): string {
  const { width, height, gutter, coveredTexels, gutterTexels, overlappingTexels } = target;
  const count = (texels: number, of: number): string =>
    `${formatCount(texels)} texels (${formatShare(of === 0 ? 0 : texels / of)}`;
  return [
    `${printable(file)}: material ${index}${name === "" ? "" : ` "${printable(name)}"`}, ${width} x ${height} texels, gutter ${gutter}`,
    `  covered  ${count(coveredTexels, width * height)})`,
    `  gutter   ${count(gutterTexels, width * height)})`,
    `  overlap  ${count(overlappingTexels, coveredTexels)} of the covered)`,
    `  written to ${printable(out)}: ${ARRAYS.map(({ name }) => `${name}.npy, ${name}.png`).join(", ")}`,
    "",
  ].join("\n");
}

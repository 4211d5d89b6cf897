/**
 * The paper's two steps, ours against its plain method (bench/README.md). `npm run bench` builds what it needs and has
 * checked the options.
 */
import { mkdir, writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import type { PlanarProjector } from "../web/engine/engine-api.ts";
import type { BenchEngine, DragStep, Run } from "./engines/engine.ts";
import { PlainNativeEngine } from "./engines/plain-native-engine.ts";
import { PlainWasmEngine } from "./engines/plain-wasm-engine.ts";
import { TexelcastEngine } from "./engines/texelcast-engine.ts";
import { nudged } from "./nudged.ts";
import { parseBenchOptions } from "./options.mjs";
import { plotFigures } from "./plot/plot-figures.ts";
import { circumstances, formatCircumstances, formatMemory, formatRows, type MemoryRow, type Row } from "./report.ts";
import { takeTurns } from "./rounds.ts";
import { decalsAround, loadWork } from "./work.ts";

/** Floats of a position and a normal, for every texel of the map, covered or not. */
const PLAIN_BYTES_PER_TEXEL = 24;

const options = parseBenchOptions(process.argv.slice(2));
if (options === "help") throw new Error("scripts/bench.mjs answers --help");
const { sizes, meshes, works, rounds, json } = options;
// Before an hour of figures that could not be written.
if (json) await mkdir(dirname(json), { recursive: true });

const work = await loadWork(fileURLToPath(new URL("../../shared/bench", import.meta.url)));
const local10 = work.projectors.get("local10") as PlanarProjector;
const native = new PlainNativeEngine();
const plainWasm = await PlainWasmEngine.create();
const ours = await TexelcastEngine.create();
const stacks = await Promise.all(
  [20, 100].map((count) => TexelcastEngine.create(`Texelcast, over ${count} others`, decalsAround(local10, count))),
);
const engines: readonly BenchEngine[] = [native, plainWasm, ours];

const conditions = circumstances();
console.log(formatCircumstances(conditions));
console.log(`Work: ${work.source}. ${rounds} rounds, engines in turn; milliseconds.\n`);

const rows: Row[] = [];
const memory: MemoryRow[] = [];
for (const mesh of work.meshes.filter(({ name }) => meshes.some((chosen) => chosen === name))) {
  for (const engine of [...engines, ...stacks]) await engine.load(mesh, work.decal);
  for (const size of sizes) await measureAll(mesh.name, size);
}
for (const engine of [...engines, ...stacks]) engine.close();

console.log(formatRows(rows));
if (memory.length > 0) console.log(`\n${formatMemory(memory)}`);
if (json) {
  const figures = { ...conditions, work: work.source, rounds, rows, memory };
  await writeFile(json, `${JSON.stringify(figures, null, 2)}\n`);
  const plot = plotFigures(figures);
  if (plot) await writeFile(json.replace(/\.json$/, ".svg"), plot);
}

async function measureAll(mesh: string, size: number): Promise<void> {
  if (works.includes("bake")) await measure("bake", mesh, size, engines, (engine) => engine.bake(size));
  else for (const engine of engines) await engine.bake(size);
  if (works.includes("memory")) memory.push(mapAtRest(mesh, size));
  for (const [name, projector] of work.projectors) {
    if (works.some((chosen) => chosen === name)) await measureDrag(name, mesh, size, engines, projector, "none");
  }
  if (works.includes("occluded")) await measureDrag("occluded", mesh, size, engines, local10, "self");
  if (works.includes("stacked") || works.includes("open")) for (const stack of stacks) await stack.bake(size);
  if (works.includes("stacked")) await measureDrag("stacked", mesh, size, [...engines, ...stacks], local10, "none");
  // Beside the one that the drags were about: two designs of a hundred such layers outgrow the session at 4096².
  if (works.includes("open") && size <= 2048) await measure("open", mesh, size, stacks, (engine) => engine.open(size));
}

function measureDrag(
  name: string,
  mesh: string,
  size: number,
  contestants: readonly BenchEngine[],
  projector: PlanarProjector,
  occlusion: DragStep["occlusion"],
): Promise<void> {
  return measure(name, mesh, size, contestants, (engine, round) =>
    engine.project({ projector: nudged(projector, round), occlusion }),
  );
}

async function measure<Contestant extends BenchEngine>(
  name: string,
  mesh: string,
  size: number,
  contestants: readonly Contestant[],
  run: (engine: Contestant, round: number) => Promise<Run>,
): Promise<void> {
  const results = await takeTurns(contestants, rounds, run);
  const medianOf = (engine: BenchEngine) => results.find(({ contestant }) => contestant === engine)?.figures.median;
  const ratio = (key: string, median: number, to: number | undefined) =>
    to === undefined ? {} : { [key]: median / to };
  for (const { contestant, figures } of results) {
    rows.push({
      work: name,
      mesh,
      size,
      engine: contestant.name,
      ...figures,
      ...ratio("toPlainNative", figures.median, medianOf(native)),
      ...ratio("toPlainWasm", figures.median, medianOf(plainWasm)),
      ...(stacks.some((stack) => stack.name === contestant.name) && ratio("toAlone", figures.median, medianOf(ours))),
    });
  }
  process.stderr.write(`${name} ${mesh} ${size}²\n`);
}

function mapAtRest(mesh: string, size: number): MemoryRow {
  const map = ours.map();
  return {
    mesh,
    size,
    ...map,
    bytesPerCoveredTexel: map.bytes / map.coveredTexels,
    plainBytesPerCoveredTexel: (size * size * PLAIN_BYTES_PER_TEXEL) / map.coveredTexels,
  };
}

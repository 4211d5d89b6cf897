/**
 * The paper's two steps, ours against its plain method (bench/README.md).
 *   npm run bench -- [--sizes 1024,2048,4096] [--meshes torus20k] [--rounds 15] [--json FILE]
 */
import { writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import type { PlanarProjector } from "../web/engine/engine-api.ts";
import type { BenchEngine, Run } from "./engines/engine.ts";
import { PlainNativeEngine } from "./engines/plain-native-engine.ts";
import { PlainWasmEngine } from "./engines/plain-wasm-engine.ts";
import { TexelcastEngine } from "./engines/texelcast-engine.ts";
import { circumstances, figures, formatTable, type Row } from "./report.ts";
import { loadWork } from "./work.ts";

const WARM_UPS = 2;
/** A drag moves the decal: by this much, metres, to and fro, so that no engine can reuse what it has. */
const NUDGE = 1e-3;

const { values } = parseArgs({
  options: {
    sizes: { type: "string", default: "1024,2048,4096" },
    meshes: { type: "string" },
    rounds: { type: "string", default: "15" },
    json: { type: "string" },
  },
});
const sizes = values.sizes.split(",").map(Number);
const rounds = Number(values.rounds);
const shared = fileURLToPath(new URL("../../shared/bench", import.meta.url));
const work = await loadWork(shared);
const chosenMeshes = work.meshes.filter(({ name }) => !values.meshes || values.meshes.split(",").includes(name));

const native = new PlainNativeEngine();
const plainWasm = await PlainWasmEngine.create();
const ours = await TexelcastEngine.create();
const engines: readonly BenchEngine[] = [native, plainWasm, ours];

const conditions = circumstances();
console.log(conditions.machine);
console.log(
  Object.entries(conditions.versions)
    .map(([name, version]) => `${name} ${version}`)
    .join(" · "),
);
console.log(`Work: ${work.source}. ${rounds} rounds, engines in turn; milliseconds.\n`);

const rows: Row[] = [];
for (const mesh of chosenMeshes) {
  for (const engine of engines) await engine.load(mesh, work.decal);
  for (const size of sizes) {
    rows.push(...(await measure("bake", mesh.name, size, (engine) => engine.bake(size))));
    for (const [name, projector] of work.projectors) {
      const project = (engine: BenchEngine, round: number) => engine.project(nudged(projector, round));
      rows.push(...(await measure(name, mesh.name, size, project)));
    }
  }
}
for (const engine of engines) engine.close();
console.log(formatTable(rows));
if (values.json) {
  await writeFile(values.json, `${JSON.stringify({ ...conditions, work: work.source, rounds, rows }, null, 2)}\n`);
}

/** Takes turns between the engines, so that a slower moment of the machine meets all of them. */
async function measure(
  name: string,
  mesh: string,
  size: number,
  run: (engine: BenchEngine, round: number) => Promise<Run>,
): Promise<Row[]> {
  const runs = new Map<BenchEngine, Run[]>(engines.map((engine) => [engine, []]));
  for (let round = 0; round < WARM_UPS + rounds; round++) {
    for (const engine of engines) {
      const result = await run(engine, round);
      if (round >= WARM_UPS) runs.get(engine)?.push(result);
    }
  }
  const results = engines.map((engine) => {
    const list = runs.get(engine) ?? [];
    return { engine, texels: list[0].texels, ...figures(list.map(({ milliseconds }) => milliseconds)) };
  });
  const medianOf = (engine: BenchEngine) => results.find((result) => result.engine === engine)?.median ?? Number.NaN;
  process.stderr.write(`${name} ${mesh} ${size}²\n`);
  return results.map(({ engine, ...rest }) => ({
    work: name,
    mesh,
    size,
    engine: engine.name,
    ...rest,
    toPlainNative: rest.median / medianOf(native),
    toPlainWasm: rest.median / medianOf(plainWasm),
  }));
}

function nudged(projector: PlanarProjector, round: number): PlanarProjector {
  const [x, y, z] = projector.position;
  return { ...projector, position: [x + (round % 2) * NUDGE, y, z] };
}

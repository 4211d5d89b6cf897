/**
 * `npm run bench:browser`: the benchmark's page in Chromium (bench/README.md). Without a graphics card WebGL runs on the
 * processor, which the report names.
 */
import { mkdir, writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { build, type InlineConfig, preview } from "vite";
import { findChromium } from "../../scripts/bootstrap/chromium.mjs";
import { BROWSER_BENCH, parseBenchOptions } from "../options.mjs";
import { circumstances, type EngineRow, formatCircumstances, formatEngines } from "../report.ts";
import { loadWork } from "../work.ts";
import type { EngineFigures } from "./page.ts";
import { measurePageDrag } from "./page-drag.ts";
import type { FrameWork } from "./trace-frames.ts";

const options = parseBenchOptions(process.argv.slice(2), BROWSER_BENCH);
if (options === "help") throw new Error("scripts/bench-browser.mjs answers --help");
const { sizes, meshes, works, rounds, json } = options;
if (json) await mkdir(dirname(json), { recursive: true });

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));
// Isolated from other origins, a page may read the clock to 5 microseconds instead of 100.
const isolation = { "Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp" };
const config: InlineConfig = {
  configFile: false,
  root: here("."),
  base: "./",
  logLevel: "warn",
  build: {
    outDir: here("../../build/bench-browser"),
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
    chunkSizeWarningLimit: 4000,
  },
  preview: { host: "localhost", port: 4190, headers: isolation },
};
process.stderr.write("Building the page …\n");
await build(config);
const work = await loadWork(here("../../../shared/bench"));
const server = await preview(config);
const browser = await chromium.launch({
  executablePath: findChromium() ?? undefined,
  args: [
    ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
    // A graphics card where there is one, else WebGL on the processor.
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
  ],
});
try {
  const page = await browser.newPage();
  page.on("pageerror", (error) => process.stderr.write(`page: ${error.message}\n`));
  await page.goto(server.resolvedUrls?.local[0] ?? "");
  await page.waitForFunction(() => window.bench !== undefined);
  const versions = await page.evaluate(() => window.bench?.versions);
  const conditions = circumstances({ chromium: browser.version(), ...versions });
  console.log(formatCircumstances(conditions));
  console.log(`Work: ${work.source}. ${rounds} rounds, engines in turn; milliseconds of the page's thread.\n`);

  const rows: EngineRow[] = [];
  const add = (name: string, mesh: string, size: number, results: EngineFigures[] | undefined): void => {
    rows.push(...(results ?? []).map((result) => ({ work: name, mesh, size, ...result })));
    process.stderr.write(`${name} ${mesh} ${size}²\n`);
  };
  const timed = works.some((name) => name !== "drag") ? work.meshes : [];
  for (const mesh of timed.filter(({ name }) => meshes.some((chosen) => chosen === name))) {
    await page.evaluate(([model, decal]) => window.bench?.load(model, decal), [mesh, work.decal] as const);
    for (const size of sizes) {
      if (works.includes("bake")) {
        const results = await page.evaluate(([side, count]) => window.bench?.bake(side, count), [
          size,
          rounds,
        ] as const);
        add("bake", mesh.name, size, results);
      }
      await page.evaluate((side) => window.bench?.prepare(side), size);
      for (const [name, projector] of work.projectors) {
        if (!works.some((chosen) => chosen === name)) continue;
        const results = await page.evaluate(([decal, count]) => window.bench?.drag(decal, count), [
          projector,
          rounds,
        ] as const);
        add(name, mesh.name, size, results);
      }
    }
  }
  if (rows.length > 0) console.log(`${formatEngines(rows)}\n`);
  const pageDrag = works.includes("drag") ? await measurePageDrag(browser) : null;
  if (pageDrag) console.log(formatPageDrag(pageDrag));
  if (json) {
    const figures = { ...conditions, work: work.source, rounds, rows, pageDrag };
    await writeFile(json, `${JSON.stringify(figures, null, 2)}\n`);
  }
} finally {
  await browser.close();
  await server.close();
}

function formatPageDrag({ frames, median, mean, p95, perMove, byKind }: FrameWork): string {
  const kinds = Object.entries(byKind).sort(([, a], [, b]) => b - a);
  return [
    "A drag of local10 at 2048² in the editor page: processor time of the page's own thread in a frame.",
    `median ${median.toFixed(2)}, mean ${mean.toFixed(2)}, 95 % under ${p95.toFixed(2)}; ${frames} frames`,
    `a move of the pointer, with all its frames: ${perMove?.toFixed(2) ?? "none"}`,
    `mean by kind: ${kinds.map(([kind, share]) => `${kind} ${share.toFixed(2)}`).join(", ")}`,
  ].join("\n");
}

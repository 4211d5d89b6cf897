/** `npm run bench:load`: product pages in Chromium, with nothing cached, near and far (bench/README.md). */
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { type Browser, chromium, type Page } from "@playwright/test";
import { chromiumLaunch } from "../../scripts/bootstrap/chromium.mjs";
import { type Circumstances, circumstances, formatCircumstances, formatTable } from "../report.ts";
import { parseLoadOptions } from "./options.mjs";
import { type Line, type Sent, SlowNetwork } from "./slow-server.ts";
import { DIST, serveAll } from "./sources.ts";

const options = parseLoadOptions(process.argv.slice(2));
if (options === "help") throw new Error("scripts/bench-load.mjs answers --help");
const { pages, rounds, json, readme } = options;

/** As in Chromium's own tools: nine tenths of 9 Mbit/s, and 165 ms. */
const FAST_4G: Line = { bytesPerSecond: (9e6 / 8) * 0.9, latency: 165 };

const README_START = "<!-- `npm run bench:load -- --readme` writes what follows. -->\n";
const README_END = "<!-- Up to here. -->";

interface Condition {
  readonly name: string;
  readonly line: Line | null;
  /** Times that the page's own thread is slower. */
  readonly slowdown: number;
}
const CONDITIONS: readonly Condition[] = [
  { name: "this machine", line: null, slowdown: 1 },
  { name: "Fast 4G", line: FAST_4G, slowdown: 1 },
  { name: "Fast 4G, 4 × slower", line: FAST_4G, slowdown: 4 },
];
const PAGE_NAMES = { html: "plain HTML", shop: "example shop", framed: "example shop, iframe" } as const;
const KINDS = ["scripts", "three.js", "WebAssembly", "model", "pictures", "fonts", "HTML, CSS, JSON"] as const;
type Kind = (typeof KINDS)[number];
type Bytes = Readonly<Record<Kind, number>>;

interface Load {
  /** Milliseconds from the navigation. */
  readonly poster: number;
  readonly ready: number;
  readonly bytes: Bytes;
}
interface Row extends Load {
  readonly page: keyof typeof PAGE_NAMES;
  readonly condition: string;
}

const network = new SlowNetwork();
const addresses = await serveAll(network);
const browser = await chromium.launch(chromiumLaunch());
const rows: Row[] = [];
try {
  const conditions = circumstances({ chromium: browser.version() });
  for (const page of pages) {
    // Files are read and compressed, the browser's own parts started.
    network.line = null;
    await load(browser, addresses[page], 1);
    for (const { name, line, slowdown } of CONDITIONS) {
      network.line = line;
      const loads: Load[] = [];
      for (let round = 0; round < rounds; round += 1) loads.push(await load(browser, addresses[page], slowdown));
      rows.push({ page, condition: name, ...medians(loads) });
      process.stderr.write(`${PAGE_NAMES[page]}, ${name}\n`);
    }
  }
  network.line = null;
  const { bytes } = await load(browser, addresses.map, 1);
  const element = {
    "the element in shop mode with its worker, until the product is shown, without three.js and WebAssembly":
      bytes.scripts,
  };
  const sizes = { ...(await packageSizes()), ...element };
  console.log(`${formatCircumstances(conditions)}\nNothing cached. Medians of ${rounds} loads.\n`);
  console.log(`${formatTimes()}\n\n${formatBytes()}\n\n${formatSizes(sizes)}`);
  if (readme) await writeReadme(`${formatSizes(sizes)}\n\n${loadSentence(conditions)}\n\n${formatTimes()}`);
  if (json) {
    await mkdir(dirname(json), { recursive: true });
    await writeFile(json, `${JSON.stringify({ ...conditions, rounds, rows, sizes }, null, 2)}\n`);
  }
} finally {
  await browser.close();
  await addresses.stop();
}

/** Once, in a browser that has seen nothing. */
async function load(browser: Browser, address: string, slowdown: number): Promise<Load> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await context.newPage();
  page.on("pageerror", (error) => process.stderr.write(`page: ${error.message}\n`));
  await page.addInitScript({ path: fileURLToPath(new URL("note-times.js", import.meta.url)) });
  const tools = await context.newCDPSession(page);
  await tools.send("Emulation.setCPUThrottlingRate", { rate: slowdown });
  network.sent = [];
  await page.goto(address, { waitUntil: "commit" });
  const start = await page.evaluate(() => performance.timeOrigin);
  const ready = await timeOf(page, "ready");
  const bytes = bytesByKind(network.sent);
  const poster = await timeOf(page, "poster");
  await context.close();
  return { poster: poster - start, ready: ready - start, bytes };
}

async function timeOf(page: Page, name: string): Promise<number> {
  const read = (): Promise<(number | undefined)[]> =>
    Promise.all(
      page.frames().map((frame) =>
        frame
          .evaluate((key) => (globalThis as { loadTimes?: Record<string, number> }).loadTimes?.[key], name)
          // A frame that is on its way to its page.
          .catch(() => undefined),
      ),
    );
  for (const deadline = Date.now() + 120_000; Date.now() < deadline; ) {
    const found = (await read()).find((time) => time !== undefined);
    if (found !== undefined) return found;
    await page.waitForTimeout(50);
  }
  throw new Error(`${page.url()} had no “${name}” within two minutes`);
}

function bytesByKind(sent: readonly Sent[]): Bytes {
  const sums = Object.fromEntries(KINDS.map((kind) => [kind, 0])) as Record<Kind, number>;
  for (const one of sent) sums[kindOf(one)] += one.bytes;
  return sums;
}

function kindOf({ path, type }: Sent): Kind {
  if (path.startsWith("/three/")) return "three.js";
  if (/javascript/.test(type)) return "scripts";
  if (/wasm/.test(type)) return "WebAssembly";
  if (/gltf|glb/.test(type) || path.endsWith(".glb")) return "model";
  if (type.startsWith("image/")) return "pictures";
  if (/font/.test(type) || path.endsWith(".ttf")) return "fonts";
  return "HTML, CSS, JSON";
}

function loadSentence({ date, machine }: Circumstances): string {
  const [processor, cores] = machine.split(", ");
  return `A product page with nothing cached, until the product can be worked on: medians of ${rounds} loads on ${date.slice(0, 10)}, on
${processor}, ${cores}, WebGL on the processor ([how it is measured](bench/README.md#loading-a-product-page)).`;
}

async function writeReadme(tables: string): Promise<void> {
  const file = fileURLToPath(new URL("../../README.md", import.meta.url));
  const text = await readFile(file, "utf8");
  const [start, end] = [text.indexOf(README_START) + README_START.length, text.indexOf(README_END)];
  if (start < README_START.length || end < start) throw new Error(`README.md lacks ${README_START} … ${README_END}`);
  await writeFile(file, `${text.slice(0, start)}\n${tables}\n\n${text.slice(end)}`);
}

function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] as number;
}

function medians(loads: readonly Load[]): Load {
  const bytes = Object.fromEntries(KINDS.map((kind) => [kind, median(loads.map((one) => one.bytes[kind]))])) as Bytes;
  return { poster: median(loads.map((one) => one.poster)), ready: median(loads.map((one) => one.ready)), bytes };
}

/** What an import costs: the script and all that it imports at once, bytes after gzip. */
async function packageSizes(): Promise<Readonly<Record<string, number>>> {
  const sources = new Map<string, string>();
  const follow = async (name: string, seen: Set<string>): Promise<Set<string>> => {
    if (seen.has(name)) return seen;
    seen.add(name);
    const source = await readFile(join(DIST, name), "utf8");
    sources.set(name, source);
    for (const [, next = ""] of source.matchAll(/(?:from|import)\s*"\.\/([\w-]+\.js)"/g)) await follow(next, seen);
    return seen;
  };
  const packed = (bytes: string | Uint8Array): number => gzipSync(bytes, { level: 9 }).length;
  const scripts = async (name: string): Promise<number> =>
    [...(await follow(name, new Set()))].reduce((sum, one) => sum + packed(sources.get(one) ?? ""), 0);
  return {
    "`texelcast/embed`": await scripts("embed.js"),
    "`texelcast/core`, page's half": await scripts("core.js"),
    "the engine's worker": await scripts("engine-worker.js"),
    "the core's WebAssembly": packed(await readFile(join(DIST, "assets/texelcast.wasm"))),
  };
}

function formatTimes(): string {
  return formatTable(rows, 2, [
    ["page", ({ page }) => PAGE_NAMES[page]],
    ["network, page's thread", ({ condition }) => condition],
    ["poster", ({ poster }) => seconds(poster)],
    ["ready", ({ ready }) => seconds(ready)],
    ["bytes until then", ({ bytes }) => kilobytes(KINDS.reduce((sum, kind) => sum + bytes[kind], 0))],
  ]);
}

/** Of the first condition: they are the same in all. */
function formatBytes(): string {
  const firsts = rows.filter(({ condition }) => condition === CONDITIONS[0]?.name);
  return formatTable(firsts, 1, [
    ["sent until ready", ({ page }) => PAGE_NAMES[page]],
    ...KINDS.map((kind) => [kind, ({ bytes }: Row) => (bytes[kind] === 0 ? "" : kilobytes(bytes[kind]))] as const),
  ]);
}

function formatSizes(sizes: Readonly<Record<string, number>>): string {
  return formatTable(Object.entries(sizes), 1, [
    ["what a page loads, gzip", ([name]) => name],
    ["bytes", ([, bytes]) => kilobytes(bytes)],
  ]);
}

function seconds(milliseconds: number): string {
  return `${(milliseconds / 1000).toFixed(2)} s`;
}

function kilobytes(bytes: number): string {
  return `${(bytes / 1000).toFixed(bytes < 10_000 ? 1 : 0)} kB`;
}

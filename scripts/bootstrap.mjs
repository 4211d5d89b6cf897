/**
 * Brings a checkout to where a command can run: packages, WebAssembly module, demo assets, command line, test tools.
 * Uses Node's built-ins alone, since it runs before `npm ci`. A run with nothing to do takes well under 300 ms.
 *
 *   node scripts/bootstrap.mjs start|build|storefront|cli|package|test|lint|bench|figures|bench:browser|bench:load [--quiet]
 */
import { pathToFileURL } from "node:url";
import { testTools } from "./bootstrap/build-tools.mjs";
import { chromium } from "./bootstrap/chromium.mjs";
import { firefox } from "./bootstrap/firefox.mjs";
import { withLock } from "./bootstrap/lock.mjs";
import { nodePackages } from "./bootstrap/node-packages.mjs";
import { oldestChromium } from "./bootstrap/oldest-chromium.mjs";
import {
  basisGlue,
  commandLine,
  demoAssets,
  designSchema,
  npmPackage,
  storefrontPages,
  storefrontServer,
  wasmModule,
} from "./bootstrap/products.mjs";
import { Progress } from "./bootstrap/progress.mjs";
import { SetUpError } from "./bootstrap/set-up-error.mjs";
import { provide } from "./bootstrap/system.mjs";
import { webkit } from "./bootstrap/webkit.mjs";

const OLDEST_NODE = [20, 19];

/** What each command needs, in the order in which it can be made. */
const GOALS = {
  start: [nodePackages, wasmModule, basisGlue, demoAssets],
  build: [nodePackages, wasmModule, basisGlue, demoAssets, designSchema],
  storefront: [nodePackages, wasmModule, basisGlue, demoAssets, storefrontPages, storefrontServer],
  cli: [nodePackages, wasmModule, basisGlue, designSchema, commandLine],
  package: [nodePackages, wasmModule, basisGlue, designSchema, npmPackage],
  test: [
    ...[nodePackages, testTools, chromium, oldestChromium, firefox, webkit, wasmModule, basisGlue],
    ...[demoAssets, designSchema],
    ...[commandLine, npmPackage, storefrontPages, storefrontServer],
  ],
  lint: [nodePackages, basisGlue, testTools],
  bench: [nodePackages, testTools, wasmModule, basisGlue],
  figures: [nodePackages, chromium, wasmModule, basisGlue, demoAssets],
  "bench:browser": [nodePackages, chromium, wasmModule, basisGlue, demoAssets],
  "bench:load": [
    nodePackages,
    chromium,
    wasmModule,
    basisGlue,
    demoAssets,
    designSchema,
    npmPackage,
    storefrontPages,
    storefrontServer,
  ],
};

/**
 * @param {keyof typeof GOALS} goal
 * @param {{quiet?: boolean}} [options] quiet: print nothing while there is nothing to do
 */
export async function bootstrap(goal, { quiet = false } = {}) {
  const start = performance.now();
  const progress = new Progress({ quiet });
  checkNode();
  const steps = GOALS[goal];
  if (!steps.every((step) => step.isFresh())) {
    await withLock(progress, async () => {
      // First: the message about what is missing may name a program that comes with the packages.
      await nodePackages.bringUpToDate(progress);
      // All at once, so that nobody installs one thing only to be told of the next.
      await provide(missing(steps.filter((step) => !step.isFresh())), progress);
      for (const step of steps) await step.bringUpToDate(progress);
    });
  }
  progress.end(performance.now() - start);
}

/**
 * The same for a script: where it fails, prints why and ends the process with exit code 1.
 * @param {keyof typeof GOALS} goal @param {{quiet?: boolean}} [options]
 */
export async function bootstrapOrExit(goal, options) {
  try {
    await bootstrap(goal, options);
  } catch (error) {
    const reason = error instanceof SetUpError ? error.message : error instanceof Error ? error.stack : String(error);
    process.stderr.write(`\n${reason}\n`);
    process.exit(1);
  }
}

/**
 * What the steps lack, each thing once.
 * @param {readonly import("./bootstrap/stamps.mjs").Step[]} steps
 */
function missing(steps) {
  const needs = steps.flatMap((step) => step.needs?.() ?? []);
  return [...new Map(needs.map((need) => [need.debian, need])).values()];
}

function checkNode() {
  const [major, minor] = process.versions.node.split(".").map(Number);
  if (major > OLDEST_NODE[0] || (major === OLDEST_NODE[0] && minor >= OLDEST_NODE[1])) return;
  throw new SetUpError(
    `This is Node.js ${process.versions.node}; Texelcast needs ${OLDEST_NODE.join(".")} or newer. Get it from https://nodejs.org`,
  );
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const goal = process.argv[2];
  if (!goal || !Object.hasOwn(GOALS, goal)) {
    process.stderr.write(`Name what to set up for: ${Object.keys(GOALS).join(", ")}\n`);
    process.exit(2);
  }
  await bootstrapOrExit(/** @type {keyof typeof GOALS} */ (goal), { quiet: process.argv.includes("--quiet") });
}

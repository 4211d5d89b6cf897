/** The kinds of test, in the order in which they run: the quick and telling first. */
import { readdirSync, rmSync } from "node:fs";
import { join } from "node:path";
import { nativeEnvironment, wasmEnvironment } from "../bootstrap/build-tools.mjs";
import { findChromium } from "../bootstrap/chromium.mjs";
import { buildPreset } from "../bootstrap/cmake.mjs";
import { whyNoFirefox } from "../bootstrap/firefox.mjs";
import { BUILD, inRoot } from "../bootstrap/paths.mjs";
import { runVisibly } from "../bootstrap/run.mjs";
import { whyNoWebkit } from "../bootstrap/webkit.mjs";
import { CHECKS } from "../lint/checks.mjs";
import { doctestCounts, playwrightCounts, vitestCounts } from "./counts.mjs";
import { runInParts } from "./doctest-parts.mjs";
import { freePort } from "./free-port.mjs";
import { runAndRead } from "./run-and-read.mjs";

/** @typedef {import("./counts.mjs").Counts} Counts */
/**
 * @typedef {object} Stage
 * @property {string} key
 * @property {string} title
 * @property {boolean} [onSite] it drives the static site, which must be of these sources
 * @property {(args: readonly string[]) => Promise<Counts>} run
 */

const RESULTS = join(BUILD, "test-results");
const EXECUTABLE = process.platform === "win32" ? "core_tests.exe" : "core_tests";

/** @type {readonly Stage[]} */
export const STAGES = [
  { key: "lint", title: "Format and lint", run: lint },
  { key: "native", title: "Core, natively", run: (args) => nativeTests("native", args) },
  { key: "asan", title: "Core, natively, under ASan and UBSan", run: (args) => nativeTests("native-asan", args) },
  { key: "wasm", title: "Core, in WebAssembly", run: wasmTests },
  { key: "vitest", title: "Engine, document, command line, viewer and scripts (vitest)", run: (args) => vitest(args) },
  { key: "build", title: "Static site (npm run build)", run: siteBuild },
  { key: "e2e", title: "The page in Chromium (Playwright)", onSite: true, run: playwright },
  {
    key: "firefox",
    title: "The page in Firefox (WebDriver BiDi)",
    onSite: true,
    run: (args) => otherBrowser("firefox", whyNoFirefox(), args),
  },
  {
    key: "webkit",
    title: "The page in WebKit (WebDriver)",
    onSite: true,
    run: (args) => otherBrowser("webkit", whyNoWebkit(), args),
  },
];

/** The stages of these keys, and the site's build before those that drive it. @param {readonly string[]} keys */
export function stagesOf(keys) {
  const drivesSite = STAGES.some(({ key, onSite }) => onSite && keys.includes(key));
  return STAGES.filter(({ key }) => keys.includes(key) || (key === "build" && drivesSite));
}

async function lint() {
  const counts = { passed: 0, failed: 0, skipped: 0 };
  for (const check of CHECKS) {
    const result = await check.run({ write: false });
    console.log(`${result.padEnd(8)}${check.name}`);
    counts[result] += 1;
  }
  return counts;
}

/** @param {"native" | "native-asan"} preset @param {readonly string[]} args */
async function nativeTests(preset, args) {
  await buildPreset(preset, preset, nativeEnvironment());
  return coreTests(inRoot("build", preset, EXECUTABLE), [], args);
}

/** @param {readonly string[]} args */
async function wasmTests(args) {
  await buildPreset("wasm", "wasm-tests", wasmEnvironment());
  return coreTests(process.execPath, [inRoot("scripts/run-core-tests.mjs")], args);
}

/** In parts side by side, or as the arguments say. @param {string} program @param {readonly string[]} before @param {readonly string[]} args */
async function coreTests(program, before, args) {
  if (args.length > 0) return doctestCounts(await runAndRead(program, [...before, ...args], { show: true }));
  const files = readdirSync(inRoot("tests", "native")).filter((name) => name.endsWith("_test.cpp"));
  return runInParts(files, (part) => runAndRead(program, [...before, ...part]));
}

/** @param {readonly string[]} args @param {string} [report] its file's name */
async function vitest(args, report = "vitest.json") {
  const file = freshReport(report);
  const reporters = ["--reporter=default", "--reporter=json", `--outputFile.json=${file}`];
  const exitCode = await runVisibly(process.execPath, [
    inRoot("node_modules/vitest/vitest.mjs"),
    "run",
    ...reporters,
    ...args,
  ]);
  return vitestCounts(file, exitCode);
}

/**
 * @param {"firefox" | "webkit"} name of its folder @param {string | null} lack why it cannot be driven here
 * @param {readonly string[]} args
 */
async function otherBrowser(name, lack, args) {
  if (lack === null) return vitest(["--config", inRoot("tests", name, "vitest.config.ts"), ...args], `${name}.json`);
  console.log(`Skipped. ${lack}`);
  return { passed: 0, failed: 0, skipped: 1 };
}

async function siteBuild() {
  const exitCode = await runVisibly(process.execPath, [inRoot("scripts/build.mjs")]);
  return { passed: exitCode === 0 ? 1 : 0, failed: exitCode === 0 ? 0 : 1, skipped: 0 };
}

/** @param {readonly string[]} args */
async function playwright(args) {
  const report = freshReport("playwright.json");
  // Another checkout may be under test on this machine.
  const port = process.env.TEXELCAST_TEST_PORT ?? String(await freePort());
  const env = { ...process.env, TEXELCAST_CHROMIUM: findChromium() ?? "", TEXELCAST_TEST_PORT: port };
  const exitCode = await runVisibly(
    process.execPath,
    [inRoot("node_modules/@playwright/test/cli.js"), "test", ...args],
    env,
  );
  return playwrightCounts(report, exitCode);
}

/** The path for a runner's report, without one of an earlier run. @param {string} name */
function freshReport(name) {
  const file = join(RESULTS, name);
  rmSync(file, { force: true });
  return file;
}

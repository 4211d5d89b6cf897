/** What the package weighs, as a web server sends it, held by size-limit: .size-limit.mjs has the budgets. */
import { execFile } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import { gzipSync } from "node:zlib";
import { beforeAll, expect, test } from "vitest";
import { DIST, shopStages } from "../../scripts/package/stages.mjs";
import { CHECKOUT } from "./support/installed.ts";

interface Weighed {
  readonly name: string;
  readonly passed: boolean;
  readonly size: number;
}

let weighed: readonly Weighed[];
beforeAll(async () => {
  const script = join(CHECKOUT, "node_modules/size-limit/bin.js");
  // It ends with 1 where a budget is broken, and tells which all the same.
  const run = promisify(execFile)(process.execPath, [script, "--json"], { cwd: CHECKOUT });
  const { stdout } = await run.catch((ended: { stdout?: string }) => {
    if (!ended.stdout) throw ended;
    return { stdout: ended.stdout };
  });
  weighed = JSON.parse(stdout) as readonly Weighed[];
});

test.each([
  "element and engine, until the shop's product is shown",
  "a design on it, or zones: the desk",
  "a design on it: reading and checking",
  "the first touch, beside the desk",
  "the engine's WebAssembly",
  "the shop's side of the iframe",
  "the root import",
])("%s: within the budget", (name) => {
  const found = weighed.find((each) => each.name === name);
  expect(found, `size-limit weighs “${name}”`).toBeDefined();
  expect(found?.passed, `${found?.size} bytes`).toBe(true);
});

test.each([
  ["until the product is shown, and until it is touched", "shown"],
  ["with a design or zones, or at the first touch", "desk"],
  ["with a design, beside the desk", "design"],
  ["at the first touch, beside the desk", "touch"],
  ['`mode="full"`', "full"],
] as const)("what the package's page says of “%s” is what it weighs", (when, stage) => {
  const page = readFileSync(join(CHECKOUT, "docs/package.md"), "utf8");
  const row = page.split("\n").find((line) => line.startsWith(`| ${when} |`)) ?? "";
  const said = Number(/([\d.]+)[^|]*\|$/.exec(row.replace(/ \([^|]*\) \|$/, " |"))?.[1]);
  const scripts = [...shopStages()[stage]].map((name) => gzipSync(readFileSync(join(DIST, name)), { level: 9 }).length);
  const weighed = scripts.reduce((sum, bytes) => sum + bytes, 0) / 1000;
  expect(Math.abs(said - weighed) / weighed, `${said} kB said, ${weighed} kB weighed`).toBeLessThan(0.03);
});

/** What the package weighs, as a web server sends it, held by size-limit: .size-limit.mjs has the budgets. */
import { execFile } from "node:child_process";
import { join } from "node:path";
import { promisify } from "node:util";
import { beforeAll, expect, test } from "vitest";
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

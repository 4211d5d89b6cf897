/** The package's scripts under short names (scripts/package/short-names.mjs). */
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { SourceMap } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build } from "esbuild";
import { afterAll, beforeAll, expect, test } from "vitest";
import { contentHashes, shortenNames, shortNames } from "../../scripts/package/short-names.mjs";

let folder: string;
let dist: string;

/** An entry that asks for two scripts in one line, and what it does behind them. */
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "short-names-"));
  dist = join(folder, "dist");
  mkdirSync(dist);
  writeFileSync(join(folder, "one.ts"), "export const one = 1;\n");
  writeFileSync(join(folder, "two.ts"), "export const two = 2;\n");
  writeFileSync(
    join(folder, "entry.ts"),
    `console.log((await import("./one.ts")).one, (await import("./two.ts")).two);\nconsole.log("behind both");\n`,
  );
  await build({
    entryPoints: [join(folder, "entry.ts")],
    ...{ outdir: dist, bundle: true, splitting: true, minify: true, sourcemap: true, format: "esm" },
    ...{ target: "es2022", chunkNames: "page-[hash]", logLevel: "error" },
  });
  shortenNames(dist);
});
afterAll(() => rmSync(folder, { recursive: true }));

test("a hashed script has four letters, and so has its source map, and an entry keeps its name", () => {
  const scripts = readdirSync(dist).filter((name) => name.endsWith(".js"));
  expect(scripts).toHaveLength(3);
  expect(scripts).toContain("entry.js");
  for (const name of scripts.filter((each) => each !== "entry.js")) expect(name).toMatch(/^page-[a-z0-9]{4}\.js$/);
  expect(readdirSync(dist).filter((name) => name.endsWith(".map"))).toEqual(scripts.map((name) => `${name}.map`));
});

test("scripts ask for one another, and name their maps, by names that are there", () => {
  const named = readdirSync(dist)
    .filter((name) => name.endsWith(".js"))
    .flatMap((name) => readFileSync(join(dist, name), "utf8").match(/[\w-]+\.js(\.map)?/g) ?? []);
  expect(named).toHaveLength(5);
  for (const name of named) expect(readdirSync(dist)).toContain(name);
});

test("what stands behind a name in its line is where the source map says", () => {
  const lines = readFileSync(join(dist, "entry.js"), "utf8").split("\n");
  const line = lines.findIndex((each) => each.includes("behind both"));
  const map = new SourceMap(JSON.parse(readFileSync(join(dist, "entry.js.map"), "utf8")));
  const found = map.findEntry(line, lines[line]?.indexOf('"behind both"') ?? -1);
  expect(found).toMatchObject({ originalLine: 1, originalColumn: "console.log(".length });
  expect(found).toHaveProperty("originalSource", expect.stringMatching(/entry\.ts$/));
});

test("hashes that begin alike keep as many letters as tell them apart, and no other has more", () => {
  const files = ["page-ABCDEFGH.js", "page-ABCDEXYZ.js", "page-ABCE2345.js", "worker-ABCDEFGH.js", "define.js"];
  expect([...shortNames(files)]).toEqual([
    ["page-ABCDEFGH", "page-abcdef"],
    ["page-ABCDEXYZ", "page-abcdex"],
    ["page-ABCE2345", "page-abce"],
    ["worker-ABCDEFGH", "worker-abcd"],
  ]);
});

/** The new name of a script, when the scripts hold that. */
const namesOf = (texts: Readonly<Record<string, string>>) => contentHashes(new Map(Object.entries(texts)));
const SHELF = {
  "define.js": 'import"./page-AAAAAAAA.js"',
  "page-AAAAAAAA.js": 'import"./page-BBBBBBBB.js"',
  "page-BBBBBBBB.js": 'export let a=1;import("./page-AAAAAAAA.js")',
  "page-CCCCCCCC.js": "export let c=1",
};

test("a script whose content changed has another name, though the bundler called it the same, and so has who asks for it", () => {
  const before = namesOf(SHELF);
  const after = namesOf({ ...SHELF, "page-BBBBBBBB.js": 'export let b=1;import("./page-AAAAAAAA.js")' });
  for (const name of ["page-AAAAAAAA", "page-BBBBBBBB"]) {
    expect(before.get(name)).toMatch(/^page-[A-Z0-9]{8}$/);
    expect(after.get(name)).not.toBe(before.get(name));
  }
  expect(after.get("page-CCCCCCCC")).toBe(before.get("page-CCCCCCCC"));
});

test("what the bundler called a script makes no part of its name", () => {
  const renamed = Object.entries(SHELF).map(([name, text]) =>
    [name, text].map((each) => each.replaceAll("BBBBBBBB", "DDDDDDDD")),
  );
  const before = namesOf(SHELF);
  const after = namesOf(Object.fromEntries(renamed));
  expect(after.get("page-DDDDDDDD")).toBe(before.get("page-BBBBBBBB"));
  expect(after.get("page-AAAAAAAA")).toBe(before.get("page-AAAAAAAA"));
});

test("two scripts that ask for the same two in another order have names of their own", () => {
  const names = namesOf({
    "page-EEEEEEEE.js": 'import"./page-AAAAAAAA.js";import"./page-CCCCCCCC.js"',
    "page-FFFFFFFF.js": 'import"./page-CCCCCCCC.js";import"./page-AAAAAAAA.js"',
    "page-AAAAAAAA.js": "export let a=1",
    "page-CCCCCCCC.js": "export let c=1",
    "define.js": 'import"./page-EEEEEEEE.js";import"./page-FFFFFFFF.js"',
  });
  expect(new Set(names.values()).size).toBe(4);
});

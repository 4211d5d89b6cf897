/** What the package weighs, as a web server sends it: bytes after gzip. README's table has the figures of the day. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { afterAll, beforeAll, expect, test } from "vitest";
import { type InstalledPackage, installPackage } from "./support/installed.ts";

const DIST = "/node_modules/texelcast/dist";
/** Thousand bytes. */
const KB = 1000;

let installed: InstalledPackage;
beforeAll(async () => {
  installed = await installPackage();
});
afterAll(() => installed?.remove());

const gzipped = (path: string): number => gzipSync(readFileSync(join(installed.folder, path)), { level: 9 }).length;

/** A script and all that it imports at once, each file once. */
function withImports(path: string, seen = new Set<string>()): Set<string> {
  if (seen.has(path)) return seen;
  seen.add(path);
  const source = readFileSync(join(installed.folder, path), "utf8");
  for (const [, name] of source.matchAll(/(?:from|import)\s*"\.\/([\w-]+\.js)"/g)) withImports(`${DIST}/${name}`, seen);
  return seen;
}

const sum = (paths: Iterable<string>): number => [...new Set(paths)].reduce((bytes, path) => bytes + gzipped(path), 0);

test("the shop's side of the iframe is at most 10 kB", () => {
  expect(sum(withImports(`${DIST}/embed.js`))).toBeLessThanOrEqual(10 * KB);
});

test("the root import is at most 1 kB", () => {
  expect(sum(withImports(`${DIST}/index.js`))).toBeLessThanOrEqual(KB);
});

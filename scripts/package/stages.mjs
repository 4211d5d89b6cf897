/** What a page loads of the built package, and when: files by the moment that asks for them. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

export const DIST = inRoot("build/package/dist");

const AT_ONCE = /(?:\bfrom|\bimport)\s*"\.\/([\w-]+\.js)"/g;

/** A script and all that it imports at once, each file once. @param {string} name @returns {Set<string>} */
export function withImports(name, seen = new Set()) {
  if (seen.has(name)) return seen;
  seen.add(name);
  for (const [, each = ""] of readFileSync(join(DIST, name), "utf8").matchAll(AT_ONCE)) withImports(each, seen);
  return seen;
}

/** The page's script that a source went into. @param {string} source */
function scriptOf(source) {
  const found = readdirSync(DIST).find((name) => {
    if (!/^page-.*\.js\.map$/.test(name)) return false;
    const { sources } = JSON.parse(readFileSync(join(DIST, name), "utf8"));
    return sources.some((/** @type {string} */ each) => each.endsWith(source));
  });
  if (!found) throw new Error(`No script of the package holds ${source}.`);
  return found.replace(/\.map$/, "");
}

/** Each stage's scripts without those of the stages that it follows. */
export function shopStages() {
  const without = (/** @type {Iterable<string>} */ names, /** @type {Set<string>[]} */ ...before) =>
    new Set([...names].filter((name) => !before.some((each) => each.has(name))));
  const all = (/** @type {string[]} */ ...names) => new Set(names.flatMap((name) => [...withImports(name)]));
  const shown = all("define.js", scriptOf("shop/shop-mode.ts"), "engine-worker.js");
  const desk = without(all(scriptOf("shop/shop-bench.ts"), scriptOf("state/design-edits.ts")), shown);
  const reading = ["desk/read-design.ts", "document/parse-design.ts", "document/asset-check.ts"].map(scriptOf);
  const design = without(all(...reading), shown, desk);
  const touch = without(all(scriptOf("shop/shop-tools.ts"), scriptOf("viewer/decal-viewer.ts")), shown, desk);
  const full = without(all(scriptOf("full/full-mode.ts")), shown);
  return { shown, desk, design, touch, full };
}

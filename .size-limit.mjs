/** The package's budgets, for `npx size-limit`, after `npm run package`: bytes after gzip, three.js apart. */
import { join } from "node:path";
import { DIST, shopStages, withImports } from "./scripts/package/stages.mjs";
import { clangOf } from "./scripts/package/wasm-compiler.mjs";

const { shown, desk, design, touch } = shopStages();
const scripts = (names) => [...names].map((name) => join(DIST, name));
const budget = (name, path, limit) => ({ name, path, limit, gzip: true });

// What is published comes from Debian 12's Emscripten, which is clang 14. Later ones were up to 1.4 % larger (15 and 19).
const module = clangOf() === 14 ? "150 kB" : "153 kB";

export default [
  budget("element and engine, until the shop's product is shown", scripts(shown), "60 kB"),
  budget("a design on it, or zones: the desk", scripts(desk), "19 kB"),
  budget("a design on it: reading and checking", scripts(design), "20 kB"),
  budget("the first touch, beside the desk", scripts(touch), "48 kB"),
  budget("the engine's WebAssembly", [join(DIST, "assets/texelcast.wasm")], module),
  budget("the shop's side of the iframe", scripts(withImports("embed.js")), "10 kB"),
  budget("the root import", scripts(withImports("index.js")), "1 kB"),
];

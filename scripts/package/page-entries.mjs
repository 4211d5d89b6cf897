/**
 * Lets a bundle import the pages' own entries beside it in place of a copy of their sources: what both throw is then of one class.
 */
import { join, relative } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";
import { ENTRIES } from "./manifest.mjs";

/** @returns {import("esbuild").Plugin} */
export function pageEntries() {
  const files = new Map(
    Object.values(ENTRIES).flatMap(({ source, name, runs }) => (runs === "page" ? [[source, `./${name}.js`]] : [])),
  );
  return {
    name: "page-entries",
    setup(build) {
      build.onResolve({ filter: /^\.\/.*\.ts$/ }, ({ path, resolveDir, kind }) => {
        if (kind === "entry-point") return null;
        const file = files.get(relative(inRoot(), join(resolveDir, path)).replaceAll("\\", "/"));
        return file === undefined ? null : { path: file, external: true };
      });
    },
  };
}

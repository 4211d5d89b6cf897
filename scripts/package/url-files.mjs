/**
 * An esbuild plugin for `new URL("…", import.meta.url)`: what it names is laid beside the output under `assets/` (a .wasm, a
 * font), or built as a bundle of its own (a worker's script), and the address is written anew as a literal, which browsers,
 * Node and other people's bundlers follow alike.
 */
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { basename, dirname, resolve } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

const PATTERN = /new\s+URL\(\s*(["'])([^"'\n]+)\1\s*,\s*import\.meta\.url\s*,?\s*\)/g;

/**
 * An address that is all that a function has. What gathers a server's files (Nitro, Vercel, Next.js's "standalone") finds addresses in
 * statements alone, and would leave those files behind; a page's script comes out of its minifier as it was.
 */
const ALONE = /=>\s*(new URL\("[^"]+", import\.meta\.url\))/g;

/**
 * For old Cloudflare workers, in the pictures' decoders. It never runs elsewhere, and webpack, which writes a module's address in
 * place of `import.meta.url`, refuses a string that something is assigned to.
 */
const ASSIGNED = /\bif\s*\(import\.meta\.url\s*===\s*undefined\)\s*\{\s*import\.meta\.url\s*=\s*[^;}]+;?\s*\}/g;

/**
 * What the PNG decoder's glue asks of what it is given, to fetch its module by itself: it is always given the module, so no page
 * need load how else it could be had.
 */
const FETCHES =
  /typeof Response === 'function' && module instanceof Response|typeof input === 'string' \|\| \(.*\)(?=\) \{)/g;

/** What the bundles name: assets by file name in the package, workers by script name in the package. */
export class NamedFiles {
  /** @type {Map<string, string>} */
  assets = new Map();
  /** @type {Map<string, string>} */
  workers = new Map();

  /**
   * The address of a file in the package, seen from a script of it.
   * @param {string} file @returns {string}
   */
  addressOf(file) {
    const isScript = /\.ts$/.test(file);
    const name = isScript ? basename(file).replace(/\.ts$/, ".js") : basename(file);
    const known = isScript ? this.workers : this.assets;
    const other = known.get(name);
    if (other !== undefined && other !== file) throw new Error(`${other} and ${file} would both be ${name}`);
    known.set(name, file);
    return isScript ? `./${name}` : `./assets/${name}`;
  }
}

/**
 * @param {NamedFiles} files filled while the bundle is made
 * @returns {import("esbuild").Plugin}
 */
export function urlFiles(files) {
  return {
    name: "url-files",
    setup(build) {
      build.onLoad({ filter: /\.(ts|m?js)$/ }, async ({ path }) => {
        const source = await readFile(path, "utf8");
        if (!source.includes("import.meta.url")) return undefined;
        const contents = source
          .replace(ASSIGNED, "")
          .replace(FETCHES, "false")
          .replace(PATTERN, (whole, _quote, specifier) => {
            const file = locate(specifier, path);
            return file === null ? whole : `new URL(${JSON.stringify(files.addressOf(file))}, import.meta.url)`;
          })
          .replace(ALONE, "=> { return $1; }");
        return { contents, loader: path.endsWith(".ts") ? "ts" : "js", resolveDir: dirname(path) };
      });
      // Vite's way to say "as text".
      build.onResolve({ filter: /\?raw$/ }, ({ path, importer }) => ({
        path: createRequire(importer).resolve(path.replace(/\?raw$/, "")),
        namespace: "raw",
      }));
      build.onLoad({ filter: /./, namespace: "raw" }, async ({ path }) => ({
        contents: await readFile(path, "utf8"),
        loader: "text",
      }));
      // In the package every file lies where its literal says, in Node too.
      build.onResolve({ filter: /^\.\/package-file\.ts$/ }, ({ resolveDir }) =>
        resolveDir === inRoot("web/engine") ? { path: inRoot("web/package/package-file.ts") } : undefined,
      );
    },
  };
}

/**
 * The file that a specifier names: beside the source, else in an npm package. Null: no file (an address such as ".").
 * @param {string} specifier @param {string} source @returns {string | null}
 */
function locate(specifier, source) {
  const beside = resolve(dirname(source), specifier);
  if (/\.\w+$/.test(specifier) && existsSync(beside)) return beside;
  if (specifier.startsWith(".")) return null;
  try {
    return createRequire(source).resolve(specifier);
  } catch {
    return null;
  }
}

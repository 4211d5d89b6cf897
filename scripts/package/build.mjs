/**
 * The npm package, whole, in build/package. Its scripts hold all that they need but three.js, which a page has once for all:
 * the same scripts serve an import map, a bundler and Node, and `npm install texelcast` brings nothing else.
 */
import { chmodSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { build } from "esbuild";
import { inRoot } from "../bootstrap/paths.mjs";
import { declarations } from "./declarations.mjs";
import { writeDocuments } from "./documents.mjs";
import { elementManifest } from "./element-manifest.mjs";
import { leftOut } from "./left-out.mjs";
import { licenceText } from "./licences.mjs";
import { ENTRIES, manifestOf } from "./manifest.mjs";
import { mergeChunks } from "./merge-chunks.mjs";
import { noNode } from "./no-node.mjs";
import { pageEntries } from "./page-entries.mjs";
import { shortenNames } from "./short-names.mjs";
import { shrinkScripts } from "./shrink.mjs";
import { tightStyles } from "./tight-styles.mjs";
import { NamedFiles, urlFiles } from "./url-files.mjs";

const PACKAGE = inRoot("build/package");
const DIST = join(PACKAGE, "dist");

/**
 * What a shop's page loads, moment by moment: what shows a product; what takes hold of it, which is 2.3 kB less as one file, for half a
 * kilobyte more of the full mode. (The desk as one would be 1.8 kB less, the full mode 2.4 kB more and that file 0.8 kB.)
 */
const MOMENTS = [["web/element/define.ts", "web/element/shop/shop-mode.ts"], ["web/viewer/decal-viewer.ts"]];

/** @type {import("esbuild").BuildOptions} */
const SHARED = {
  absWorkingDir: inRoot(),
  outdir: DIST,
  bundle: true,
  format: "esm",
  target: "es2022",
  sourcemap: true,
  metafile: true,
  legalComments: "none",
  logLevel: "warning",
};

/** What runs in a page or in its workers. @type {import("esbuild").BuildOptions} */
const FOR_PAGES = {
  platform: "browser",
  splitting: true,
  minify: true,
  // Packages for both ask for Node's `process` before they take its branch: a page's scripts have none, whatever a bundler lays there.
  // @jsquash's codecs ask whether they run in a service worker, where they give it what it lacks: neither pages nor their workers are one.
  define: { process: "undefined", "globalThis.ServiceWorkerGlobalScope": "undefined" },
};

/**
 * Bundles with all that goes for every script of the package; `moments` are of sources that are loaded as a whole.
 * @typedef {(own: import("esbuild").BuildOptions, moments?: readonly (readonly string[])[]) => Promise<void>} Bundle
 */

const ALL_ENTRIES = Object.values(ENTRIES);

export async function buildPackage() {
  rmSync(PACKAGE, { recursive: true, force: true });
  mkdirSync(join(DIST, "assets"), { recursive: true });
  const files = new NamedFiles();
  /** @type {Set<string>} */
  const inputs = new Set();
  /** @type {Bundle} */
  const bundle = async (own, moments = []) => {
    const options = { ...SHARED, ...own };
    const plugins = [
      urlFiles(files),
      tightStyles(),
      ...(own.platform === "browser" ? [noNode(), leftOut()] : []),
      ...(own.plugins ?? []),
    ];
    const { metafile } = await build({ ...options, metafile: true, plugins });
    for (const input of Object.keys(metafile.inputs)) inputs.add(inRoot(input));
    if (moments.length > 0) await mergeChunks({ dist: DIST, metafile, moments, options });
  };

  await bundleForPages(bundle, files);
  // Before a server's scripts come to them, which nobody downloads by the visit.
  await shrinkScripts(DIST);
  shortenNames(DIST);
  await bundleForServers(bundle);
  for (const [name, file] of files.assets) cpSync(file, join(DIST, "assets", name));
  await addRest([...inputs, ...files.assets.values()]);
}

/** @param {Bundle} bundle @param {NamedFiles} files */
async function bundleForPages(bundle, files) {
  await bundle(
    {
      entryPoints: entriesOf(ALL_ENTRIES.filter(({ runs }) => runs === "page")),
      ...FOR_PAGES,
      chunkNames: "page-[hash]",
      external: ["three", "three/*"],
    },
    MOMENTS,
  );
  // For pages without a bundler and without import maps, which a strict policy refuses: three.js is inside.
  await bundle({
    entryPoints: [{ in: "web/element/define.ts", out: "standalone" }],
    ...FOR_PAGES,
    chunkNames: "standalone-[hash]",
  });
  // Of files that ask for nothing: what runs it may have no modules of Node's.
  await bundle({
    entryPoints: ALL_ENTRIES.flatMap(({ name, edge }) => (edge ? [{ in: edge, out: `${name}-edge` }] : [])),
    platform: "neutral",
    minify: true,
    plugins: [pageEntries()],
  });
  // Bundles of their own: a worker sees no import map, and must not load the page's half.
  for (const [name, source] of files.workers) {
    await bundle(
      {
        entryPoints: [{ in: source, out: name.replace(/\.js$/, "") }],
        ...FOR_PAGES,
        chunkNames: "worker-[hash]",
      },
      [[relative(inRoot(), source)]],
    );
  }
}

/** With the command line. @param {Bundle} bundle */
async function bundleForServers(bundle) {
  const servers = ALL_ENTRIES.flatMap(({ name, server }) =>
    server ? [{ source: server, name: `${name}-server` }] : [],
  );
  await bundle({
    entryPoints: [
      ...entriesOf([...ALL_ENTRIES.filter(({ runs }) => runs === "node"), ...servers]),
      { in: "node/cli.ts", out: "cli" },
    ],
    platform: "node",
    target: "node20",
    splitting: true,
    chunkNames: "node-[hash]",
    // What a server logs of an error begins with its class's name.
    keepNames: true,
    // Draco's glue is CommonJS: it asks for both at once, before it looks at the WebAssembly that it is given.
    define: { __dirname: "import.meta.dirname" },
    banner: {
      js: 'import { createRequire as __createRequire } from "node:module"; const require = __createRequire(import.meta.url);',
    },
  });
  const cli = join(DIST, "cli.js");
  writeFileSync(cli, `#!/usr/bin/env node\n${readFileSync(cli, "utf8")}`);
  chmodSync(cli, 0o755);
}

/** What lies beside the scripts. @param {readonly string[]} inputs files that they were made of */
async function addRest(inputs) {
  cpSync(inRoot("LICENSE"), join(PACKAGE, "LICENSE"));
  for (const schema of ["design", "zones"]) {
    cpSync(inRoot(`build/${schema}.schema.json`), join(PACKAGE, `${schema}.schema.json`));
  }
  cpSync(inRoot("web/element/wording"), join(PACKAGE, "wording"), { recursive: true });
  writeFileSync(
    join(PACKAGE, "custom-elements.json"),
    `${JSON.stringify(elementManifest("dist/define.js"), null, 2)}\n`,
  );
  writeFileSync(join(PACKAGE, "THIRD-PARTY-LICENCES.txt"), licenceText(inputs));
  const checkout = JSON.parse(readFileSync(inRoot("package.json"), "utf8"));
  writeFileSync(join(PACKAGE, "package.json"), `${JSON.stringify(manifestOf(checkout), null, 2)}\n`);
  await declarations(
    ALL_ENTRIES.map(({ source }) => source),
    join(PACKAGE, "types"),
  );
  writeDocuments(PACKAGE);
}

/** @param {readonly {source: string, name: string}[]} entries */
const entriesOf = (entries) => entries.map(({ source, name }) => ({ in: source, out: name }));

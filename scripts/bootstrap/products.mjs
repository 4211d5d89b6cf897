/**
 * What the checkout builds for itself: the WebAssembly module, the demo's assets, the design's schema, the command
 * line, the npm package.
 */
import { chmodSync } from "node:fs";
import { writeBasisGlue } from "./basis-glue.mjs";
import { wasmEnvironment, wasmNeeds } from "./build-tools.mjs";
import { buildPreset } from "./cmake.mjs";
import { inRoot } from "./paths.mjs";
import { run } from "./run.mjs";
import { stampedStep } from "./stamps.mjs";

export const wasmModule = stampedStep({
  name: "wasm",
  title: "the core as WebAssembly (build/wasm)",
  inputs: ["CMakeLists.txt", "CMakePresets.json", "cmake", "wasm"],
  outputs: ["build/wasm/texelcast.wasm"],
  needs: wasmNeeds,
  work: async () => buildPreset("wasm", "wasm", wasmEnvironment()),
});

export const basisGlue = stampedStep({
  name: "basis",
  title: "the decoder of KTX2 textures (build/basis)",
  inputs: ["package-lock.json", "scripts/bootstrap/basis-glue.mjs", "scripts/bootstrap/embind-without-eval.mjs"],
  outputs: ["build/basis/basis-transcoder.js", "build/basis/basis-transcoder.d.ts"],
  work: async () => writeBasisGlue(),
});

/** @param {string} script in the checkout */
const runScript = (script) => run(process.execPath, [inRoot("node_modules/tsx/dist/cli.mjs"), script]);

export const demoAssets = stampedStep({
  name: "demo",
  title: "the demo's models and decals (build/public/demo)",
  inputs: ["scripts/demo", "package-lock.json"],
  outputs: ["build/public/demo/demo.json", "build/public/shop/products.json"],
  work: () => runScript("scripts/demo/main.ts"),
});

export const designSchema = stampedStep({
  name: "design-schema",
  title: "the JSON Schemas of designs and zones (build/*.schema.json)",
  inputs: ["web/editor/document", "scripts/schema", "package-lock.json"],
  outputs: ["build/design.schema.json", "build/zones.schema.json"],
  work: () => runScript("scripts/schema/main.ts"),
});

export const commandLine = stampedStep({
  name: "command-line",
  title: "the command line (build/node)",
  inputs: [
    ...["node", "web/core", "web/engine", "web/editor/document", "build/basis"],
    ...["package.json", "scripts/bootstrap/products.mjs"],
  ],
  outputs: ["build/node/texelcast.mjs"],
  work: async () => {
    await bundleForNode("node/cli.ts", "build/node/texelcast.mjs", "#!/usr/bin/env node");
    chmodSync(inRoot("build/node/texelcast.mjs"), 0o755);
  },
});

export const storefrontServer = stampedStep({
  name: "storefront-server",
  title: "the example shop's order server (build/node)",
  inputs: [
    ...["node", "web/core", "web/engine", "web/editor/document", "web/storefront/api", "build/basis"],
    ...["package.json", "scripts/bootstrap/products.mjs"],
  ],
  outputs: ["build/node/storefront.mjs", "build/node/storefront-press.mjs"],
  work: async () => {
    await bundleForNode("node/storefront/main.ts", "build/node/storefront.mjs");
    await bundleForNode("node/storefront/press-worker.ts", "build/node/storefront-press.mjs");
  },
});

export const storefrontPages = stampedStep({
  name: "storefront-pages",
  title: "the example shop's pages (build/storefront)",
  inputs: [
    "web",
    "build/basis",
    "scripts/demo",
    "wasm",
    "vite.config.ts",
    "vite.storefront.config.ts",
    "scripts/site-files.ts",
    "scripts/watlas-without-eval.ts",
    "package-lock.json",
  ],
  outputs: ["build/storefront/index.html", "build/storefront/shop/products.json"],
  work: async () => {
    const { build } = await import("vite");
    await build({ configFile: inRoot("vite.storefront.config.ts"), logLevel: "warn" });
  },
});

export const npmPackage = stampedStep({
  name: "package",
  title: "the npm package (build/package)",
  inputs: [
    "build/wasm/texelcast.wasm",
    "build/basis",
    "node",
    "package-lock.json",
    "package.json",
    "scripts/package",
    "web",
    "README.md",
    "CHANGELOG.md",
  ],
  outputs: ["build/package/package.json"],
  work: async () => (await import("../package/build.mjs")).buildPackage(),
});

/**
 * One file of our own sources. Packages stay where npm put them: several look for their .wasm beside themselves. Our own
 * module is found at ../wasm/texelcast.wasm, as deep below build/ as the sources are below the checkout.
 * @param {string} entry @param {string} outfile @param {string} [banner] its first line
 */
async function bundleForNode(entry, outfile, banner) {
  const { build } = await import("esbuild");
  await build({
    absWorkingDir: inRoot(),
    entryPoints: [entry],
    outfile,
    bundle: true,
    packages: "external",
    platform: "node",
    format: "esm",
    target: "node20",
    sourcemap: true,
    ...(banner && { banner: { js: banner } }),
    logLevel: "silent",
    legalComments: "none",
  });
}

/**
 * Runs the core's tests as WebAssembly: `node scripts/run-core-tests.mjs [doctest options]`.
 * node:wasi gives the module a terminal and a clock, and nothing else of this machine.
 */
import { readFileSync } from "node:fs";
import { WASI } from "node:wasi";
import { inRoot } from "./bootstrap/paths.mjs";

const wasi = new WASI({
  version: "preview1",
  args: ["core_tests", ...process.argv.slice(2)],
  env: {},
  preopens: {},
  returnOnExit: true,
});
const module = await WebAssembly.compile(readFileSync(inRoot("build", "wasm", "core_tests.wasm")));
const environment = Object.fromEntries(
  WebAssembly.Module.imports(module)
    .filter((entry) => entry.module === "env")
    .map(({ name }) => [name, name === "emscripten_notify_memory_growth" ? () => {} : () => refuse(name)]),
);
const instance = await WebAssembly.instantiate(module, {
  env: environment,
  wasi_snapshot_preview1: wasi.wasiImport,
});
process.exitCode = wasi.start(instance);

/** @param {string} name */
function refuse(name) {
  throw new Error(`the core called ${name}, which no host offers`);
}

/** `npm run bench`: builds the benchmark's yardstick natively and as WebAssembly, then runs bench/main.ts. */
import { BENCH, checkOptionsOrExit } from "../bench/options.mjs";
import { nativeEnvironment, wasmEnvironment } from "./bootstrap/build-tools.mjs";
import { buildPreset } from "./bootstrap/cmake.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { runVisibly } from "./bootstrap/run.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const words = process.argv.slice(2);
checkOptionsOrExit(words, BENCH);
await bootstrapOrExit("bench", { quiet: true });
await buildPreset("native-bench", "native-bench", nativeEnvironment());
await buildPreset("wasm-bench", "wasm-bench", wasmEnvironment());
process.exitCode = await runVisibly(process.execPath, [
  inRoot("node_modules/tsx/dist/cli.mjs"),
  inRoot("bench/main.ts"),
  ...words,
]);

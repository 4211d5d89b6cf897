/** `npm run bench`: builds the benchmark's yardstick natively and as WebAssembly, then runs bench/main.ts. */
import { provideNativeTools, provideWasmTools } from "./bootstrap/build-tools.mjs";
import { buildPreset } from "./bootstrap/cmake.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { Progress } from "./bootstrap/progress.mjs";
import { runVisibly } from "./bootstrap/run.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("bench", { quiet: true });
const progress = new Progress({ quiet: true });
await buildPreset("native-bench", "native-bench", await provideNativeTools(progress));
await buildPreset("wasm-bench", "wasm-bench", await provideWasmTools(progress));
const args = [inRoot("node_modules/tsx/dist/cli.mjs"), inRoot("bench/main.ts"), ...process.argv.slice(2)];
process.exitCode = await runVisibly(process.execPath, args);

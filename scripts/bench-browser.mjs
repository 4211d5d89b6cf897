/** `npm run bench:browser`: the benchmark's work in Chromium, beside Babylon.js and three.js (bench/browser/main.ts). */
import { BROWSER_BENCH, checkOptionsOrExit } from "../bench/options.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { runVisibly } from "./bootstrap/run.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const words = process.argv.slice(2);
checkOptionsOrExit(words, BROWSER_BENCH);
await bootstrapOrExit("bench:browser", { quiet: true });
process.exitCode = await runVisibly(process.execPath, [
  inRoot("node_modules/tsx/dist/cli.mjs"),
  inRoot("bench/browser/main.ts"),
  ...words,
]);

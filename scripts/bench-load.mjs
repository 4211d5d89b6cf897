/** `npm run bench:load`: how long a product page takes to load, and how many bytes (bench/load/main.ts). */
import { LOAD_BENCH, parseLoadOptions } from "../bench/load/options.mjs";
import { checkOrExit } from "../bench/options.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { runVisibly } from "./bootstrap/run.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

const words = process.argv.slice(2);
checkOrExit(LOAD_BENCH.name, LOAD_BENCH.help, () => parseLoadOptions(words));
await bootstrapOrExit("bench:load", { quiet: true });
process.exitCode = await runVisibly(process.execPath, [
  inRoot("node_modules/tsx/dist/cli.mjs"),
  inRoot("bench/load/main.ts"),
  ...words,
]);

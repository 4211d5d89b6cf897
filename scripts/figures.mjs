/** `npm run figures`: builds the site and writes the paper's teaser, panel by panel, into docs/figures (scripts/figures). */
import { inRoot } from "./bootstrap/paths.mjs";
import { runVisibly } from "./bootstrap/run.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("figures");
process.exitCode = await runVisibly(process.execPath, [
  inRoot("node_modules/tsx/dist/cli.mjs"),
  inRoot("scripts/figures/main.ts"),
]);

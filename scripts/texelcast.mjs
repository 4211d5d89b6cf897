/** `npm run --silent texelcast -- …`: the command line of this checkout, brought up to date first. */
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("cli", { quiet: true });
// npm runs scripts in the package's own folder; paths that the user typed are meant from where npm was called.
if (process.env.INIT_CWD) process.chdir(process.env.INIT_CWD);
await import(new URL("../build/node/texelcast.mjs", import.meta.url).href);

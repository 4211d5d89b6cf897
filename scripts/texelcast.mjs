/** `npm run --silent texelcast -- …`: the command line of this checkout, brought up to date first. */
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("cli", { quiet: true });
await import(new URL("../build/node/texelcast.mjs", import.meta.url).href);

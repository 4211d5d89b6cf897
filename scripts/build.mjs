/** `npm run build`: sets up, then writes the static site into build/site. */

import { inRoot } from "./bootstrap/paths.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("build");
const { build } = await import("vite");
await build({ configFile: inRoot("vite.config.ts") });

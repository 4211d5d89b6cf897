/** `npm run package`: sets up, then makes the npm package in build/package. */
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("package");

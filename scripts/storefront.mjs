/**
 * `npm run storefront`: sets up, builds the example shop's pages and its order server, and opens it.
 *   npm run storefront -- [--port 8787] [--host localhost] [--data FOLDER]
 */
import { bootstrapOrExit } from "./bootstrap.mjs";

await bootstrapOrExit("storefront");
await import(new URL("../build/node/storefront.mjs", import.meta.url).href);

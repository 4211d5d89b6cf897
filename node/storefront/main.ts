/**
 * Starts the example shop; `npm run storefront` builds its pages first.
 *   node build/node/storefront.mjs [--port 8787] [--host localhost] [--site FOLDER] [--data FOLDER]
 */
import { mkdir } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { createShopServer } from "./shop-server.ts";

const DEFAULT_PORT = 8787;
const MOST_PORT = 65_535;

/** Seen from the bundle, in build/node. */
const beside = (folder: string): string => fileURLToPath(new URL(`../${folder}`, import.meta.url));

const { values } = parseArgs({
  options: {
    port: { type: "string", default: process.env.PORT ?? String(DEFAULT_PORT) },
    host: { type: "string", default: "localhost" },
    site: { type: "string", default: beside("storefront") },
    data: { type: "string", default: beside("storefront-data") },
  },
});
const { port: given, host, site, data } = values;
const port = Number(given);
if (!/^\d+$/.test(given) || port > MOST_PORT)
  refuse(`The port must be a number from 0 to ${MOST_PORT}, is "${given}".`);

await mkdir(data, { recursive: true });
const { app } = await createShopServer({
  site: path.resolve(site),
  store: path.join(data, "files"),
  database: path.join(data, "shop.sqlite"),
});
for (const signal of ["SIGINT", "SIGTERM"] as const) process.once(signal, () => void app.close());
try {
  process.stdout.write(`The shop is open: ${await app.listen({ port, host })}\n`);
} catch (error) {
  await app.close();
  const taken = (error as NodeJS.ErrnoException).code === "EADDRINUSE";
  if (!taken) throw error;
  refuse(`Port ${port} is taken: name another with --port.`);
}

function refuse(reason: string): never {
  process.stderr.write(`${reason}\n`);
  process.exit(2);
}

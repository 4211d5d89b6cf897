/**
 * Starts the example shop; `npm run storefront` builds its pages first.
 *   node build/node/storefront.mjs --site FOLDER --data FOLDER [--port 8787] [--host localhost]
 */
import { mkdir } from "node:fs/promises";
import path from "node:path";
import { parseArgs } from "node:util";
import { createShopServer } from "./shop-server.ts";

const DEFAULT_PORT = 8787;
const MOST_PORT = 65_535;

const { values } = parseArgs({
  options: {
    site: { type: "string" },
    data: { type: "string" },
    port: { type: "string" },
    host: { type: "string", default: "localhost" },
  },
});
const { site, data, host } = values;
if (site === undefined || data === undefined) refuse("Name the built pages and where data is kept: --site, --data.");
const given = values.port ?? process.env.PORT ?? String(DEFAULT_PORT);
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

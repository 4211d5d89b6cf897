/**
 * Starts the example shop; `npm run storefront` builds its pages first.
 *   node build/node/storefront.mjs [--port 8787] [--editor-port 8788] [--host localhost] [--site FOLDER] [--data FOLDER]
 *     [--keep-days 14]   of files that no cart and no order uses
 *     [--origin https://shop.example] [--editor-origin https://editor.example]   where a proxy stands before them
 */
import { mkdir } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import type { FastifyInstance } from "fastify";
import { SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { createEditorServer, originOf, type ShopOrigins } from "./editor-server.ts";
import { createShopServer } from "./shop-server.ts";

const DEFAULT_PORT = 8787;
const MOST_PORT = 65_535;

/** Seen from the bundle, in build/node. */
const beside = (folder: string): string => fileURLToPath(new URL(`../${folder}`, import.meta.url));

const { values } = parseArgs({
  options: {
    port: { type: "string", default: process.env.PORT ?? String(DEFAULT_PORT) },
    "editor-port": { type: "string" },
    "keep-days": { type: "string", default: String(SHOP_LIMITS.unusedDays) },
    origin: { type: "string" },
    "editor-origin": { type: "string" },
    host: { type: "string", default: "localhost" },
    site: { type: "string", default: beside("storefront") },
    data: { type: "string", default: beside("storefront-data") },
  },
});
const { host, site, data } = values;
const port = portOf(values.port, "--port");
const editorPort = portOf(values["editor-port"] ?? String(port === 0 ? 0 : port + 1), "--editor-port");

await mkdir(data, { recursive: true });
const origins: ShopOrigins = { shop: null, editor: null };
const { app } = await createShopServer({
  site: path.resolve(site),
  store: path.join(data, "files"),
  database: path.join(data, "shop.sqlite"),
  origins,
  behindProxy: values.origin !== undefined,
  unusedDays: daysOf(values["keep-days"]),
});
const editor = await createEditorServer(path.resolve(site), origins);
const close = async (): Promise<void> => {
  await Promise.all([app.close(), editor.close()]);
};
for (const signal of ["SIGINT", "SIGTERM"] as const) process.once(signal, () => void close());
const editorAt = await listen(editor, editorPort, "--editor-port");
const shopAt = await listen(app, port, "--port");
origins.editor = values["editor-origin"] ?? editorAt;
origins.shop = values.origin ?? shopAt;
process.stdout.write(`The shop is open: ${origins.shop}\n`);

function daysOf(given: string): number {
  const days = Number(given);
  if (given.trim() !== "" && days >= 0) return days;
  return refuse(`--keep-days must be a number of days, is "${given}".`);
}

function portOf(given: string, option: string): number {
  const number = Number(given);
  if (/^\d+$/.test(given) && number <= MOST_PORT) return number;
  return refuse(`${option} must be a number from 0 to ${MOST_PORT}, is "${given}".`);
}

/** The origin that it listens on. */
async function listen(server: FastifyInstance, at: number, option: string): Promise<string> {
  try {
    await server.listen({ port: at, host });
    return originOf(server, host);
  } catch (error) {
    await close();
    if ((error as NodeJS.ErrnoException).code !== "EADDRINUSE") throw error;
    return refuse(`Port ${at} is taken: name another with ${option}.`);
  }
}

function refuse(reason: string): never {
  process.stderr.write(`${reason}\n`);
  process.exit(2);
}

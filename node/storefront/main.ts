/**
 * Starts the example shop; `npm run storefront` builds its pages first.
 *   node build/node/storefront.mjs [--port 8787] [--editor-port 8788] [--host localhost] [--site FOLDER] [--data FOLDER]
 *     [--keep-days 14]   of files that no cart and no order uses
 *     [--origin https://shop.example] [--editor-origin https://editor.example]   where a proxy stands before them
 */
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import type { FastifyInstance } from "fastify";
import { parseUrl } from "../../web/core/parse-url.ts";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { isFolder, makeFolder } from "../make-folder.ts";
import { createEditorServer, originOf, type ShopOrigins } from "./editor-server.ts";
import { createShopServer } from "./shop-server.ts";

const DEFAULT_PORT = 8787;
const MOST_PORT = 65_535;

/** Seen from the bundle, in build/node. */
const beside = (folder: string): string => fileURLToPath(new URL(`../${folder}`, import.meta.url));

const USAGE = `Usage: npm run storefront -- [options]
  --port PORT            of the shop (default: PORT, else ${DEFAULT_PORT})
  --editor-port PORT     of the editor's page (default: the next one)
  --host NAME            to listen on (default: localhost)
  --data FOLDER          for carts, orders and files
  --site FOLDER          with the built pages
  --keep-days DAYS       of files that no cart and no order uses (default: ${SHOP_LIMITS.unusedDays})
  --origin, --editor-origin ADDRESS   what browsers call the two behind a proxy
`;

const values = readOptions();
if (values.help) {
  process.stdout.write(USAGE);
  process.exit(0);
}
const { host } = values;
const [site, data] = [folderOf(values.site, "--site"), folderOf(values.data, "--data")];
const proxy: ShopOrigins = {
  shop: originAt(values.origin, "--origin"),
  editor: originAt(values["editor-origin"], "--editor-origin"),
};
const port = portOf(values.port, "--port");
const editorPort = portOf(values["editor-port"] ?? String(port === 0 ? 0 : port + 1), "--editor-port");

if (!(await isFolder(site))) refuse(`--site must be a folder with the shop's built pages, is "${site}".`);
await makeDataFolder(data);
const origins: ShopOrigins = { shop: null, editor: null };
const { app } = await createShopServer({
  site,
  store: path.join(data, "files"),
  database: path.join(data, "shop.sqlite"),
  origins,
  behindProxy: proxy.shop !== null,
  unusedDays: daysOf(values["keep-days"]),
}).catch((error: unknown) => {
  if (!(error instanceof TexelcastError)) throw error;
  return refuse(`${error.subject ?? ""}: ${error.message}. ${error.hint ?? ""}`);
});
const editor = await createEditorServer(site, origins);
const close = async (): Promise<void> => {
  await Promise.all([app.close(), editor.close()]);
};
for (const signal of ["SIGINT", "SIGTERM"] as const) process.once(signal, () => void close());
const editorAt = await listen(editor, editorPort, "--editor-port");
const shopAt = await listen(app, port, "--port");
origins.editor = proxy.editor ?? editorAt;
origins.shop = proxy.shop ?? shopAt;
process.stdout.write(`The shop is open: ${origins.shop}\n`);

function readOptions() {
  try {
    return parseArgs({
      options: {
        port: { type: "string", default: process.env.PORT || String(DEFAULT_PORT) },
        "editor-port": { type: "string" },
        "keep-days": { type: "string", default: String(SHOP_LIMITS.unusedDays) },
        origin: { type: "string" },
        "editor-origin": { type: "string" },
        host: { type: "string", default: "localhost" },
        site: { type: "string", default: beside("storefront") },
        data: { type: "string", default: beside("storefront-data") },
        help: { type: "boolean", short: "h", default: false },
      },
    }).values;
  } catch (error) {
    return refuse(`${(error as Error).message}\n${USAGE}`);
  }
}

/** As seen from where the command was typed: npm runs it in the checkout, and says so. */
function folderOf(given: string, option: string): string {
  // Nothing would be the checkout itself.
  if (given === "") return refuse(`${option} must name a folder.`);
  return path.resolve(process.env.INIT_CWD ?? "", given);
}

async function makeDataFolder(folder: string): Promise<void> {
  try {
    await makeFolder(folder);
  } catch (error) {
    refuse(`--data: ${JSON.stringify(folder)} cannot be made: ${(error as Error).message}`);
  }
}

function daysOf(given: string): number {
  const days = Number(given);
  if (given.trim() !== "" && days >= 0) return days;
  return refuse(`--keep-days must be a number of days, is "${given}".`);
}

/** As browsers send it, without a slash at its end: with anything more it would be compared in vain. */
function originAt(given: string | undefined, option: string): string | null {
  if (given === undefined) return null;
  const { protocol, origin, href } = parseUrl(given) ?? { protocol: "", origin: "", href: given };
  if (/^https?:$/.test(protocol) && href === `${origin}/`) return origin;
  return refuse(`${option} must be as "https://shop.example", is "${given}".`);
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
    const { code, message } = error as NodeJS.ErrnoException;
    if (code === "EADDRINUSE") return refuse(`Port ${at} is taken: name another with ${option}.`);
    if (code === "EACCES") return refuse(`Port ${at} may not be used: name another with ${option}.`);
    if (["ENOTFOUND", "EADDRNOTAVAIL", "EAI_AGAIN"].includes(code ?? "")) {
      return refuse(`--host must be a name or an address of this machine, is "${host}": ${message}`);
    }
    throw error;
  }
}

function refuse(reason: string): never {
  process.stderr.write(`${reason}\n`);
  process.exit(2);
}

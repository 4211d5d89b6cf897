/** The example shop's order server: JSON below `/api`, files by their hash, and the built pages. */
import helmet from "@fastify/helmet";
import rateLimit from "@fastify/rate-limit";
import serveStatic from "@fastify/static";
import Fastify, { type FastifyInstance } from "fastify";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { Design } from "../../web/editor/document/index.ts";
import { type EditorReply, SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { systemReason } from "../system-reason.ts";
import { answerInTurn } from "./answers-in-turn.ts";
import { AssetStore } from "./asset-store.ts";
import { addCartRoutes } from "./cart-routes.ts";
import { readCatalogue } from "./catalogue.ts";
import { EDITOR_POLICY, orNone } from "./content-policy.ts";
import { editorPageOf, type ShopOrigins } from "./editor-server.ts";
import { addFileRoutes } from "./file-routes.ts";
import { giveLastAnswers } from "./last-answers.ts";
import { addOrderRoutes } from "./order-routes.ts";
import { Press, type PressOptions } from "./press.ts";
import { PrintQueue, type RenderLine } from "./print-queue.ts";
import type { Shop } from "./shop.ts";
import { ShopDatabase } from "./shop-database.ts";
import { answerNoAddress, notFound, patienceOf, REFUSALS, replyTo, tooManyRequests } from "./shop-error.ts";

export interface ShopServerOptions {
  /** The built pages, with `shop/products.json` and the models. */
  readonly site: string;
  /** Where files are kept. */
  readonly store: string;
  /** Where carts and orders are kept; ":memory:" for ones that are not. */
  readonly database: string;
  /** Bytes of all stored files together; default `SHOP_LIMITS.storedBytes`. */
  readonly storedBytes?: number;
  /** Where the editor's page is that product pages may frame; default: nowhere. */
  readonly origins?: ShopOrigins;
  /** Days that a file is kept which no cart and no order uses; default `SHOP_LIMITS.unusedDays`, Infinity for ever. */
  readonly unusedDays?: number;
  /** Milliseconds in which a request must have come; default ten minutes. */
  readonly requestPatience?: number;
  /** Milliseconds for which a server that is ended waits for the answers that are on their way; default eight seconds. */
  readonly lastAnswers?: number;
  /** Requests a minute from one address; default `SHOP_LIMITS.requestsPerMinute`. */
  readonly requestsPerMinute?: number;
  /** Lines put into carts a minute from one address; default `SHOP_LIMITS.linesPerMinute`. */
  readonly linesPerMinute?: number;
  /** A proxy stands before the server and says who asks. */
  readonly behindProxy?: boolean;
  /** Where files are printed and measured. */
  readonly press?: PressOptions;
  /** Told of what nobody expected. Default: standard error. */
  readonly report?: (error: unknown) => void;
}

export interface ShopServer {
  readonly app: FastifyInstance;
  /** Resolves when no ordered line waits for its print file. */
  printed(): Promise<void>;
}

const DAY = 24 * 60 * 60 * 1000;

/**
 * Opens the store and the database, and makes the server; it does not listen yet. `app.close()` ends all of it.
 *
 * @throws TexelcastError "storage-refused" where the store or the database cannot be opened, "database-taken", and as `readCatalogue`.
 */
export async function createShopServer(options: ShopServerOptions): Promise<ShopServer> {
  const report = options.report ?? ((error) => console.error(error));
  const shop = await openShop(options, report);
  const app = Fastify({
    bodyLimit: SHOP_LIMITS.jsonBytes,
    forceCloseConnections: true,
    return503OnClosing: false,
    trustProxy: options.behindProxy ?? false,
    ...patienceOf(options.requestPatience),
    ...REFUSALS,
  });
  // Fastify's own, beside JSON: a body that is a text would be told as JSON of the wrong shape.
  app.removeContentTypeParser("text/plain");
  giveLastAnswers(app, options.lastAnswers);
  answerInTurn(app);
  let isEnding = false;
  app.setErrorHandler((error, _request, reply) => {
    const { status, body, unexpected } = replyTo(error);
    // Who is still answered while the server ends may find the database closed: that is expected.
    if (unexpected && !isEnding) report(error);
    return reply.code(status).send(body);
  });
  app.setNotFoundHandler(answerNoAddress);
  // Who has hung up already has no address that could be counted, and hears no answer.
  app.addHook("onRequest", async (request, reply) => {
    if (request.ip === undefined) reply.hijack();
  });
  await addRoutes(app, shop, options);
  const tidyUp = (): Promise<unknown> =>
    shop.store
      .removeUnused(shop.database.filesInUse(), Date.now() - (options.unusedDays ?? SHOP_LIMITS.unusedDays) * DAY)
      .catch(report);
  await tidyUp();
  const tidying = setInterval(tidyUp, DAY / 4).unref();
  app.addHook("onClose", async () => {
    isEnding = true;
    clearInterval(tidying);
    await shop.queue.end();
    await shop.press.end();
    shop.database.close();
  });
  shop.queue.wake();
  return { app, printed: () => shop.queue.idle() };
}

async function openShop(options: ShopServerOptions, report: (error: unknown) => void): Promise<Shop> {
  const catalogue = await readCatalogue(options.site);
  const { storedBytes = SHOP_LIMITS.storedBytes } = options;
  const store = await openedAt(options.store, () => AssetStore.open(options.store, storedBytes));
  const database = await openedAt(options.database, () => new ShopDatabase(options.database));
  const press = new Press(catalogue, store, options.press);
  const print: RenderLine = async (line) => {
    const product = catalogue.products.get(line.product);
    if (product === undefined) throw notFound("product", line.product);
    return press.print(product, line.design as Design);
  };
  const queue = new PrintQueue(database, store, print, report);
  const { linesPerMinute = SHOP_LIMITS.linesPerMinute } = options;
  return { catalogue, store, database, press, queue, linesPerMinute };
}

/** Throws a TexelcastError: "storage-refused", unless the fault has a name already. */
async function openedAt<Kept>(place: string, open: () => Kept | Promise<Kept>): Promise<Kept> {
  try {
    return await open();
  } catch (thrown) {
    throw TexelcastError.wrap(
      thrown,
      "storage-refused",
      `what the shop keeps cannot be opened (${systemReason(thrown)})`,
      {
        subject: place,
        hint: "See that it may be written, or name another folder with --data.",
      },
    );
  }
}

/** The pages under their policy, and what they ask for below `/api`. */
async function addRoutes(app: FastifyInstance, shop: Shop, options: ShopServerOptions): Promise<void> {
  const { origins } = options;
  await app.register(helmet, {
    contentSecurityPolicy: {
      useDefaults: false,
      directives: {
        ...EDITOR_POLICY,
        "frame-src": [() => orNone(origins?.editor ?? null)],
        "frame-ancestors": ["'none'"],
      },
    },
    // The example speaks plain HTTP on one's own machine; a proxy that speaks TLS adds it.
    strictTransportSecurity: false,
    xFrameOptions: { action: "deny" },
  });
  await app.register(serveStatic, { root: options.site, cacheControl: false });
  await app.register(async (api) => {
    await api.register(rateLimit, {
      max: options.requestsPerMinute ?? SHOP_LIMITS.requestsPerMinute,
      timeWindow: "1 minute",
      errorResponseBuilder: (_request, { ttl }) => tooManyRequests(ttl),
    });
    api.get("/api/editor", (): EditorReply => {
      const page = origins && editorPageOf(origins);
      if (!page) throw notFound("editor", "on an origin of its own");
      return { page };
    });
    api.get("/api/products", () => ({ products: [...shop.catalogue.products.values()] }));
    addFileRoutes(api, shop);
    addCartRoutes(api, shop);
    addOrderRoutes(api, shop);
  });
}

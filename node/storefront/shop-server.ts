/** The example shop's order server: JSON below `/api`, files by their hash, and the built pages. */
import helmet from "@fastify/helmet";
import serveStatic from "@fastify/static";
import Fastify, { type FastifyInstance } from "fastify";
import { type EditorReply, SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { AssetStore } from "./asset-store.ts";
import { addCartRoutes } from "./cart-routes.ts";
import { type Catalogue, readCatalogue } from "./catalogue.ts";
import { EDITOR_POLICY, orNone } from "./content-policy.ts";
import { editorPageOf, type ShopOrigins } from "./editor-server.ts";
import { addFileRoutes } from "./file-routes.ts";
import { addOrderRoutes } from "./order-routes.ts";
import { Press } from "./press.ts";
import { PrintQueue } from "./print-queue.ts";
import { ShopDatabase } from "./shop-database.ts";
import { notFound, replyTo } from "./shop-error.ts";

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
  /** Told of what nobody expected. Default: standard error. */
  readonly report?: (error: unknown) => void;
}

/** What the routes share. */
export interface Shop {
  readonly catalogue: Catalogue;
  readonly store: AssetStore;
  readonly database: ShopDatabase;
  readonly press: Press;
  readonly queue: PrintQueue;
}

export interface ShopServer {
  readonly app: FastifyInstance;
  /** Resolves when no ordered line waits for its print file. */
  printed(): Promise<void>;
}

/** Opens the store and the database, and makes the server; it does not listen yet. `app.close()` ends all of it. */
export async function createShopServer(options: ShopServerOptions): Promise<ShopServer> {
  const catalogue = await readCatalogue(options.site);
  const store = await AssetStore.open(options.store, options.storedBytes ?? SHOP_LIMITS.storedBytes);
  const database = new ShopDatabase(options.database);
  const press = new Press(catalogue, store);
  const queue = new PrintQueue(database, store, async (line) => {
    const product = catalogue.products.get(line.product);
    if (product === undefined) throw notFound("product", line.product);
    return press.print(product, line.design);
  });
  const shop: Shop = { catalogue, store, database, press, queue };
  const { origins } = options;
  const report = options.report ?? ((error) => console.error(error));

  const app = Fastify({ bodyLimit: SHOP_LIMITS.jsonBytes, forceCloseConnections: true });
  app.setErrorHandler((error, _request, reply) => {
    const { status, body, unexpected } = replyTo(error);
    if (unexpected) report(error);
    return reply.code(status).send(body);
  });
  app.setNotFoundHandler((request, reply) => {
    const { status, body } = replyTo(notFound("address", request.url));
    return reply.code(status).send(body);
  });
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
  app.get("/api/editor", (): EditorReply => {
    const page = origins && editorPageOf(origins);
    if (!page) throw notFound("editor", "on an origin of its own");
    return { page };
  });
  app.get("/api/products", () => ({ products: [...catalogue.products.values()] }));
  addFileRoutes(app, shop);
  addCartRoutes(app, shop);
  addOrderRoutes(app, shop);
  app.addHook("onClose", async () => {
    await shop.queue.end();
    database.close();
  });
  shop.queue.wake();
  return { app, printed: () => shop.queue.idle() };
}

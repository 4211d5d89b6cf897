/** Carts and their lines. A cart's id is the key to it: it is in nobody's cookie, so no other site can use it. */
import type { FastifyInstance } from "fastify";
import { unitPriceOf } from "../../web/storefront/api/price.ts";
import { type Cart, type Product, SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { readLine, readQuantityRequest } from "./line-intake.ts";
import type { Shop } from "./shop.ts";
import type { Item, StoredLine } from "./shop-database.ts";
import { notFound, shopError } from "./shop-error.ts";

type OfCart = { Params: { cart: string } };
type OfLine = { Params: { cart: string; line: string } };

/** `/api/carts` and below: makes carts, puts lines in, changes them and takes them out. */
export function addCartRoutes(app: FastifyInstance, shop: Shop): void {
  const { catalogue, store, database, press } = shop;
  // One count for all that it works for.
  const forThePress = { config: { rateLimit: false }, onRequest: app.rateLimit({ max: shop.linesPerMinute }) } as const;
  const cartOf = (id: string): Cart => {
    if (!database.hasCart(id)) throw notFound("cart", id);
    const lines = database.linesOf(id);
    return { id, lines: lines.map(withoutName), currency: catalogue.currency, total: totalOf(lines) };
  };
  const checkRoom = (cart: string): void => {
    if (cartOf(cart).lines.length < SHOP_LIMITS.linesPerCart) return;
    throw shopError("too-large", `a cart holds ${SHOP_LIMITS.linesPerCart} lines`, {
      field: "cart",
      hint: "Order what is in it first.",
    });
  };
  const itemOf = async (body: unknown): Promise<Item> => {
    const line = await readLine(body, catalogue, store);
    const product = catalogue.products.get(line.product) as Product;
    const { areaCm2: area } = (await press.measure(product, line.design)).whole;
    const unitPrice = unitPriceOf(product.price, { decals: line.decals, area });
    if (unitPrice !== line.unitPrice) {
      throw shopError("price-changed", "the price of this design is another than the page showed", {
        field: "unitPrice",
        value: String(unitPrice),
        hint: "It stands there now. Add it to the cart if that is right.",
      });
    }
    return { ...line, productName: product.name, area };
  };

  app.post("/api/carts", (_request, reply) => reply.code(201).send(cartOf(database.makeCart())));
  app.get<OfCart>("/api/carts/:cart", (request) => cartOf(request.params.cart));

  app.post<OfCart>("/api/carts/:cart/lines", forThePress, async (request, reply) => {
    const { cart } = request.params;
    checkRoom(cart);
    const item = await itemOf(request.body);
    // Others may have been put in while this one was measured.
    checkRoom(cart);
    const line = database.addLine(cart, item);
    return reply.code(201).send({ line, cart: cartOf(cart) });
  });

  app.put<OfLine>("/api/carts/:cart/lines/:line", forThePress, async (request) => {
    const { cart, line } = request.params;
    if (database.lineOf(cart, line) === null) throw notFound("line", line);
    if (!database.replaceLine(cart, line, await itemOf(request.body))) throw notFound("line", line);
    return { line, cart: cartOf(cart) };
  });

  app.patch<OfLine>("/api/carts/:cart/lines/:line", (request) => {
    const { cart, line } = request.params;
    const stored = database.lineOf(cart, line);
    if (stored === null) throw notFound("line", line);
    const { id: _, ...item } = stored;
    database.replaceLine(cart, line, { ...item, ...readQuantityRequest(request.body) });
    return { line, cart: cartOf(cart) };
  });

  app.delete<OfLine>("/api/carts/:cart/lines/:line", (request) => {
    const { cart, line } = request.params;
    if (!database.removeLine(cart, line)) throw notFound("line", line);
    return { line, cart: cartOf(cart) };
  });
}

/** In the currency's smallest unit. */
export const totalOf = (lines: readonly Pick<StoredLine, "unitPrice" | "quantity">[]): number =>
  lines.reduce((sum, { unitPrice, quantity }) => sum + unitPrice * quantity, 0);

const withoutName = ({ productName: _, ...line }: StoredLine): Cart["lines"][number] => line;

/** Orders: what was in the cart, and the print files that come of it. */
import type { FastifyInstance } from "fastify";
import type { Order } from "../../web/storefront/api/shop-api.ts";
import { totalOf } from "./cart-routes.ts";
import { readOrderRequest } from "./line-intake.ts";
import type { Shop } from "./shop.ts";
import { notFound, shopError } from "./shop-error.ts";

/** `/api/carts/CART/order` and `/api/orders`: makes an order of a cart, tells its state, and gives out its print files. */
export function addOrderRoutes(app: FastifyInstance, { catalogue, store, database, queue }: Shop): void {
  const orderOf = (id: string): Order => {
    const order = database.orderOf(id);
    if (order === null) throw notFound("order", id);
    return { ...order, currency: catalogue.currency, total: totalOf(order.lines) };
  };

  app.post<{ Params: { cart: string } }>("/api/carts/:cart/order", (request, reply) => {
    const { cart } = request.params;
    if (!database.hasCart(cart)) throw notFound("cart", cart);
    const { name } = readOrderRequest(request.body);
    const id = database.order(cart, name);
    if (id === null) {
      // Whom the answer did not reach asks again.
      const made = database.lastOrderOf(cart);
      const hint = made === null ? "Put a product into it first." : "What was in it is ordered.";
      throw shopError("bad-request", "the cart is empty", {
        field: "cart",
        hint,
        ...(made !== null && { value: made }),
      });
    }
    queue.wake();
    return reply.code(201).send(orderOf(id));
  });

  app.get<{ Params: { order: string } }>("/api/orders/:order", (request) => orderOf(request.params.order));

  app.get<{ Params: { order: string; line: string } }>(
    "/api/orders/:order/lines/:line/print.png",
    async (request, reply) => {
      const order = orderOf(request.params.order);
      const line = order.lines.find(({ id }) => id === request.params.line);
      // What is held was not approved: it must not reach a printer by this way.
      if (line?.status !== "ready" || line.printed === null) throw notFound("print file", request.params.line);
      reply.header("content-disposition", `attachment; filename="order-${order.number}-${line.product}.png"`);
      reply.header("cache-control", "private, no-store");
      return reply.type("image/png").send(await store.read(line.printed.sha256));
    },
  );
}

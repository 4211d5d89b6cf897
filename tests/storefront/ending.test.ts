/** A server that is ended while it is asked: over real connections, as those are what ends. */
import { once } from "node:events";
import { connect } from "node:net";
import { expect, it } from "vitest";
import { openShop, type TestShop } from "./shop-fixture.ts";

/** A press's thread that says when it begins to measure, and is done a moment later. */
const slowPress = new URL(
  `data:text/javascript,${encodeURIComponent(`
    import { parentPort } from "node:worker_threads";
    parentPort.on("message", () => setTimeout(() => parentPort.postMessage({ value: { whole: { areaCm2: 1 } } }), 500));`)}`,
);

const listen = (shop: TestShop): Promise<string> => shop.app.listen({ port: 0, host: "127.0.0.1" });

/** Resolves when a route works on the next request. */
const begun = (shop: TestShop): Promise<void> =>
  new Promise((resolve) => {
    shop.app.server.once("request", () => setImmediate(resolve));
  });

it("a server that is ended answers first whom it works for, and what it said is there for the next one", async () => {
  const shop = await openShop({ press: { script: slowPress } });
  const cart = await shop.cart();
  const body = JSON.stringify(await shop.line());
  const address = await listen(shop);
  const asked = begun(shop);
  const headers = { "content-type": "application/json" };
  const reply = fetch(`${address}/api/carts/${cart}/lines`, { method: "POST", body, headers }).then(
    (answer) => answer.status,
    (error: Error) => String(error),
  );
  await asked;
  await shop.app.close();
  expect(await reply).toBe(201);
  expect(shop.reported).toEqual([]);
  const next = await openShop({ folder: shop.folder });
  expect((await next.app.inject(`/api/carts/${cart}`)).json().lines).toHaveLength(1);
});

it("a server that is ended waits for nobody who does not come to the end of what they ask", async () => {
  const shop = await openShop({ lastAnswers: 200 });
  const { port } = new URL(await listen(shop));
  const socket = connect(Number(port), "127.0.0.1");
  socket.on("error", () => {});
  const asked = begun(shop);
  socket.write(
    "POST /api/carts HTTP/1.1\r\nhost: shop\r\ncontent-type: application/json\r\ncontent-length: 10\r\n\r\n{",
  );
  await asked;
  const closed = once(socket, "close");
  await shop.app.close();
  await closed;
  expect(shop.reported).toEqual([]);
});

/** What keeps the shop open: a press that may break, files that nobody needs, visitors who ask too often. */
import { existsSync, utimesSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import type { OrderLine } from "../../web/storefront/api/shop-api.ts";
import { LOGO, openShop, SNAPSHOT, sha256, type TestShop } from "./shop-fixture.ts";

/** A press's thread that measures the one decal of the tests, and prints by `print`. */
const pressThat = (print: string): URL =>
  new URL(
    `data:text/javascript,${encodeURIComponent(`
      import { parentPort } from "node:worker_threads";
      parentPort.on("message", ({ kind }) => {
        if (kind === "measure") parentPort.postMessage({ value: { whole: { areaCm2: 1 } } });
        else { ${print} }
      });`)}`,
  );

async function ordered(shop: TestShop): Promise<OrderLine> {
  const cart = await shop.cart();
  expect((await shop.addLine(cart, await shop.line())).statusCode).toBe(201);
  const payload = { name: "Ada" };
  const { id } = (await shop.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload })).json();
  await shop.printed();
  return (await shop.app.inject(`/api/orders/${id}`)).json().lines[0];
}

describe("the press", () => {
  it.each([
    ["ends", "process.exit(3)", "the press ended with code 3"],
    [
      "throws where nobody catches it",
      "setTimeout(() => { throw new Error('out of ink') })",
      "the press failed: out of ink",
    ],
  ])("holds a line when its thread %s, and the server goes on with a new one", async (_what, print, message) => {
    const shop = await openShop({ press: { script: pressThat(print) } });
    for (let order = 0; order < 2; order += 1) {
      expect(await ordered(shop)).toMatchObject({
        status: "held",
        printed: null,
        fault: { code: "press-failed", message },
      });
    }
    expect((await shop.app.inject("/api/products")).statusCode).toBe(200);
    expect(shop.reported).toEqual([]);
  });

  it("is ended when it takes for ever, and the shop answers meanwhile", async () => {
    const shop = await openShop({ press: { script: pressThat("for (;;);"), patience: 2000 } });
    const line = ordered(shop);
    expect((await shop.app.inject("/api/products")).statusCode).toBe(200);
    expect(await line).toMatchObject({ status: "held", fault: { code: "timeout", field: "print" } });
  });
});

it("a server that is ended while lines wait to be measured says nothing in its log", async () => {
  const shop = await openShop();
  const cart = await shop.cart();
  const line = await shop.line();
  const replies = [1, 2, 3].map(() => shop.addLine(cart, line).catch(() => null));
  await shop.app.close();
  await Promise.all(replies);
  expect(shop.reported).toEqual([]);
});

describe("files that are too old", () => {
  const age = (shop: TestShop): void => {
    const old = new Date(Date.now() - 15 * 24 * 60 * 60 * 1000);
    for (const file of [LOGO, SNAPSHOT]) utimesSync(placeOf(shop, file), old, old);
  };
  const placeOf = ({ folder }: TestShop, file: Uint8Array): string =>
    path.join(folder, "files", sha256(file).slice(0, 2), sha256(file));

  it("go when no cart and no order uses them, and make room", async () => {
    const first = await openShop();
    await first.line();
    age(first);
    await first.app.close();
    const second = await openShop({ folder: first.folder, storedBytes: LOGO.length + SNAPSHOT.length });
    expect(existsSync(placeOf(second, LOGO))).toBe(false);
    expect((await second.putFile(LOGO)).statusCode).toBe(201);
    expect((await second.putFile(SNAPSHOT)).statusCode).toBe(201);
  });

  it("stay while a cart's line or an order names them, and while somebody asks for them", async () => {
    const first = await openShop();
    const cart = await first.cart();
    await first.addLine(cart, await first.line());
    age(first);
    await first.app.close();
    const second = await openShop({ folder: first.folder });
    const url = `/api/carts/${cart}/order`;
    await second.app.inject({ method: "POST", url, payload: { name: "Ada" } });
    await second.printed();
    age(second);
    await second.app.close();
    const third = await openShop({ folder: first.folder });
    expect((await third.app.inject(`/api/files/${sha256(LOGO)}`)).statusCode).toBe(200);
    expect(existsSync(placeOf(third, SNAPSHOT))).toBe(true);
  });

  it.each([1e9, Number.POSITIVE_INFINITY])("are all kept where %s days have to pass", async (unusedDays) => {
    const first = await openShop();
    await first.line();
    age(first);
    await first.app.close();
    const second = await openShop({ folder: first.folder, unusedDays });
    expect([LOGO, SNAPSHOT].map((file) => existsSync(placeOf(second, file)))).toEqual([true, true]);
  });

  it("of an earlier visit are young again when they are sent or read", async () => {
    const first = await openShop();
    await first.line();
    age(first);
    await first.putFile(LOGO);
    await first.app.inject(`/api/files/${sha256(SNAPSHOT)}`);
    await first.app.close();
    const second = await openShop({ folder: first.folder });
    expect([LOGO, SNAPSHOT].map((file) => existsSync(placeOf(second, file)))).toEqual([true, true]);
  });
});

it("who fills carts too often is told to wait, and may still look", async () => {
  const shop = await openShop({ linesPerMinute: 1, press: { script: pressThat("") } });
  const cart = await shop.cart();
  const { line } = (await shop.addLine(cart, await shop.line())).json();
  const again = { method: "PUT", url: `/api/carts/${cart}/lines/${line}`, payload: await shop.line() } as const;
  expect((await shop.app.inject(again)).json().error.code).toBe("too-many-requests");
  expect((await shop.app.inject(`/api/carts/${cart}`)).json().lines).toHaveLength(1);
});

it("who asks too often is told to wait, with a typed error; another address is heard", async () => {
  const shop = await openShop({ requestsPerMinute: 2 });
  const ask = (remoteAddress: string) => shop.app.inject({ url: "/api/products", remoteAddress });
  expect([await ask("192.0.2.1"), await ask("192.0.2.1")].map(({ statusCode }) => statusCode)).toEqual([200, 200]);
  const refused = await ask("192.0.2.1");
  expect(refused.statusCode).toBe(429);
  expect(Number(refused.headers["retry-after"])).toBeGreaterThan(0);
  expect(refused.json().error.code).toBe("too-many-requests");
  expect((await ask("192.0.2.2")).statusCode).toBe(200);
});

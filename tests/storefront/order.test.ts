import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { describe, expect, it } from "vitest";
import { parseDesign, parseZones, resolveLayers } from "../../web/editor/document/index.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import type { Order } from "../../web/storefront/api/shop-api.ts";
import { plainPng } from "../node/plane-model.ts";
import { designWith, LOGO, openShop, SNAPSHOT, sha256, type TestShop, ZONES } from "./shop-fixture.ts";

const WASM = new URL("../../build/wasm/texelcast.wasm", import.meta.url);

/** The texture as a page makes it: the engine with the design as the customer has it, keys and all. */
async function approve(shop: TestShop, design: object): Promise<{ sha256: string; width: number; height: number }> {
  const engine = createEngineHost({ wasm: WASM });
  try {
    const model = readFileSync(path.join(shop.folder, "site/demo/plane.glb"));
    await engine.loadModel({ name: "plane.glb", bytes: model });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.setZones(parseZones(ZONES));
    engine.setLayers(resolveLayers(parseDesign(design)), 1);
    const { bytes, width, height } = await engine.exportPrint({ material: 0 });
    return { sha256: sha256(bytes), width, height };
  } finally {
    engine.dispose();
  }
}

const order = async (shop: TestShop, cart: string, name = "Ada"): Promise<Order> => {
  const reply = await shop.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload: { name } });
  expect(reply.statusCode).toBe(201);
  return reply.json();
};
const orderNow = async (shop: TestShop, id: string): Promise<Order> =>
  (await shop.app.inject(`/api/orders/${id}`)).json();

describe("an order", () => {
  it("prints what was approved: both hashes are one, and so is that of the file", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    const approved = await approve(shop, designWith());
    expect((await shop.addLine(cart, await shop.line({ approved }))).statusCode).toBe(201);
    const { id } = await order(shop, cart);
    await shop.printed();
    const [line] = (await orderNow(shop, id)).lines;
    expect(line).toMatchObject({ status: "ready", approved, printed: { ...approved }, fault: null });
    const file = await shop.app.inject(`/api/orders/${id}/lines/${line?.id}/print.png`);
    expect(file.headers["content-type"]).toBe("image/png");
    expect(file.headers["content-disposition"]).toBe('attachment; filename="order-1-plane.png"');
    expect(sha256(file.rawPayload)).toBe(approved.sha256);
  });

  it("is held when the print file is not what was approved, and gives nothing to print", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    await shop.addLine(cart, await shop.line());
    const { id } = await order(shop, cart);
    await shop.printed();
    const [line] = (await orderNow(shop, id)).lines;
    expect(line).toMatchObject({ status: "held", fault: { code: "hash-mismatch", field: "approved.sha256" } });
    const file = await shop.app.inject(`/api/orders/${id}/lines/${line?.id}/print.png`);
    expect(file).toMatchObject({ statusCode: 404 });
    const byItsHash = await shop.app.inject(`/api/files/${line?.printed?.sha256}`);
    expect(byItsHash).toMatchObject({ statusCode: 404 });
  });

  it("is held with its reason when a stored picture was damaged on the disk", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    await shop.addLine(cart, await shop.line());
    const logo = sha256(LOGO);
    writeFileSync(path.join(shop.folder, "files", logo.slice(0, 2), logo), await plainPng(8, 8, [1, 2, 3, 255]));
    const { id } = await order(shop, cart);
    await shop.printed();
    expect((await orderNow(shop, id)).lines[0]).toMatchObject({
      status: "held",
      printed: null,
      fault: { code: "hash-mismatch", subject: logo },
    });
  });

  it("is made once, and named to whom its answer did not reach and who asks again", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    const ask = async () =>
      (await shop.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload: { name: "Ada" } })).json();
    expect((await ask()).error).not.toHaveProperty("value");
    await shop.addLine(cart, await shop.line());
    const { id, number } = await ask();
    expect((await ask()).error).toMatchObject({ code: "bad-request", field: "cart", value: id });
    // A cart that something was put into since is no longer that order's.
    const { line } = (await shop.addLine(cart, await shop.line())).json();
    await shop.app.inject({ method: "DELETE", url: `/api/carts/${cart}/lines/${line}` });
    expect((await ask()).error).not.toHaveProperty("value");
    await shop.addLine(cart, await shop.line());
    expect((await ask()).number).toBe(number + 1);
    await shop.printed();
  });

  it("empties the cart, adds up its lines, and numbers itself", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    await shop.addLine(cart, await shop.line({ quantity: 3 }));
    await shop.addLine(cart, await shop.line());
    const made = await order(shop, cart);
    expect(made).toMatchObject({ number: 1, currency: "EUR", total: 4 * 1150 });
    expect((await shop.app.inject(`/api/carts/${cart}`)).json().lines).toEqual([]);
    const again = await shop.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload: { name: "Ada" } });
    expect(again.json().error).toMatchObject({ code: "bad-request", message: "the cart is empty" });
    await shop.printed();
  });

  it("goes on printing after the server was ended", async () => {
    const first = await openShop();
    const cart = await first.cart();
    await first.addLine(cart, await first.line({ approved: await approve(first, designWith()) }));
    const made = first.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload: { name: "Ada" } });
    const { id } = (await made).json();
    await first.app.close();
    const second = await openShop({ folder: first.folder });
    await second.printed();
    expect((await orderNow(second, id)).lines[0]).toMatchObject({ status: "ready" });
  });

  it("keeps a name as it was written, markup and all, as plain data", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    await shop.addLine(cart, await shop.line());
    const name = "<img src=x onerror=alert(1)>";
    const reply = await shop.app.inject({ method: "POST", url: `/api/carts/${cart}/order`, payload: { name } });
    expect(reply.headers["content-type"]).toMatch(/^application\/json/);
    expect(reply.headers["x-content-type-options"]).toBe("nosniff");
    expect(reply.json().name).toBe(name);
    await shop.printed();
  });
});

describe("a cart", () => {
  it("keeps the design so that it can be edited again: its pictures lie where it says", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    await shop.addLine(cart, await shop.line());
    const [line] = (await shop.app.inject(`/api/carts/${cart}`)).json().lines;
    expect(line).toMatchObject({ product: "plane", decals: 1, unitPrice: 1150, snapshot: sha256(SNAPSHOT) });
    const picture = await shop.app.inject(line.design.assets.logo.uri);
    expect(sha256(picture.rawPayload)).toBe(sha256(LOGO));
    const again = await shop.line({ design: line.design, assets: [], quantity: 2 });
    const url = `/api/carts/${cart}/lines/${line.id}`;
    const replaced = await shop.app.inject({ method: "PUT", url, payload: again });
    expect(replaced.json().cart).toMatchObject({ total: 2300, lines: [{ id: line.id, quantity: 2 }] });
  });

  it("counts a line anew, and lets go of it", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    const { line } = (await shop.addLine(cart, await shop.line())).json();
    const url = `/api/carts/${cart}/lines/${line}`;
    const counted = await shop.app.inject({ method: "PATCH", url, payload: { quantity: 4 } });
    expect(counted.json().cart.total).toBe(4600);
    const refused = await shop.app.inject({ method: "PATCH", url, payload: { quantity: 0 } });
    expect(refused.json().error).toMatchObject({ code: "bad-request", field: "quantity" });
    expect((await shop.app.inject({ method: "DELETE", url })).json().cart.lines).toEqual([]);
    expect((await shop.app.inject({ method: "DELETE", url })).statusCode).toBe(404);
  });

  it("is reached by its own id alone, and so are its lines", async () => {
    const shop = await openShop();
    const [mine, other] = [await shop.cart(), await shop.cart()];
    expect(mine).toMatch(/^[\w-]{24}$/);
    const { line } = (await shop.addLine(mine, await shop.line())).json();
    expect((await shop.app.inject("/api/carts/1")).statusCode).toBe(404);
    expect((await shop.app.inject({ method: "DELETE", url: `/api/carts/${other}/lines/${line}` })).statusCode).toBe(
      404,
    );
  });

  it("measures the surface that is printed itself, whatever the page says", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    const [line] = (await shop.addLine(cart, await shop.line())).json().cart.lines;
    // The decal is two metres by one, and half of it lies beyond the zone, where it is cut off.
    expect(line.area / 10_000).toBeCloseTo(1, 3);
  });

  it("tells the customer's price by the server's own count, hidden layers left out", async () => {
    const shop = await openShop();
    const cart = await shop.cart();
    const hidden = { design: designWith({ visible: false }) };
    expect((await shop.addLine(cart, await shop.line({ ...hidden, unitPrice: 1000 }))).json().cart.total).toBe(1000);
    const stale = await shop.addLine(cart, await shop.line(hidden));
    expect(stale.statusCode).toBe(409);
    expect(stale.json().error).toMatchObject({ code: "price-changed", field: "unitPrice", value: "1000" });
  });
});

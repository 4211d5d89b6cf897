/** What a disk does to the shop: it is full, it takes nothing more, it damages a file, or a file comes late. */
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import path from "node:path";
import sqlite from "node-sqlite3-wasm";
import { afterEach, expect, it, vi } from "vitest";
import { ShopDatabase } from "../../node/storefront/shop-database.ts";
import { LOGO, openShop, SNAPSHOT, sha256, type TestShop } from "./shop-fixture.ts";

/** The code of the fault with which the disk answers each call, as Node names it. */
const disk = vi.hoisted(() => ({ faults: {} as Record<string, string | undefined> }));
vi.mock("node:fs/promises", async (importOriginal) => {
  const real = await importOriginal<typeof import("node:fs/promises")>();
  const faulty =
    (name: "writeFile" | "utimes") =>
    async (...given: never[]) => {
      const code = disk.faults[name];
      if (code) throw Object.assign(new Error(`${code}: of the disk, ${name}`), { code });
      return (real[name] as (...given: never[]) => Promise<void>)(...given);
    };
  return { ...real, writeFile: faulty("writeFile"), utimes: faulty("utimes") };
});
afterEach(() => {
  disk.faults = {};
});

const storedFile = ({ folder }: TestShop, bytes: Uint8Array): string =>
  path.join(folder, "files", sha256(bytes).slice(0, 2), sha256(bytes));

it.each(["ENOSPC", "EDQUOT"])(
  "a disk without room (%s) is told as a shop without room, and its log is told why",
  async (code) => {
    const shop = await openShop();
    disk.faults.writeFile = code;
    const reply = await shop.putFile(LOGO);
    expect(reply.json().error).toMatchObject({ code: "storage-full", hint: expect.stringMatching(/later/) });
    expect(reply.json().error).not.toHaveProperty("cause");
    expect(reply.statusCode).toBe(507);
    expect(shop.reported).toEqual([expect.objectContaining({ cause: expect.objectContaining({ code }) })]);
    disk.faults = {};
    expect((await shop.putFile(LOGO)).statusCode).toBe(201);
  },
);

it("a disk that takes nothing more still gives out what is on it", async () => {
  const shop = await openShop();
  await shop.putFile(LOGO);
  disk.faults = { writeFile: "EROFS", utimes: "EROFS" };
  const reply = await shop.app.inject(`/api/files/${sha256(LOGO)}`);
  expect(reply.statusCode).toBe(200);
  expect(new Uint8Array(reply.rawPayload)).toEqual(LOGO);
});

it("a stored file that was damaged is whole again when it is sent again, as its refusal says", async () => {
  const shop = await openShop({ storedBytes: LOGO.length + SNAPSHOT.length });
  await shop.putFile(LOGO);
  for (const damage of [new Uint8Array(LOGO.length), new Uint8Array(1)]) {
    writeFileSync(storedFile(shop, LOGO), damage);
    const { error } = (await shop.app.inject(`/api/files/${sha256(LOGO)}`)).json();
    expect(error).toMatchObject({ code: "hash-mismatch", hint: "Send the file again." });
    expect((await shop.putFile(LOGO)).statusCode).toBe(201);
    expect((await shop.app.inject(`/api/files/${sha256(LOGO)}`)).statusCode).toBe(200);
    expect(new Uint8Array(readFileSync(storedFile(shop, LOGO)))).toEqual(LOGO);
  }
  // It has taken its room once.
  expect((await shop.putFile(SNAPSHOT)).statusCode).toBe(201);
});

it("a product whose model could not be read is sold as soon as it can be", async () => {
  const shop = await openShop();
  const [cart, line] = [await shop.cart(), await shop.line()];
  const model = path.join(shop.folder, "site/demo/plane.glb");
  renameSync(model, `${model}.away`);
  expect((await shop.addLine(cart, line)).statusCode).toBe(500);
  renameSync(`${model}.away`, model);
  expect((await shop.addLine(cart, line)).statusCode).toBe(201);
});

it("a database that gives up in mid-order says why, and the cart is as it was", async () => {
  const { folder } = await openShop();
  const file = path.join(folder, "other.sqlite");
  new ShopDatabase(file).close();
  const broken = new sqlite.Database(file);
  broken.exec(
    `CREATE TRIGGER broken BEFORE INSERT ON order_lines BEGIN SELECT RAISE(ROLLBACK, 'the disk is full'); END`,
  );
  broken.close();
  const database = new ShopDatabase(file);
  const id = database.makeCart();
  database.addLine(id, {} as never);
  expect(() => database.order(id, "Ada")).toThrow("the disk is full");
  expect(database.linesOf(id)).toHaveLength(1);
  database.close();
});

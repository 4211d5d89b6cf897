/** What the print queue makes of a database that fails, and of a press that nobody expected to. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { AssetStore } from "../../node/storefront/asset-store.ts";
import { PrintQueue, type RenderLine } from "../../node/storefront/print-queue.ts";
import { type Item, ShopDatabase } from "../../node/storefront/shop-database.ts";
import type { PrintFile } from "../../web/engine/print-report.ts";
import { LOGO, sha256 } from "./shop-fixture.ts";

const PRINT = { bytes: LOGO, width: 8, height: 8 } as PrintFile;
const ITEM = { product: "plane", approved: { sha256: sha256(LOGO), width: 8, height: 8 } } as Item;

let folder: string;
let database: ShopDatabase;
let reported: unknown[];
beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), "texelcast-queue-"));
  database = new ShopDatabase(":memory:");
  reported = [];
});
afterEach(() => {
  database.close();
  rmSync(folder, { recursive: true, force: true });
});

const queueThat = async (render: RenderLine): Promise<PrintQueue> =>
  new PrintQueue(database, await AssetStore.open(folder, 1e6), render, (error) => reported.push(error));

/** Orders that many lines, and says how their states are to be asked for. */
function order(lines: number): () => readonly string[] {
  const cart = database.makeCart();
  for (let line = 0; line < lines; line++) database.addLine(cart, ITEM);
  const id = database.order(cart, "Ada") as string;
  return () => database.orderOf(id)?.lines.map(({ status }) => status) ?? [];
}

it.each(["nextToPrint", "waitAgain"] as const)(
  "a database that fails at %s is reported, and asked again later",
  async (call) => {
    const full = new Error("database or disk is full");
    vi.spyOn(database, call).mockImplementationOnce(() => {
      throw full;
    });
    const queue = await queueThat(async () => PRINT);
    const states = order(2);
    queue.wake();
    await queue.idle();
    expect(reported).toEqual([full]);
    expect(states()).toEqual(["waiting", "waiting"]);
    queue.wake();
    await queue.idle();
    expect(states()).toEqual(["ready", "ready"]);
  },
);

it.each([
  ["before a line is printed", 1, "waiting"],
  ["after a line was printed", 2, "rendering"],
])("a database that fails %s is reported, and the line is printed later", async (_when, nth, left) => {
  const full = new Error("database or disk is full");
  const setPrint = database.setPrint.bind(database);
  let calls = 0;
  vi.spyOn(database, "setPrint").mockImplementation((...told) => {
    calls += 1;
    if (calls === nth) throw full;
    setPrint(...told);
  });
  const queue = await queueThat(async () => PRINT);
  const states = order(2);
  queue.wake();
  await queue.idle();
  expect(reported).toEqual([full]);
  expect(states()).toEqual([left, "waiting"]);
  queue.wake();
  await queue.idle();
  expect(states()).toEqual(["ready", "ready"]);
  expect(reported).toHaveLength(1);
});

it("a press that fails as nobody expected holds the line, and the reason is in the log alone", async () => {
  const secret = new Error("ENOENT: /srv/shop/models/plane.glb");
  const queue = await queueThat(async () => {
    throw secret;
  });
  const states = order(1);
  queue.wake();
  await queue.idle();
  expect(states()).toEqual(["held"]);
  expect(reported).toEqual([secret]);
});

it("what is ordered while the queue finds nothing more is printed as well", async () => {
  const queue = await queueThat(async () => PRINT);
  const next = database.nextToPrint.bind(database);
  let states = (): readonly string[] => [];
  vi.spyOn(database, "nextToPrint").mockImplementationOnce(() => {
    const nothing = next();
    queueMicrotask(() => {
      states = order(1);
      queue.wake();
    });
    return nothing;
  });
  queue.wake();
  await vi.waitUntil(() => states().length > 0);
  await queue.idle();
  expect(states()).toEqual(["ready"]);
});

/** A shop with one product, a plane, in folders of its own; and what a customer's page would send to it. */
import { createHash } from "node:crypto";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import type { LightMyRequestResponse } from "fastify";
import { afterAll } from "vitest";
import { createShopServer, type ShopServer, type ShopServerOptions } from "../../node/storefront/shop-server.ts";
import type { Product } from "../../web/storefront/api/shop-api.ts";
import { FACING_DOWN, plainPng, planeGlb } from "../node/plane-model.ts";

export const PLANE: Product = {
  id: "plane",
  name: "Plane",
  tagline: "Flat",
  description: "A flat thing.",
  facts: [{ name: "Sides", value: "1" }],
  model: "demo/plane.glb",
  zones: "shop/plane.zones.json",
  picture: "shop/plane.png",
  poster: "shop/plane.png",
  material: 0,
  camera: "0deg 0deg 100%",
  price: { currency: "EUR", base: 1000, perDecal: 150, perSquareCentimetre: 0 },
};

/** The left half of the plane is printed: what lies on the right is cut off. */
export const ZONES = {
  texelcastZones: 1,
  zones: [
    {
      id: "left",
      shape: {
        kind: "uv",
        polygon: [
          [0.25, 0.25],
          [0.5, 0.25],
          [0.5, 0.75],
          [0.25, 0.75],
        ],
      },
    },
  ],
};

const PRESS = new URL("../../build/node/storefront-press.mjs", import.meta.url);

export const sha256 = (bytes: Uint8Array): string => createHash("sha256").update(bytes).digest("hex");

export const LOGO = await plainPng(8, 8, [200, 30, 40, 255]);
export const SNAPSHOT = await plainPng(4, 4, [10, 20, 30, 255]);
const TEXTURE = await plainPng(64, 64, [240, 240, 240, 255]);

const projector = { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [2, 1, 1] };

/** A design document with one decal, as the element exports it; `fields` change the decal, `asset` its file. */
export const designWith = (fields: object = {}, asset: object = {}): object => ({
  format: "texelcast-design",
  version: 1,
  assets: { logo: { type: "image/png", uri: `assets/${sha256(LOGO)}.png`, ...asset } },
  layers: [{ id: "logo", type: "decal", name: "Logo", asset: "logo", projector, ...fields }],
});

export interface TestShop extends ShopServer {
  readonly folder: string;
  /** What the server told its log. */
  readonly reported: unknown[];
  putFile(bytes: Uint8Array, name?: string): Promise<LightMyRequestResponse>;
  /** A new cart's id. */
  cart(): Promise<string>;
  /** A line that can be taken in, its files stored. */
  line(changes?: object): Promise<object>;
  addLine(cart: string, body: unknown): Promise<LightMyRequestResponse>;
}

/** How each shop is ended: said here, as a shop opened inside a test is too late for a hook of its own. */
const opened: (() => Promise<void>)[] = [];
afterAll(async () => {
  for (const end of opened) await end();
});

/** Opens a shop on a folder (a new one without), and ends it after the file's tests. */
export async function openShop({
  folder = mkdtempSync(path.join(tmpdir(), "texelcast-shop-")),
  ...options
}: { folder?: string } & Partial<ShopServerOptions> = {}): Promise<TestShop> {
  const site = path.join(folder, "site");
  for (const name of ["shop", "demo"]) mkdirSync(path.join(site, name), { recursive: true });
  writeFileSync(path.join(site, "index.html"), "<!doctype html><title>Shop</title>");
  writeFileSync(path.join(site, "shop/products.json"), JSON.stringify([PLANE]));
  writeFileSync(path.join(site, "shop/plane.zones.json"), JSON.stringify(ZONES));
  writeFileSync(path.join(site, "demo/plane.glb"), planeGlb({ texture: TEXTURE }));
  const reported: unknown[] = [];
  const server = await createShopServer({
    site,
    store: path.join(folder, "files"),
    database: path.join(folder, "shop.sqlite"),
    report: (error) => reported.push(error),
    press: { script: PRESS },
    // As many as a file's tests ask at once.
    requestsPerMinute: 10_000,
    linesPerMinute: 10_000,
    ...options,
  });
  opened.push(async () => {
    await server.app.close();
    rmSync(folder, { recursive: true, force: true });
  });
  const shop: TestShop = {
    ...server,
    folder,
    reported,
    putFile: (bytes, name = sha256(bytes)) =>
      server.app.inject({
        method: "PUT",
        url: `/api/files/${name}`,
        headers: { "content-type": "application/octet-stream" },
        payload: Buffer.from(bytes),
      }),
    cart: async () => (await server.app.inject({ method: "POST", url: "/api/carts" })).json().id,
    async line(changes = {}) {
      for (const file of [LOGO, SNAPSHOT]) await shop.putFile(file);
      return {
        product: "plane",
        design: designWith(),
        assets: [{ key: "logo", sha256: sha256(LOGO) }],
        approved: { sha256: "0".repeat(64), width: 64, height: 64 },
        snapshot: sha256(SNAPSHOT),
        unitPrice: 1150,
        quantity: 1,
        ...changes,
      };
    },
    addLine: (cart, body) =>
      server.app.inject({
        method: "POST",
        url: `/api/carts/${cart}/lines`,
        headers: { "content-type": "application/json" },
        payload: typeof body === "string" ? body : JSON.stringify(body),
      }),
  };
  return shop;
}

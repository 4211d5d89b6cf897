/** Makes every file of the example shop in memory. Pictures of the products are kept beside this file: they are taken from the real page. */
import { readFile } from "node:fs/promises";
import type { DemoFile } from "../generate.ts";
import { SHOP_PRODUCTS } from "./products.ts";
import { shopZones } from "./zones.ts";

const json = (data: unknown): Uint8Array<ArrayBuffer> => new TextEncoder().encode(`${JSON.stringify(data, null, 2)}\n`);

/** Paths are relative to the shop's folder. */
export async function* generateShop(): AsyncGenerator<DemoFile> {
  yield { path: "products.json", bytes: json(SHOP_PRODUCTS) };
  for (const [id, zones] of Object.entries(shopZones())) yield { path: `${id}.zones.json`, bytes: json(zones) };
  for (const name of SHOP_PRODUCTS.flatMap(({ id }) => [`${id}.webp`, `${id}-plain.webp`])) {
    const picture = await readFile(new URL(`pictures/${name}`, import.meta.url));
    yield { path: name, bytes: new Uint8Array(picture) };
  }
}

/**
 * `npm run shop-pictures`: takes the pictures of the example shop's products from its real product page, plain and with
 * the demo's design on it, and keeps them in scripts/demo/shop/pictures.
 */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "@playwright/test";
import { createShopServer } from "../node/storefront/shop-server.ts";
import type { TexelcastEditorApi } from "../web/element/element-api.ts";
import { chromiumLaunch } from "./bootstrap/chromium.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";
import { DEMO_MODELS, demoIndex } from "./demo/catalogue.ts";
import { SHOP_PRODUCTS } from "./demo/shop/products.ts";

/** Pixels of a side: twice that of a card. */
const SIDE = 800;
const QUALITY = 0.86;

await bootstrapOrExit("storefront");
const data = mkdtempSync(join(tmpdir(), "texelcast-shop-"));
const { app } = await createShopServer({
  site: inRoot("build/storefront"),
  store: join(data, "files"),
  database: ":memory:",
});
const browser = await chromium.launch(chromiumLaunch());
try {
  const address = await app.listen({ port: 0, host: "localhost" });
  for (const { id, model, camera } of SHOP_PRODUCTS) {
    const page = await browser.newPage();
    await page.goto(`${address}/product.html?product=${id}`);
    await page.waitForFunction(() => document.querySelector<Editor>("texelcast-editor")?.loaded);
    const take = async (name: string): Promise<void> => {
      const picture = await page.evaluate(takePicture, { camera, side: SIDE, quality: QUALITY });
      const file = inRoot(`scripts/demo/shop/pictures/${name}.webp`);
      writeFileSync(file, Buffer.from(picture, "base64"));
      console.log(file);
    };
    await take(`${id}-plain`);
    await page.evaluate(openDesign, designFor(model));
    await take(id);
    await page.close();
  }
} finally {
  await browser.close();
  await app.close();
  rmSync(data, { recursive: true });
}

type Editor = HTMLElement & TexelcastEditorApi;

/** The design that the demo opens that model with; its pictures' addresses are relative to `demo/`. */
function designFor(model: string): object {
  const { models } = JSON.parse(demoIndex()) as { models: { model: string; design: object }[] };
  const found = models.find((one) => one.model === model);
  if (found === undefined) throw new Error(`${model} is none of ${DEMO_MODELS.map(({ id }) => id).join(", ")}`);
  return found.design;
}

/** Runs in the page. */
async function openDesign(design: object): Promise<void> {
  const editor = document.querySelector<Editor>("texelcast-editor");
  if (!editor) throw new Error("The page has no editor.");
  const { assets } = design as { assets: Record<string, { uri: string }> };
  const files = Object.values(assets).map(async ({ uri }) => {
    const bytes = new Uint8Array(await (await fetch(`demo/${uri}`)).arrayBuffer());
    return { name: uri, bytes };
  });
  const opened = new Promise((resolve) => editor.addEventListener("change", resolve, { once: true }));
  editor.design = { design, assets: await Promise.all(files) };
  await opened;
}

interface PictureOptions {
  readonly camera: string;
  readonly side: number;
  readonly quality: number;
}

/** Runs in the page. Base64 of a WebP. */
async function takePicture({ camera, side, quality }: PictureOptions): Promise<string> {
  const editor = document.querySelector<Editor>("texelcast-editor");
  if (!editor) throw new Error("The page has no editor.");
  const png = await editor.snapshot(camera as `${string} ${string} ${string}`, { width: side, height: side });
  const canvas = new OffscreenCanvas(side, side);
  canvas.getContext("2d")?.drawImage(await createImageBitmap(png), 0, 0);
  const webp = await canvas.convertToBlob({ type: "image/webp", quality });
  let binary = "";
  for (const byte of new Uint8Array(await webp.arrayBuffer())) binary += String.fromCharCode(byte);
  return btoa(binary);
}

/**
 * The paper's teaser from the real page and core, panel by panel: docs/figures/*.png, and all of them on one sheet,
 * docs/figures/teaser.png. The flat stamp, by the `uv` projector, stands for painting without the method.
 */
import { mkdir, writeFile } from "node:fs/promises";
import { chromium } from "@playwright/test";
import { build, preview } from "vite";
import { EditorPage } from "../../tests/e2e/support/editor-page.ts";
import { chromiumLaunch } from "../bootstrap/chromium.mjs";
import { inRoot } from "../bootstrap/paths.mjs";
import { composeSheet, drawUnfolded, type Panel, resized } from "./compose.ts";
import { blankModel, flatStamp, handPainted, mapPanels, targetPanel } from "./core-panels.ts";
import { PagePanels } from "./page-panels.ts";
import { avatar, BELT, DRESSED, decalPng, designOf, LOGO, TRANSFORMS } from "./subject.ts";

/** Pixels along a side of a panel that shows a texture. */
const TEXTURE_SIDE = 512;

const configFile = inRoot("vite.config.ts");
await build({ configFile, logLevel: "warn" });
const server = await preview({ configFile, preview: { port: 4181 } });
const browser = await chromium.launch(chromiumLaunch());
try {
  const context = await browser.newContext({
    baseURL: server.resolvedUrls?.local[0],
    viewport: { width: 1500, height: 720 },
    colorScheme: "light",
  });
  const sheet = await context.newPage();
  const editor = new EditorPage(await context.newPage());
  await editor.open();
  const pages = new PagePanels(editor);
  const texture = (png: Uint8Array) => resized(sheet, png, TEXTURE_SIDE);

  const maps = await mapPanels();
  const belt = await designOf([BELT]);
  const dressed = await designOf(DRESSED);
  const flat = await flatStamp(BELT);
  const strokes = await handPainted();

  const mesh = await pages.model("mesh.glb", await blankModel());
  const bare = await pages.model("avatar.glb", await avatar());
  const painted = await pages.design(dressed);
  const strokesOnModel = await pages.design(strokes);
  await pages.comeClose(BELT.position[1]);
  const strokesNearBy = await pages.design(strokes);
  const flatOnModel = await pages.design(flat);
  const logo = await pages.design(await designOf([LOGO]));
  const projectedOnModel = await pages.design(belt);
  const stamps: Panel[] = [];
  for (const [index, { name, stamp }] of TRANSFORMS.entries()) {
    const png = await pages.design(await designOf([stamp]));
    stamps.push({ name: `stamp-${index + 1}`, caption: `stamp, ${name}`, png });
  }

  const unfolded = await drawUnfolded(sheet, maps.uvTriangles, TEXTURE_SIDE);
  const rows: Panel[][] = [
    [
      { name: "model", caption: "model", png: bare },
      { name: "mesh", caption: "mesh", png: mesh },
      { name: "unfolded", caption: "mesh, unfolded", png: unfolded },
      { name: "positions", caption: "position map", png: await texture(maps.positions) },
      { name: "normals", caption: "normal map", png: await texture(maps.normals) },
    ],
    [{ name: "decal", caption: "decal", png: await texture(await decalPng(BELT.decal)) }, ...stamps],
    [
      { name: "flat-texture", caption: "flat stamp, texture", png: await texture(await targetPanel(flat)) },
      { name: "flat-model", caption: "flat stamp, model", png: flatOnModel },
      { name: "projected-texture", caption: "projection, texture", png: await texture(await targetPanel(belt)) },
      { name: "projected-model", caption: "projection, model", png: projectedOnModel },
    ],
    [
      { name: "target", caption: "target texture", png: await texture(await targetPanel(dressed)) },
      { name: "painted", caption: "target texture on the model", png: painted },
      { name: "logo", caption: "logo", png: await texture(await decalPng(LOGO.decal)) },
      { name: "logo-model", caption: "logo on the model", png: logo },
    ],
    [
      {
        name: "strokes-texture",
        caption: "hand-painted strokes, texture",
        png: await texture(await targetPanel(strokes)),
      },
      { name: "strokes", caption: "hand-painted strokes", png: strokesOnModel },
      { name: "strokes-near", caption: "hand-painted strokes, near by", png: strokesNearBy },
    ],
  ];
  const folder = inRoot("docs/figures");
  await mkdir(folder, { recursive: true });
  const teaser: Panel = { name: "teaser", caption: "", png: await composeSheet(sheet, rows) };
  for (const { name, png } of [...rows.flat(), teaser]) {
    await writeFile(`${folder}/${name}.png`, png);
    console.log(`docs/figures/${name}.png  ${(png.length / 1024).toFixed(0)} KiB`);
  }
} finally {
  await browser.close();
  await server.close();
}

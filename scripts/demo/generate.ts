/** Makes every file of the demo in memory, so that a test can compare two runs. */

import { readFile } from "node:fs/promises";
import { DEMO_DECALS, DEMO_TEMPLATES, demoIndex, TEMPLATE_PICTURE_WIDTH } from "./catalogue.ts";
import { buildAvatar } from "./models/avatar.ts";
import { buildBlockFigure } from "./models/block-figure.ts";
import { buildMug } from "./models/mug.ts";
import { buildSkateboard } from "./models/skateboard.ts";
import { encodePng } from "./picture/png.ts";
import { renderSvg } from "./picture/svg.ts";

export interface DemoFile {
  /** Relative to the demo's folder. */
  readonly path: string;
  readonly bytes: Uint8Array;
}

/** Files in the order in which they become ready. */
export async function* generateDemo(): AsyncGenerator<DemoFile> {
  yield { path: "demo.json", bytes: new TextEncoder().encode(demoIndex()) };
  for (const { id, width } of DEMO_DECALS) yield await drawing("decals", id, width);
  for (const { picture } of DEMO_TEMPLATES) yield await drawing("templates", picture, TEMPLATE_PICTURE_WIDTH);
  yield { path: "mug.glb", bytes: await buildMug() };
  yield { path: "avatar.glb", bytes: await buildAvatar() };
  yield { path: "skateboard.glb", bytes: await buildSkateboard() };
  yield { path: "block-wide.glb", bytes: await buildBlockFigure("wide") };
  yield { path: "block-slim.glb", bytes: await buildBlockFigure("slim") };
}

async function drawing(folder: string, name: string, width: number): Promise<DemoFile> {
  const svg = await readFile(new URL(`${folder}/${name}.svg`, import.meta.url), "utf8");
  return { path: `${folder}/${name}.png`, bytes: await encodePng(await renderSvg(svg, width)) };
}

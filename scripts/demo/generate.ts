/** Makes every file of the demo in memory, so that a test can compare two runs. */

import { readFile } from "node:fs/promises";
import { DEMO_DECALS, demoIndex } from "./catalogue.ts";
import { buildAvatar } from "./models/avatar.ts";
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
  for (const { id, width } of DEMO_DECALS) {
    const svg = await readFile(new URL(`decals/${id}.svg`, import.meta.url), "utf8");
    yield { path: `decals/${id}.png`, bytes: await encodePng(await renderSvg(svg, width)) };
  }
  yield { path: "mug.glb", bytes: await buildMug() };
  yield { path: "avatar.glb", bytes: await buildAvatar() };
  yield { path: "skateboard.glb", bytes: await buildSkateboard() };
}

/** A drag of local10 at 2048 x 2048 in the built editor page, and what its own thread does in a frame of it. */
import { fileURLToPath } from "node:url";
import type { Browser } from "@playwright/test";
import { build, preview } from "vite";
import { EditorPage } from "../../tests/e2e/support/editor-page.ts";
import { dragLocal10, local10Files, openLocal10 } from "../../tests/e2e/support/local10-drag.ts";
import { type FrameWork, frameWork, TRACE_CATEGORIES } from "./trace-frames.ts";

const MOVES = 150;

export async function measurePageDrag(browser: Browser): Promise<FrameWork> {
  const configFile = fileURLToPath(new URL("../../vite.config.ts", import.meta.url));
  await build({ configFile, logLevel: "warn" });
  const server = await preview({ configFile, preview: { port: 4191 } });
  try {
    const page = await browser.newPage({
      baseURL: server.resolvedUrls?.local[0],
      viewport: { width: 1280, height: 800 },
    });
    const editor = new EditorPage(page);
    await openLocal10(editor, await local10Files());
    // Once to warm up: code is compiled, and the view settles on what the graphics card can draw.
    await dragLocal10(editor, 20);
    await page.mouse.up();
    await editor.idle();
    await browser.startTracing(page, { categories: TRACE_CATEGORIES });
    await dragLocal10(editor, MOVES);
    const trace = await browser.stopTracing();
    await page.close();
    return frameWork(JSON.parse(trace.toString()).traceEvents);
  } finally {
    await server.close();
  }
}

/** A page that is left open all day: what is gone from it is gone from memory, too. */
import { readFileSync } from "node:fs";
import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { demoFile, file } from "./support/test-files.ts";

const OWN_FONT = new URL(
  "../../node_modules/@expo-google-fonts/lobster/400Regular/Lobster_400Regular.ttf",
  import.meta.url,
);

declare global {
  interface Window {
    heldTextures: number;
  }
}

test("layers that are chosen and left, and texts that come and go, leave no panel behind", async ({ editor, page }) => {
  const id = await editor.openOnLowest();
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  /** Of the whole page, also those that are in none of its trees any more. */
  const heldNodes = async (): Promise<number> => {
    await session.send("HeapProfiler.collectGarbage");
    const { metrics } = await session.send("Performance.getMetrics");
    return metrics.find(({ name }) => name === "Nodes")?.value ?? 0;
  };
  const round = async () => {
    await editor.addLayer("Add text");
    await editor.idle();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+z");
    await page.evaluate(() => window.texelcast.select(null));
    await editor.idle();
    await editor.select(id);
    await editor.idle();
  };
  await round();
  const before = await heldNodes();
  for (let i = 0; i < 4; i++) await round();
  // A panel has some seven hundred.
  expect((await heldNodes()) - before).toBeLessThan(300);
});

test("rows of layers that come and go leave nothing in their list", async ({ editor, page }) => {
  await editor.openOnLowest();
  await editor.addLayer("Add text");
  await editor.idle();
  await page.keyboard.press("Escape");
  const nodes = () => page.locator("tc-layer-list .content").evaluate((content) => content.childNodes.length);
  const before = await nodes();
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press("Control+z");
    await expect(page.locator("tc-layer-list .row")).toHaveCount(2);
    await page.keyboard.press("Control+Shift+z");
    await expect(page.locator("tc-layer-list .row")).toHaveCount(3);
  }
  expect(await nodes()).toBe(before);
});

test("models that are opened one after the other leave no textures on the graphics card", async ({ editor, page }) => {
  await page.addInitScript(() => {
    window.heldTextures = 0;
    const graphics = WebGL2RenderingContext.prototype;
    const { createTexture, deleteTexture } = graphics;
    const held = new WeakSet<WebGLTexture>();
    graphics.createTexture = function () {
      const texture = createTexture.call(this);
      held.add(texture);
      window.heldTextures++;
      return texture;
    };
    graphics.deleteTexture = function (texture) {
      if (texture && held.delete(texture)) window.heldTextures--;
      deleteTexture.call(this, texture);
    };
  });
  await editor.open();
  const textures = () => page.evaluate(() => window.heldTextures);
  await openBoth(editor);
  const before = await textures();
  await openBoth(editor);
  expect(await textures()).toBe(before);
});

test("fonts of one's own leave the page with the last step that had them", async ({ editor, page }) => {
  await editor.open();
  const session = await page.context().newCDPSession(page);
  /** Families that letters in the lists are written in. */
  const ownFamilies = async (): Promise<number> => {
    await session.send("HeapProfiler.collectGarbage");
    return page.evaluate(() => [...document.fonts].filter(({ family }) => family.includes("texelcast-own")).length);
  };
  const letters = page.locator("tc-layer-list .thumbnail.words");
  for (const _time of ["first", "second"]) {
    await editor.drop([file("Own.ttf", readFileSync(OWN_FONT), "font/ttf")], await editor.middleOfStage());
    await expect(letters).toHaveCount(1);
    await expect.poll(ownFamilies).toBe(1);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+z");
    await expect(letters).toHaveCount(0);
    // What was undone cannot be had again from now on.
    await editor.addDemoDecal("badge");
    await expect.poll(ownFamilies).toBe(0);
  }
});

/** The one has joints and moves by them, the other has none. */
async function openBoth(editor: EditorPage): Promise<void> {
  for (const name of ["avatar.glb", "skateboard.glb"]) {
    await editor.openModel([demoFile(name)]);
    await editor.idle();
  }
}

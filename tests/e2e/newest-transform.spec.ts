import type { Design } from "../../web/editor/document/index.ts";
import { resolveLayers } from "../../web/editor/document/index.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { expect, test } from "./support/editor-page.ts";
import { dragLocal10, LOCAL10_ASSET, LOCAL10_SIZE, local10Files, openLocal10 } from "./support/local10-drag.ts";

const files = local10Files();

/** What a fresh engine in Node paints of a design. */
async function freshHash(design: Design): Promise<string> {
  const { model, decal } = await files;
  const engine = createEngineHost();
  await engine.loadModel({ name: model.name, bytes: model.buffer });
  await engine.setAsset(LOCAL10_ASSET, { name: decal.name, bytes: decal.buffer });
  await engine.openTarget({ material: 0, width: LOCAL10_SIZE, height: LOCAL10_SIZE });
  engine.setLayers(resolveLayers(design), 1);
  await engine.idle();
  const hash = await engine.hash(0);
  engine.dispose();
  return hash;
}

test("a drag that does not wait for the engine ends on what a fresh render of the newest transform gives", async ({
  editor,
}) => {
  await openLocal10(editor, await files);
  const before = await editor.stats();
  const start = await editor.settledHash();

  await dragLocal10(editor, 40);
  await editor.idle();
  const held = await editor.design();
  const inDrag = await editor.hash();
  const during = await editor.stats();
  expect(inDrag).not.toBe(start);
  expect(inDrag, "while the button is down").toBe(await freshHash(held));
  expect(during.shownRevision, "the views show the newest transform").toBe(during.revision);
  expect(during.revision - before.revision, "the drag gave the engine many transforms").toBeGreaterThan(10);
  expect(during.bakeCount).toBe(before.bakeCount);

  await editor.page.mouse.up();
  expect(await editor.settledHash(), "after the drag").toBe(await freshHash(await editor.design()));
});

import type { Page } from "@playwright/test";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import { manySidedModel } from "../support/many-sided-model.ts";
import { type EditorPage, expect, type TestFile, test } from "./support/editor-page.ts";
import { sharedFile, skipWithoutShared } from "./support/shared-files.ts";
import { demoFile, file, glbWithoutUvs } from "./support/test-files.ts";

/** Opens a model that cannot be opened, over work that must still be there afterwards. */
async function refuses(editor: EditorPage, page: Page, model: TestFile, code: RegExp): Promise<void> {
  await editor.open();
  await editor.addDemoDecal("flower");
  const before = { hash: await editor.settledHash(), design: await editor.design() };
  await editor.openModel([model]);
  await expect(editor.notices).toHaveCount(1);
  await expect(editor.notices).toHaveAttribute("data-code", code);
  await expect(editor.notices).toContainText(`Could not open ${model.name}`);
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
  expect({ hash: await editor.settledHash(), design: await editor.design() }).toEqual(before);

  // The page goes on: the decal moves and the texture with it.
  await page.keyboard.press("Shift+ArrowLeft");
  expect(await editor.settledHash()).not.toBe(before.hash);
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();
  await expect(editor.notices).toHaveCount(0);
}

test("a truncated GLB is refused and the work stays", async ({ editor, page }) => {
  const { buffer } = demoFile("mug.glb");
  const half = file("half.glb", buffer.subarray(0, buffer.length >> 1));
  await refuses(editor, page, half, /^(bad-model|bad-container)$/);
});

test("a text file named .glb is refused and the work stays", async ({ editor, page }) => {
  await refuses(editor, page, file("poem.glb", "Rose, oh reiner Widerspruch"), /^(bad-model|bad-container)$/);
});

test("a model with a number for a name is refused by the field's name and value", async ({ editor, page }) => {
  const { json, binary } = manySidedModel();
  Object.assign((json.meshes as object[])[0] ?? {}, { name: 5 });
  const model = file("named.glb", writeGlb(json, binary));
  await refuses(editor, page, model, /^bad-container$/);
  await editor.openModel([model]);
  await expect(editor.notices).toContainText("“meshes[0].name” must be a text, and is 5");
});

test("a model without texture coordinates is refused, with what to do, and the work stays", async ({
  editor,
  page,
}) => {
  await refuses(editor, page, glbWithoutUvs(), /^no-uvs$/);
});

test("RiggedFigure.glb, which has no texture coordinates, is refused", async ({ editor, page }) => {
  skipWithoutShared();
  await refuses(editor, page, sharedFile("RiggedFigure.glb"), /^no-uvs$/);
});

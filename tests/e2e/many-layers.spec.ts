import { manyLayersHash } from "../support/many-layers.ts";
import { hashManyLayersInPage, manyLayersInput } from "../support/many-layers-page.ts";
import { expect, test } from "./support/editor-page.ts";

test("many layers give the one hash in the browser that Node and native code give", async ({ editor, page }) => {
  await editor.open();
  expect(await page.evaluate(hashManyLayersInPage, manyLayersInput())).toBe(manyLayersHash);
});

/** Decals that are dropped where nothing of them could be seen: on parts without texels of their own, on models turned inside out. */

import type { DecalLayer } from "../../web/editor/document/index.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import { buildModel, type MeshParts, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { type EditorPage, expect, type TestFile, test } from "./support/editor-page.ts";
import { file } from "./support/test-files.ts";

const PICTURE = file("red.png", solidPng(8, 8, [255, 0, 0, 255]), "image/png");

/** Two squares side by side that show the same texels: the left one owns them. */
function twins(): TestFile {
  const at = (x: number): MeshParts => {
    const { positions, ...rest } = plane(1, 0);
    return { ...rest, positions: positions.map((value, i) => (i % 3 === 0 ? value + x : value)) };
  };
  const { json, binary } = buildModel({ meshes: [at(-0.55), at(0.55)], materials: [{ name: "Board" }] });
  return file("twins.glb", writeGlb(json, binary));
}

/** A square whose front is seen from behind, as of a model that is turned inside out and drawn from both sides. */
function turnedSquare(): TestFile {
  const { positions, uvs = [] } = plane(1, 0);
  const square = { positions, uvs, indices: [0, 2, 1, 0, 3, 2], material: 0 };
  const { json, binary } = buildModel({ meshes: [square], materials: [{ name: "Board", doubleSided: true }] });
  return file("turned.glb", writeGlb(json, binary));
}

async function dropAt(editor: EditorPage, aside: number): Promise<void> {
  const { x, y } = await editor.middleOfStage();
  const { layers } = await editor.design();
  await editor.drop([PICTURE], { x: x + aside, y });
  await expect.poll(async () => (await editor.design()).layers.length).toBe(layers.length + 1);
}

for (const [locale, told, unwrap] of [
  ["en-GB", "Nothing can be painted there", "Unwrap it"],
  ["de-DE", "Dort lässt sich nichts malen", "Abwickeln"],
] as const) {
  test.describe(`in ${locale}`, () => {
    test.use({ locale });

    test("a decal on a part that owns none of its texels says so where it is dropped, with a way out", async ({
      editor,
      page,
    }) => {
      await editor.open();
      await editor.drop([twins()], await editor.middleOfStage());
      await expect(page.locator("tc-top-bar .models")).toContainText("twins");
      await editor.idle();
      await dropAt(editor, -120);
      await expect(editor.notices, "what it is told on a part that owns them").not.toContainText(told);
      const before = await editor.settledHash();
      await dropAt(editor, 120);
      await expect(editor.notices).toContainText(told);
      expect(await editor.settledHash(), "it is painted nowhere").toBe(before);
      await editor.notices.getByRole("button", { name: unwrap }).click();
      await expect.poll(() => editor.settledHash()).not.toBe(before);
    });
  });
}

test("the first decal on parts that share texture tells that others show it too, once, with a way out", async ({
  editor,
}) => {
  await editor.open();
  await editor.openModel([twins()]);
  const told = editor.notices.filter({ hasText: "What is painted on one of them shows on the others too." });
  await expect(told).toHaveCount(0);
  await dropAt(editor, -120);
  await expect(told).toHaveCount(1);
  await dropAt(editor, -100);
  await expect(told).toHaveCount(0);
});

test("so does the first stroke, and the parts are told apart from there", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([twins()]);
  await page.keyboard.press("b");
  const { x, y } = await editor.middleOfStage();
  await editor.drag({ x: x - 140, y }, { x: x - 100, y }, 4);
  await editor.idle();
  const told = editor.notices.filter({ hasText: "What is painted on one of them shows on the others too." });
  await told.getByRole("button", { name: "Give each part its own texture" }).click();
  await expect(page.locator("tc-target-settings .warning")).toBeHidden();
  await expect(told).toHaveCount(0);
});

test("a decal on a model that is turned inside out is painted on what is seen, the right way round", async ({
  editor,
}) => {
  await editor.open();
  await editor.openModel([turnedSquare()]);
  const before = await editor.settledHash();
  await dropAt(editor, 0);
  expect(await editor.settledHash()).not.toBe(before);
  const [layer] = (await editor.design()).layers as DecalLayer[];
  expect(layer?.backfaces).toBe(true);
  await expect(editor.notices).toHaveCount(0);
});

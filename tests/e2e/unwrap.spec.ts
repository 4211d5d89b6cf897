/** A model whose parts share texture, unwrapped from the texture's panel. */
import { createHash } from "node:crypto";
import type { Page } from "@playwright/test";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { buildGlb, buildModel } from "../support/model-builder.ts";
import { type EditorPage, expect, type Point, type TestFile, test } from "./support/editor-page.ts";
import { boardPicture, file, glbWithBrokenUvs, glbWithoutUvs, halfBareGlb } from "./support/test-files.ts";

/** Two squares side by side, each on the whole texture. */
function twins(): Buffer {
  const square = (x: number) => ({
    positions: [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0],
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
    material: 0,
  });
  return Buffer.from(buildGlb({ meshes: [square(0), square(1.5)], materials: [{ name: "Paint" }] }));
}

/** SHA-256 of the same model, unwrapped here. */
async function hashInNode(): Promise<string> {
  const { glb } = await unwrapModel({ name: "twins.glb", bytes: twins() }, { materials: [0], size: 1024 });
  const engine = createEngineHost();
  try {
    await engine.loadModel({ name: "twins.glb", bytes: glb });
    return createHash("sha256")
      .update(await engine.exportGlb([]))
      .digest("hex");
  } finally {
    engine.dispose();
  }
}

test("parts that share texture get their own at a press, and undo brings the old model back", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([{ name: "twins.glb", mimeType: "model/gltf-binary", buffer: twins() }]);
  const settings = page.locator("tc-target-settings");
  const button = settings.getByRole("button", { name: "Give each part its own texture" });
  await expect(settings.locator(".warning")).toBeVisible();
  await button.click();
  await expect(button).toBeHidden({ timeout: 30_000 });
  await editor.idle();
  await expect(settings.locator(".warning")).toBeHidden();
  await expect(settings.locator("dd").last()).toHaveText("0.0 %");
  const inPage = await page.evaluate(async () => Array.from(await window.texelcast.engine.exportGlb([])));
  expect(createHash("sha256").update(Uint8Array.from(inPage)).digest("hex"), "the bytes of Node").toBe(
    await hashInNode(),
  );
  await page.keyboard.press("Control+z");
  await expect(button).toBeVisible();
  await expect(settings.locator(".warning")).toBeVisible();
});

test("what lies flat on the old texture is hidden when it is unwrapped, which is said, and undo brings it back", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([{ name: "twins.glb", mimeType: "model/gltf-binary", buffer: twins() }]);
  await editor.addDemoDecal("flower");
  await editor.addDemoDecal("smiley");
  await page.getByRole("radio", { name: "Flat", exact: true }).click();
  await editor.idle();
  const before = { hash: await editor.settledHash(), design: await editor.design() };
  const shown = async (): Promise<boolean[]> => (await editor.design()).layers.map(({ visible }) => visible);
  expect(await shown()).toEqual([true, true]);
  await page.getByRole("button", { name: "Give each part its own texture" }).click();
  await expect(editor.notices).toContainText(
    "1 layer that lies on the texture itself would lie elsewhere now: hidden, not deleted. Undo brings the old model back.",
  );
  await expect(editor.notices).toHaveAttribute("role", "status");
  await editor.idle();
  expect(await shown(), "the one on the model stays").toEqual([true, false]);
  await page.keyboard.press("Control+z");
  await expect.poll(shown).toEqual([true, true]);
  expect({ hash: await editor.settledHash(), design: await editor.design() }).toEqual(before);
});

test.describe("a model without texture coordinates", () => {
  /** What is open, to the texel. */
  const opened = async (editor: EditorPage) => ({ hash: await editor.settledHash(), design: await editor.design() });

  const refuse = async (editor: EditorPage, model: TestFile, code = "no-uvs") => {
    await editor.openModel([model]);
    await expect(editor.notices).toHaveAttribute("data-code", code);
    return editor.notices.getByRole("button", { name: "Unwrap and open" });
  };

  test("is unwrapped and opened by a key where it is refused, and undo brings back what was open", async ({
    editor,
    page,
  }) => {
    await editor.open();
    await editor.addDemoDecal("flower");
    const before = await opened(editor);
    const offer = await refuse(editor, glbWithoutUvs());
    expect(await opened(editor), "only offered").toEqual(before);
    await offer.press("Enter");
    await expect(page.locator("tc-top-bar .models")).toContainText("bare");
    await editor.idle();
    await expect(editor.notices.getByText("Could not open")).toHaveCount(0);
    expect((await editor.design()).layers).toEqual([]);
    const bare = await editor.hash();
    await editor.addDemoDecal("flower");
    expect(await editor.settledHash(), "it takes paint").not.toBe(bare);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
    expect(await opened(editor)).toEqual(before);
  });

  test("opens with the pictures that were dropped with it", async ({ editor, page }) => {
    await editor.open();
    await editor.drop([glbWithoutUvs(), boardPicture()], await editor.middleOfStage());
    await editor.notices.getByRole("button", { name: "Unwrap and open" }).click();
    await expect(page.locator("tc-top-bar .models")).toContainText("bare");
    await expect.poll(async () => (await editor.design()).layers.map(({ name }) => name)).toEqual(["board"]);
  });

  test("is unwrapped and opened as well where its coordinates are broken", async ({ editor, page }) => {
    await editor.open();
    for (const [name, coordinate] of [
      ["none.glb", Number.NaN],
      ["far.glb", 1e30],
      ["repeated.glb", 60_000],
    ] as const) {
      const offer = await refuse(editor, glbWithBrokenUvs(name, coordinate), "bad-uvs");
      await expect(editor.notices).toContainText(`The texture coordinates of ${name} are broken`);
      await offer.click();
      await expect(page.locator("tc-top-bar .models")).toContainText(name.replace(".glb", ""));
      await editor.idle();
      const bare = await editor.hash();
      await editor.addDemoDecal("flower");
      expect(await editor.settledHash(), "it takes paint").not.toBe(bare);
    }
  });

  test("stays unopened where its unwrapping is cancelled, is offered again, and what was open stays", async ({
    editor,
    page,
  }) => {
    await editor.open();
    await editor.addDemoDecal("flower");
    const before = await opened(editor);
    // The work does not come to its end by itself.
    await page.route("**/unwrap-worker-*.js", () => undefined, { times: 1 });
    await (await refuse(editor, glbWithoutUvs())).click();
    await page.locator("tc-notice-stack .task").getByRole("button", { name: "Cancel" }).press("Enter");
    await expect(page.locator("tc-notice-stack .task")).toHaveCount(0);
    expect(await opened(editor)).toEqual(before);
    await expect(editor.notices).toContainText("bare.glb was not opened");
    await expect(editor.notices).toHaveAttribute("role", "status");
    await editor.notices.getByRole("button", { name: "Unwrap and open" }).click();
    await expect(page.locator("tc-top-bar .models")).toContainText("bare");
    await expect(editor.notices.getByText("was not opened")).toHaveCount(0);
  });

  test("stays unopened where it cannot be unwrapped, which is said, and what was open stays", async ({ editor }) => {
    const { json, binary } = buildModel({ meshes: [{ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }] });
    (json.accessors as JsonObject[]).push({ componentType: 5126, type: "SCALAR", count: 2 });
    const [primitive] = (json.meshes as { primitives: { attributes: JsonObject }[] }[])[0]?.primitives ?? [];
    if (primitive) primitive.attributes._WEAR = 1;
    await editor.open();
    const before = await opened(editor);
    await (await refuse(editor, file("worn.glb", writeGlb(json, binary)))).click();
    await expect(editor.notices).toContainText("Could not unwrap the model");
    expect(await opened(editor)).toEqual(before);
  });

  test("is offered in the page's language", async ({ editor, page }) => {
    await page.addInitScript(() => localStorage.setItem("texelcast-language", "de"));
    await editor.open();
    await page.locator("tc-top-bar .models button").first().click();
    await editor.choose(() => page.getByRole("menuitem", { name: "Modell öffnen…" }).click(), [glbWithoutUvs()]);
    await expect(editor.notices).toContainText("bare.glb hat keine Texturkoordinaten");
    await editor.notices.getByRole("button", { name: "Abwickeln und öffnen" }).click();
    await expect(page.locator("tc-top-bar .models")).toContainText("bare");
  });
});

test.describe("a part without texture coordinates, of a model that has some", () => {
  const offer = (editor: EditorPage) => editor.notices.getByRole("button", { name: "Unwrap it" });

  /** The model, and the middle of its bare square on the page. */
  const open = async (editor: EditorPage, page: Page): Promise<Point> => {
    await editor.open();
    await editor.openModel([halfBareGlb()]);
    await editor.idle();
    return (await page.evaluate(() => window.texelcast.project(1.1, 0, 0))) as Point;
  };

  const takesPaint = async (editor: EditorPage) => {
    await expect(editor.notices).toContainText("It takes paint now");
    await editor.idle();
  };

  test("is unwrapped from where a picture was dropped on it, which lies there then", async ({ editor, page }) => {
    const place = await open(editor, page);
    await editor.drop([boardPicture()], place);
    await expect(editor.notices).toContainText("Rubber, takes no paint: no texture coordinates.");
    const { layers } = await editor.design();
    const hidden = page.locator("tc-parts-list li.off");
    await page.locator("tc-parts-list li button.eye").first().click();
    await expect(hidden).toHaveCount(1);
    await offer(editor).press("Enter");
    await takesPaint(editor);
    await expect(hidden, "seen as before").toHaveCount(1);
    expect((await editor.design()).layers).toEqual(layers);
    const painted = await editor.settledHash();
    await editor.action("delete").click();
    expect(await editor.settledHash(), "the picture was on the texture").not.toBe(painted);
    for (let step = 0; step < 2; step++) await page.keyboard.press("Control+z");
    await expect(page.locator("tc-target-settings #material option:disabled")).toHaveCount(1);
    expect((await editor.design()).layers).toEqual(layers);
  });

  test("is unwrapped from where a decal was dragged onto it, which lies there then", async ({ editor, page }) => {
    const place = await open(editor, page);
    const paper = (await page.evaluate(() => window.texelcast.project(0, 0, 0))) as Point;
    await editor.drop([boardPicture()], paper);
    await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
    await editor.idle();
    const id = await editor.lowestLayer();
    await editor.drag(paper, place, 8);
    await offer(editor).click();
    await takesPaint(editor);
    expect((await editor.decal(id)).material).toBe(1);
  });

  for (const [tool, key] of [
    ["brush", "b"],
    ["pencil", "n"],
    ["bucket", "g"],
  ] as const) {
    test(`is unwrapped from where the ${tool} found it bare, and takes the ${tool} then`, async ({ editor, page }) => {
      await page.emulateMedia({ reducedMotion: "reduce" });
      const middle = await open(editor, page);
      const corner = { x: middle.x, y: middle.y + 200 };
      await editor.drag(corner, { x: corner.x - 60, y: corner.y }, 4);
      const seen = () => page.evaluate(() => window.texelcast.project(1.1, 0, 0));
      await expect.poll(seen).not.toEqual(middle);
      await editor.idle();
      const place = (await seen()) as Point;
      if (tool !== "brush") await page.getByRole("checkbox", { name: "Pixel mode" }).check();
      await page.keyboard.press(key);
      await page.mouse.click(place.x, place.y);
      await expect(editor.notices).toContainText("Rubber, takes no paint: no texture coordinates.");
      await offer(editor).click();
      await takesPaint(editor);
      const after = (await seen()) as Point;
      expect(Math.hypot(after.x - place.x, after.y - place.y), "seen from where it was").toBeLessThan(1);
      await page.mouse.click(place.x, place.y);
      await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
    });
  }
});

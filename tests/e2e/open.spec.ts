import { zipSync } from "fflate";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { ktx2File, ktx2Model, softPicture } from "../support/ktx2-file.ts";
import { expect, test } from "./support/editor-page.ts";
import { readPng } from "./support/read-png.ts";
import { sharedFile, skipWithoutShared } from "./support/shared-files.ts";
import { boardPicture, demoFile, file, ringPicture, squareGlb, squareGltf } from "./support/test-files.ts";

test("opens on the mug with a decal that is selected and painted", async ({ editor, page }) => {
  await editor.open();
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
  const { layers } = await editor.design();
  expect(layers.length).toBeGreaterThan(0);
  expect(await editor.selectedName()).toBe(layers[0]?.name);
  const { projectionCount, bakeCount, updates } = await editor.stats();
  expect([projectionCount > 0, bakeCount, updates > 0]).toEqual([true, 1, true]);
  const painted = await editor.hash();
  await editor.removeAllDecals();
  expect(await editor.hash()).not.toBe(painted);
});

test("on a slow line the page says that it is coming, and what the first model needs comes side by side", async ({
  editor,
  page,
}) => {
  const held = async (address: RegExp): Promise<() => void> => {
    let letGo = (): void => {};
    const free = new Promise<void>((resolve) => {
      letGo = resolve;
    });
    await page.route(address, async (route) => {
      await free;
      await route.continue();
    });
    return letGo;
  };
  const letCodeGo = await held(/\/texture-view-.*\.js$/);
  const letModelGo = await held(/\/mug\.glb$/);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.goto("./", { waitUntil: "commit" });
  const coming = page.getByRole("status").filter({ hasText: /^Texelcast$/ });
  await expect(coming).toBeVisible();
  letCodeGo();
  await expect(page.locator("tc-notice-stack .task")).toContainText("Opening Mug");
  await expect(coming).toHaveCount(0);
  const has = (end: RegExp): boolean => asked.some((address) => end.test(address));
  await expect
    .poll(() => [/\/texelcast-.*\.wasm$/, /\/mark\.png$/, /\/smiley\.png$/].map(has))
    .toEqual([true, true, true]);
  letModelGo();
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
  await editor.idle();
});

test("when the page is idle, the flat view shows the texture", async ({ page }) => {
  await page.goto("./");
  await page.waitForFunction(() => "texelcast" in window);
  await page.evaluate(async () => {
    await window.texelcast.ready;
    await window.texelcast.idle();
  });
  const box = await page.locator(".tcv-texture canvas").boundingBox();
  if (!box) throw new Error("The page shows no texture.");
  // The mug's inner side, which is red, lies in the middle of its texture.
  const clip = { x: box.x + box.width / 2 - 8, y: box.y + box.height / 2 - 8, width: 16, height: 16 };
  const { rgba } = readPng(await page.screenshot({ clip }));
  expect((rgba[0] ?? 0) - (rgba[2] ?? 0)).toBeGreaterThan(60);
});

test("when the page is idle, both views have drawn what has changed, and draw it no more", async ({ editor, page }) => {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { drawArrays, drawElements } = prototype;
    const drawn = { flat: 0, model: 0 };
    const count = ({ canvas }: WebGL2RenderingContext): void => {
      const isFlat = canvas instanceof HTMLElement && canvas.closest(".tcv-texture") !== null;
      drawn[isFlat ? "flat" : "model"] += 1;
    };
    prototype.drawArrays = function (...given) {
      count(this);
      drawArrays.apply(this, given);
    };
    prototype.drawElements = function (...given) {
      count(this);
      drawElements.apply(this, given);
    };
    Object.assign(window, { drawn });
  });
  await editor.openOnLowest();
  /** How often each view had drawn when the page said that it is idle, and some frames later. */
  const nudge = (key: string) =>
    page.evaluate(async (pressed) => {
      const { drawn } = window as unknown as { drawn: { flat: number; model: number } };
      const before = { ...drawn };
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: pressed, bubbles: true, composed: true }));
      await window.texelcast.idle();
      const atIdle = { ...drawn };
      for (let frame = 0; frame < 5; frame += 1) await new Promise(requestAnimationFrame);
      return { flat: [atIdle.flat > before.flat, drawn.flat - atIdle.flat], model: atIdle.model > before.model };
    }, key);
  for (const key of ["ArrowLeft", "ArrowRight", "ArrowLeft"]) {
    expect(await nudge(key)).toEqual({ flat: [true, 0], model: true });
  }
});

test("asks the GPU for no setting once it draws: the page's thread would wait until it is done", async ({
  editor,
  page,
}) => {
  await page.addInitScript(() => {
    const drawing = new WeakSet<object>();
    const asked: string[] = [];
    Object.assign(window, { askedWhileDrawing: asked });
    const { getParameter, drawArrays, drawElements } = WebGL2RenderingContext.prototype;
    Object.assign(WebGL2RenderingContext.prototype, {
      getParameter(this: WebGL2RenderingContext, name: number) {
        if (drawing.has(this)) asked.push(`0x${name.toString(16)}`);
        return getParameter.call(this, name);
      },
      drawArrays(this: WebGL2RenderingContext, ...how: Parameters<typeof drawArrays>) {
        drawing.add(this);
        drawArrays.apply(this, how);
      },
      drawElements(this: WebGL2RenderingContext, ...how: Parameters<typeof drawElements>) {
        drawing.add(this);
        drawElements.apply(this, how);
      },
    });
  });
  await editor.open();
  const hash = await editor.hash();
  await editor.removeAllDecals();
  expect(await editor.hash()).not.toBe(hash);
  expect(await page.evaluate(() => Reflect.get(window, "askedWhileDrawing"))).toEqual([]);
});

test("offers all demo models, and each opens with its own design", async ({ editor, page }) => {
  await editor.open();
  for (const name of ["Avatar", "Skateboard"]) {
    await page.locator("tc-top-bar .models button").first().click();
    await page.getByRole("menuitemradio", { name }).click();
    await expect(page.locator("tc-top-bar .models")).toContainText(name);
    await editor.idle();
    expect((await editor.design()).layers.length).toBeGreaterThan(0);
  }
  await expect(editor.notices).toHaveCount(0);
});

test("undo brings back the model that another one replaced, with its design", async ({ editor, page }) => {
  await editor.open();
  const before = await editor.hash();
  await editor.openModel([squareGlb()]);
  await expect(page.locator("tc-top-bar .models")).toContainText("square.glb");
  expect((await editor.design()).layers).toEqual([]);
  await page.locator("#undo").click();
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
  expect(await editor.settledHash()).toBe(before);
  await page.locator("#redo").click();
  await expect(page.locator("tc-top-bar .models")).toContainText("square.glb");
});

test("opens a GLB that is dropped anywhere on the page", async ({ editor, page }) => {
  await editor.open();
  const panel = page.locator("tc-side-panel .lower");
  await panel.evaluate((element) => element.scrollTo(0, 200));
  await editor.drop([squareGlb()], { x: 1200, y: 700 });
  expect(await panel.evaluate((element) => element.scrollTop), "the panel begins at its top again").toBe(0);
  await expect(page.locator("tc-top-bar .models")).toContainText("square.glb");
  await expect(page.locator("tc-layer-list")).toContainText("None yet");
  expect(await editor.textureSize()).toEqual({ width: 1024, height: 1024 });
});

test("opens a .gltf together with its side files, dropped without their folder", async ({ editor }) => {
  await editor.open();
  await editor.drop(squareGltf(), { x: 300, y: 400 });
  expect(await editor.textureSize()).toEqual({ width: 64, height: 64 });
  const corner = await editor.texels({ x: 0, y: 0, width: 1, height: 1 });
  const rest = await editor.texels({ x: 63, y: 63, width: 1, height: 1 });
  expect([[...corner], [...rest]]).toEqual([
    [255, 255, 255, 255],
    [20, 120, 130, 255],
  ]);
  await expect(editor.notices).toHaveCount(0);
});

test("opens a model that is zipped with its side files, and names it after the archive", async ({ editor, page }) => {
  await editor.open();
  const [gltf, ...sides] = squareGltf();
  if (!gltf) throw new Error("There is no model.");
  const inside = [["scene.gltf", gltf.buffer] as const, ...sides.map(({ name, buffer }) => [name, buffer] as const)];
  const archive = file("red_board.zip", zipSync(Object.fromEntries(inside)));
  await editor.openModel([archive]);
  await expect(page.locator("tc-top-bar .models")).toContainText("red_board");
  expect(await editor.textureSize()).toEqual({ width: 64, height: 64 });
  await expect(editor.notices).toHaveCount(0);
  const before = await editor.settledHash();
  await editor.drop([file("cut.zip", archive.buffer.subarray(0, 200))], { x: 300, y: 400 });
  await expect(editor.notices).toHaveAttribute("data-code", "bad-archive");
  await expect(editor.notices).toContainText("cut.zip");
  await editor.drop([file("sources.zip", zipSync({ "board.fbx": new Uint8Array(9) }))], { x: 300, y: 400 });
  await expect(editor.notices.filter({ hasText: "There is no model, design or picture in sources.zip" })).toHaveCount(
    1,
  );
  expect(await editor.settledHash()).toBe(before);
});

test("a picture dropped on the model is placed where it was dropped", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const box = await editor.stage.boundingBox();
  if (!box) throw new Error("There is no 3D view.");
  const at = { x: box.x + box.width / 2 + 40, y: box.y + box.height / 2 + 30 };
  await editor.drop([ringPicture()], at);
  const { layers } = await editor.design();
  expect(layers.map(({ name }) => name)).toEqual(["ring"]);
  const centre = await editor.pointOf(layers[0]?.id ?? "");
  expect(Math.hypot(centre.x - at.x, centre.y - at.y)).toBeLessThan(3);
  await expect(page.locator("#announcer")).toContainText("ring added");
});

test("a picture dropped on the flat texture is placed there, and several lie side by side from where they were dropped", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const flat = await page.locator(".tcv-texture").boundingBox();
  if (!flat) throw new Error("There is no flat view.");
  const at = { x: flat.x + flat.width / 2 + 60, y: flat.y + flat.height / 2 - 50 };
  await editor.drop([ringPicture()], at);
  const middleOf = async (index: number): Promise<readonly number[]> => {
    const { layers } = await editor.design();
    const { projector } = await editor.decal(layers[index]?.id ?? "");
    return projector.kind === "planar" ? projector.position : [];
  };
  // The square is 1 across, and its texture lies upright on it.
  const side = Math.min(flat.width, flat.height);
  const [x = 0, y = 0] = await middleOf(0);
  expect(Math.sign(x), "right of the middle").toBe(1);
  expect(Math.sign(y), "above it").toBe(1);
  expect(x / y).toBeCloseTo(60 / 50, 1);
  expect(x).toBeGreaterThan(60 / side);

  await editor.drop([boardPicture(), ringPicture()], { x: at.x - 120, y: at.y + 100 });
  const [[first = 0, low = 0], [second = 0, lower = 0]] = [await middleOf(1), await middleOf(2)];
  expect(first).toBeCloseTo(-x, 2);
  expect(low).toBeCloseTo(-y, 2);
  expect(second).toBeGreaterThan(first + 0.01);
  expect(lower).toBeLessThan(low - 0.01);
});

test("pictures are added by the file dialog, one decal each", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.choose(() => page.locator("#add-picture").click(), [ringPicture(), boardPicture()]);
  expect((await editor.design()).layers.map(({ name }) => name)).toEqual(["ring", "board"]);
});

test("what was tried in vain stands no longer before what is open then", async ({ editor }) => {
  await editor.open();
  const at = await editor.middleOfStage();
  await editor.drop([file("broken.png", ringPicture().buffer.subarray(0, 60), "image/png")], at);
  await editor.drop([file("notes.txt", "hello")], at);
  await expect(editor.notices).toHaveCount(2);
  // One that brings nothing but another refusal leaves them.
  await editor.drop([ringPicture(), file("cut.png", ringPicture().buffer.subarray(0, 60), "image/png")], at);
  await expect(editor.notices).toHaveCount(3);
  await editor.drop([ringPicture()], at);
  await expect(editor.notices).toHaveCount(0);
});

test("says what is missing when a .gltf comes without its buffer, and keeps the work", async ({ editor }) => {
  await editor.open();
  const before = await editor.hash();
  const [gltf] = squareGltf();
  await editor.openModel(gltf ? [gltf] : []);
  await expect(editor.notices).toHaveAttribute("data-code", "missing-file");
  await expect(editor.notices).toContainText("square data.bin, textures/board.png");
  expect(await editor.settledHash()).toBe(before);
});

test("opens Fox.glb, a skinned model in centimetres", async ({ editor, page }) => {
  skipWithoutShared();
  await editor.open();
  await editor.openModel([sharedFile("Fox.glb")]);
  await expect(page.locator("tc-top-bar .models")).toContainText("Fox.glb");
  await expect(page.locator("tc-stage #play")).toBeVisible();
  const before = await editor.hash();
  await editor.addDemoDecal("flower");
  expect(await editor.settledHash()).not.toBe(before);
});

test("a file of another kind is refused by name", async ({ editor }) => {
  await editor.open();
  await editor.drop([file("notes.txt", "hello")], { x: 300, y: 400 });
  await expect(editor.notices).toHaveAttribute("data-code", "unsupported");
  await expect(editor.notices).toContainText("notes.txt");
});

test("two models at once are refused, and the demo's file opens by itself", async ({ editor, page }) => {
  await editor.open();
  await editor.drop([squareGlb(), demoFile("avatar.glb")], { x: 300, y: 400 });
  await expect(editor.notices).toContainText("one model at a time");
  await editor.drop([demoFile("avatar.glb")], { x: 300, y: 400 });
  await expect(page.locator("tc-top-bar .models")).toContainText("avatar.glb");
  await expect(editor.notices).toHaveCount(0);
});

test("a model whose textures are KTX2 alone is painted on the texels that Node reads", async ({ editor, page }) => {
  const bytes = ktx2Model(await ktx2File(softPicture(256, 128), "ETC1S"));
  await editor.open();
  await editor.openModel([{ name: "basis.glb", mimeType: "model/gltf-binary", buffer: Buffer.from(bytes) }]);
  const engine = createEngineHost();
  await engine.loadModel({ name: "basis.glb", bytes });
  await engine.openTarget({ material: 0 });
  expect(await page.evaluate(() => window.texelcast.engine.hash(0))).toBe(await engine.hash(0));
  engine.dispose();
});

test("what is dropped while the keys or the templates are shown is seen, and so is why it was not taken", async ({
  editor,
  page,
}) => {
  await editor.open();
  const middle = await editor.middleOfStage();
  const dialog = page.locator("tc-help-dialog dialog, tc-template-dialog dialog").filter({ visible: true });
  await page.locator("#help").click();
  await expect(dialog).toHaveCount(1);
  await editor.drop([file("letter.docx", "Dear Sirs")], middle);
  await expect(dialog).toHaveCount(0);
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();
  await expect(editor.notices).toHaveCount(0);

  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitem", { name: "New from template…" }).click();
  await expect(dialog).toHaveCount(1);
  await editor.drop([ringPicture()], middle);
  await expect(dialog).toHaveCount(0);
  await expect(editor.row("ring")).toBeVisible();
});

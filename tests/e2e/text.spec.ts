/** Words on the model: put there, typed, bent, saved, opened again, and rendered by the command line to the same bytes. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Locator } from "@playwright/test";
import type { TextLayer } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { rendered } from "./support/rendered.ts";
import { file, squareGlb } from "./support/test-files.ts";

const inCheckout = (name: string): string => fileURLToPath(new URL(`../../${name}`, import.meta.url));
const OWN_FONT = inCheckout("node_modules/@expo-google-fonts/lobster/400Regular/Lobster_400Regular.ttf");
const FLAG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 3 2"><path fill="#07c" d="M0 0h3v2H0"/></svg>';

async function textLayer(editor: EditorPage): Promise<TextLayer> {
  const layer = (await editor.design()).layers.at(-1);
  if (layer?.type !== "text") throw new Error("The topmost layer is not a text.");
  return layer;
}

async function middleOf(editor: EditorPage): Promise<Point> {
  const box = await editor.stage.boundingBox();
  if (!box) throw new Error("There is no stage.");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Opens the square model, with words on its middle; returns the field that they are typed into. */
async function openOnWords(editor: EditorPage): Promise<Locator> {
  await editor.open();
  await editor.openModel([squareGlb()]);
  return putWords(editor);
}

/** Puts words on the middle of the model with the text's tool; returns the field that they are typed into, which has the focus. */
async function putWords(editor: EditorPage): Promise<Locator> {
  const spot = await middleOf(editor);
  await editor.page.keyboard.press("t");
  await editor.page.mouse.click(spot.x, spot.y);
  const words = editor.page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  return words;
}

test("words are put on the model, typed, bent and outlined, stay editable, and Node renders the same bytes", async ({
  editor,
  page,
}) => {
  // A dozen renders, and one by the command line.
  test.slow();
  const fetched: string[] = [];
  page.on("request", (request) => fetched.push(request.url()));
  await editor.open();
  expect(
    fetched.filter((url) => /harfbuzz|resvg|\.ttf/i.test(url)),
    "fetched without a text",
  ).toEqual([]);
  const model = squareGlb();
  await editor.openModel([model]);
  const words = await putWords(editor);
  const first = await textLayer(editor);

  // Latin with a combining accent, Hebrew and Arabic; live while it is typed, one step when it is done.
  await page.keyboard.insertText("Cafe\u0301\nשלום");
  await expect.poll(async () => (await textLayer(editor)).text).toBe("Cafe\u0301\nשלום");
  const typed = await editor.settledHash();
  await words.blur();
  await expect(page.getByRole("button", { name: "Undo change text" })).toBeVisible();
  expect(await editor.settledHash()).toBe(typed);
  const grown = await textLayer(editor);
  const heights = [first, grown].map(({ projector }) => (projector.kind === "planar" ? projector.size[1] : 0));
  expect((heights[1] ?? 0) / (heights[0] ?? 1)).toBeCloseTo(2, 1);
  expect(grown.fontSize * (heights[1] ?? 0)).toBeCloseTo(first.fontSize * (heights[0] ?? 0), 9);

  await editor.setField("curve", "40");
  await page.locator("tc-text-fields #outline").check();
  await page.locator("tc-text-fields #font button").click();
  await page.getByRole("menuitemradio", { name: "Source Serif Bold" }).click();
  await expect.poll(async () => (await textLayer(editor)).font).toBe("source-serif-4-700");
  expect(await textLayer(editor)).toMatchObject({ curve: 40, outline: { width: 0.06 } });
  expect(Object.keys((await editor.design()).assets)).toEqual(["source-serif-4-700"]);
  const dressed = await editor.settledHash();
  expect(dressed).not.toBe(typed);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await textLayer(editor)).font).toBe("inter-700");
  await page.keyboard.press("Control+Shift+z");
  expect(await editor.settledHash()).toBe(dressed);

  // Opened again it is the same, and still words.
  const design = await editor.saveDesign();
  await editor.removeAllDecals();
  await editor.openDesign([file(design.name, design.bytes, "application/json")]);
  expect(await editor.settledHash()).toBe(dressed);
  await expect(words).toHaveValue("Cafe\u0301\nשלום");

  const png = await editor.exported("Texture as PNG");
  const picture = rendered({ name: "model.glb", bytes: model.buffer }, { name: "text.json", bytes: design.bytes });
  expect(picture.equals(png.bytes), "the command line's PNG is the page's").toBe(true);
});

test("a font of one's own and an SVG file are dropped on the model; what cannot be written or read is said", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const bare = await editor.settledHash();
  const spot = await middleOf(editor);
  await editor.drop([file("flag.svg", Buffer.from(FLAG), "image/svg+xml")], spot);
  const withFlag = await editor.settledHash();
  expect(withFlag).not.toBe(bare);
  const flag = (await editor.design()).layers.at(-1);
  if (flag?.type !== "decal" || flag.projector.kind !== "planar") throw new Error("The drawing is no decal.");
  expect(flag.projector.size[0] / flag.projector.size[1]).toBeCloseTo(1.5, 6);

  await editor.drop([file("Own.ttf", readFileSync(OWN_FONT), "font/ttf")], spot);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(2);
  const { font } = await textLayer(editor);
  expect((await editor.design()).assets[font]?.uri.slice(0, 22)).toBe("data:font/ttf;base64,A");
  expect(await editor.settledHash()).not.toBe(withFlag);
  await page.locator("tc-text-fields textarea").fill("字 漢");
  await expect(page.locator("tc-text-fields .note")).toContainText("字 漢");
  await expect(editor.notices).toContainText("字 漢, which no font here has");
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();

  await editor.drop([file("web.woff2", Buffer.from("wOF2".padEnd(99, ".")), "font/woff2")], spot);
  await expect(editor.notices).toContainText("web.woff2");
  await expect(editor.notices).toContainText("it is a web font (WOFF)");
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();
  await editor.drop(
    [file("broken.svg", Buffer.from("<svg xmlns='http://www.w3.org/2000/svg'><a"), "image/svg+xml")],
    spot,
  );
  await expect(editor.notices).toContainText("broken.svg");
  await expect(editor.notices).toContainText("not well-formed");
});

test("what is typed is a step after a moment's rest, and is in what is saved before that", async ({ editor, page }) => {
  await editor.open();
  await page.getByRole("button", { name: "Add text" }).click();
  const words = page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  const { text } = await textLayer(editor);
  await page.keyboard.insertText("Rest");
  await expect(page.getByRole("button", { name: "Undo change text" })).toBeVisible();
  await expect(words).toBeFocused();
  await page.keyboard.insertText("!");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
  const saved = JSON.parse(readFileSync(await download.path(), "utf8")) as { layers: TextLayer[] };
  expect(saved.layers.at(-1)?.text).toBe("Rest!");
  await expect(words).toBeFocused();
  await page.locator("#undo").click();
  await page.locator("#undo").click();
  expect((await textLayer(editor)).text).toBe(text);
});

test("what no font has is named when it is typed and when it is exported, and what is wider or higher than the model is told", async ({
  editor,
  page,
}) => {
  const words = await openOnWords(editor);
  await page.keyboard.insertText("Ada 字 漢 😀");
  await words.blur();
  await expect(editor.notices).toHaveCount(1);
  await expect(editor.notices).toContainText("Some characters cannot be drawn");
  await expect(editor.notices).toContainText("字 漢, which no font here has.");
  await words.fill("A text that goes on and on, far beyond both sides of the model");
  await words.blur();
  // What is mended is told no more.
  await expect(editor.notices).toHaveCount(1);
  await expect(editor.notices).toContainText("The text is larger than the model");
  await editor.notices.getByRole("button", { name: "Make it fit" }).click();
  const { projector } = await textLayer(editor);
  expect(projector.kind === "planar" && projector.size[0]).toBeCloseTo(0.6, 6);
  await page.keyboard.press("Control+z");
  await expect(page.locator("#redo")).toBeEnabled();
  await words.fill("lines");
  await words.blur();
  // Recorded: there is nothing to redo any more.
  await expect(page.locator("#redo")).toBeDisabled();
  await expect(editor.notices).toHaveCount(0);
  await words.fill(Array.from({ length: 12 }, () => "lines").join("\n"));
  await words.blur();
  await expect(editor.notices).toContainText("The text is larger than the model");
  await editor.notices.getByRole("button", { name: "Make it fit" }).click();
  const high = (await textLayer(editor)).projector;
  expect(high.kind === "planar" && high.size[1]).toBeCloseTo(0.6, 6);
  await words.fill("漢");
  await words.blur();
  await expect(editor.notices).toContainText("漢, which no font here has.");
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();
  await editor.exported("Texture as PNG");
  await expect(editor.notices).toContainText("漢, which no font here has.");
});

test("words that run past the side of the model are told, on a mug too, and made to fit at once; what fits is not", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.removeAllDecals();
  await page.getByRole("button", { name: "Add text" }).click();
  const words = page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  await words.fill("ACME");
  await words.blur();
  await editor.idle();
  await expect(editor.notices).toHaveCount(0);
  await words.fill("ACME Coffee");
  await words.blur();
  await expect(editor.notices).toContainText("The text runs past the edge of the model");
  const before = await textLayer(editor);
  await editor.notices.getByRole("button", { name: "Make it fit" }).click();
  await editor.idle();
  await expect(editor.notices).toHaveCount(0);
  const { projector } = await textLayer(editor);
  if (projector.kind !== "planar" || before.projector.kind !== "planar") throw new Error("It is thrown from a box.");
  // The mug is 82 mm across, and what faces away at its side is not painted.
  expect(projector.size[0]).toBeLessThan(0.078);
  expect(projector.size[0]).toBeGreaterThan(0.05);
  expect(projector.position).toEqual(before.projector.position);
  await page.keyboard.press("Control+z");
  expect(await textLayer(editor)).toEqual(before);
  // One that already did so is not told again.
  await words.fill("ACME Coffee!");
  await words.blur();
  await editor.idle();
  await expect(editor.notices).toHaveCount(0);
});

test("a text is called by its words, each by other ones, until somebody calls it otherwise; undo takes that back", async ({
  editor,
  page,
}) => {
  const words = await openOnWords(editor);
  const called = (name: string): Promise<void> => expect.poll(async () => (await textLayer(editor)).name).toBe(name);
  await called("Text");
  await words.fill("\n  Happy birthday\nGrandma ");
  await called("Happy birthday");
  await words.blur();
  await page.locator("#undo").click();
  await called("Text");
  await page.locator("#redo").click();
  await called("Happy birthday");

  await page.locator("#add-text").click();
  await expect(words).toBeFocused();
  await called("Text");
  await words.fill("Happy birthday");
  await called("Happy birthday 2");
  await words.fill("");
  await called("Text");
  await words.fill("مرحبا بالعالم");
  await called("مرحبا بالعالم");
  await words.blur();
  // What does not fit is left out at its end, which is at the left, and is read by the pointer.
  const name = editor.row("مرحبا بالعالم").locator(".name");
  await expect(name).toHaveCSS("direction", "rtl");
  await expect(name).toHaveAttribute("title", "مرحبا بالعالم");

  await page.locator("tc-layer-properties #name").fill("Motto");
  await page.locator("tc-layer-properties #name").blur();
  await words.fill("Grace");
  await expect.poll(async () => (await textLayer(editor)).text).toBe("Grace");
  await called("Motto");
});

test("what was typed in the moment before the page is loaded again is there afterwards", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const asked: string[] = [];
  page.on("dialog", (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  const words = page.locator("tc-text-fields textarea");
  const type = async (text: string): Promise<void> => {
    await words.fill(text);
    await expect.poll(async () => (await textLayer(editor)).text).toBe(text);
  };
  const spot = await middleOf(editor);
  await page.keyboard.press("t");
  await page.mouse.click(spot.x, spot.y);
  await expect(words).toBeFocused();
  await editor.idle();
  await type("Ada");
  await editor.reload();
  expect(asked).toEqual([]);
  expect((await textLayer(editor)).text).toBe("Ada");

  await page.locator("tc-layer-list .row").first().click();
  await type("Grace");
  // All that phones' browsers tell of the page's end.
  const noted = await page.evaluate(() => {
    dispatchEvent(new PageTransitionEvent("pagehide"));
    return Object.values(localStorage).join();
  });
  expect(noted).toContain("Grace");
});

test("what was typed in the moment before a phone hides the page is noted, and is typed on where it was left", async ({
  editor,
  page,
}) => {
  const words = await openOnWords(editor);
  await editor.idle();
  await page.evaluate(() => window.texelcast.kept());
  const hide = (): Promise<string> =>
    page.evaluate(() => {
      Object.defineProperty(document, "visibilityState", { value: "hidden", configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
      Reflect.deleteProperty(document, "visibilityState");
      return Object.values(localStorage).join();
    });
  await words.fill("Grace");
  expect(await hide()).toContain("Grace");
  await expect(words).toBeFocused();
  await page.keyboard.type(" H");
  await expect.poll(async () => (await textLayer(editor)).text).toBe("Grace H");

  // A number that is not left yet, too.
  const curve = page.locator('tc-number[data-field="curve"] input');
  await curve.fill("77");
  expect(await hide()).toContain('"curve":77');
});

test("above a phone's keyboard the words that are typed and the model are both in sight", async ({ editor, page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  const words = await openOnWords(editor);
  expect(await page.locator("meta[name=viewport]").getAttribute("content")).toContain(
    "interactive-widget=resizes-content",
  );
  // What such a page is left by the keyboard.
  await page.setViewportSize({ width: 390, height: 508 });
  await expect(words).toBeFocused();
  await expect(words).toBeInViewport({ ratio: 1 });
  const { height } = (await editor.view.boundingBox()) ?? { height: 0 };
  expect(height, "pixels of the model's view").toBeGreaterThan(80);
});

test("what is told of words while they are typed on a phone leaves them in sight, and is told in full after that", async ({
  editor,
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await editor.open();
  const words = await putWords(editor);
  await page.setViewportSize({ width: 390, height: 508 });
  await page.keyboard.type("A very long text that runs round and past");
  await expect(editor.notices).toContainText("larger than the model");
  const boxOf = async (of: Locator) => (await of.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  const typed = await boxOf(words);
  await expect(words).toBeInViewport({ ratio: 1 });
  const { y, height } = await boxOf(editor.notices);
  expect(y + height, "the notice stands above the words").toBeLessThanOrEqual(typed.y);
  expect(y, "of the model's view a half stays free").toBeGreaterThan((await boxOf(editor.view)).height / 2);
  const explained = editor.notices.getByText("What reaches beyond it is not painted");
  expect((await boxOf(explained)).height, "pixels of what explains it").toBeLessThan(5);

  // The field is left for the notice's own button: it stays where it is pressed.
  await editor.notices.getByRole("button", { name: "Make it fit" }).focus();
  expect((await boxOf(editor.notices)).y).toBe(y);
  await words.focus();
  await words.blur();
  await expect.poll(async () => (await boxOf(explained)).height).toBeGreaterThan(20);
  expect((await boxOf(editor.notices)).y, "it lies over the sheet").toBeGreaterThan(y);
});

test("words that the engine has not measured when the page is left are there afterwards, in a box that fits them", async ({
  editor,
  page,
}) => {
  const words = await openOnWords(editor);
  await editor.idle();
  await page.evaluate(() => window.texelcast.kept());
  const before = await textLayer(editor);
  await page.evaluate(() => {
    window.texelcast.engine.measureText = () => new Promise(() => {});
  });
  await words.fill("Far more words than before");
  await editor.reload();
  await expect.poll(async () => (await textLayer(editor)).text).toBe("Far more words than before");
  const wide = ({ projector }: TextLayer): number => (projector.kind === "planar" ? projector.size[0] : 0);
  expect(wide(await textLayer(editor))).toBeGreaterThan(2 * wide(before));
  await page.getByRole("button", { name: "Undo change text" }).click();
  expect(await textLayer(editor)).toEqual(before);
});

test("in the list of layers a text's letters are those of its font, also when that is another", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const words = await putWords(editor);
  await page.keyboard.insertText("Tex");
  await words.blur();
  const letters = page.locator("tc-layer-list .thumbnail.words");
  await expect(letters).toHaveText("Tex");
  /** The family that they are written in, once it is there. */
  const family = () =>
    letters.evaluate((element) => {
      const plain = (name: string): string => name.replaceAll('"', "");
      const first = plain(getComputedStyle(element).fontFamily.split(",")[0] ?? "");
      const isLoaded = [...document.fonts].some((face) => plain(face.family) === first && face.status === "loaded");
      return isLoaded ? first : "";
    });
  await expect.poll(family).toBe("texelcast-inter-700");
  await page.locator("tc-text-fields #font button").click();
  await page.getByRole("menuitemradio", { name: "Lobster" }).click();
  await expect.poll(async () => (await textLayer(editor)).font).toBe("lobster-400");
  await expect.poll(family).toBe("texelcast-lobster-400");
  await page.keyboard.press("Control+z");
  await expect.poll(family).toBe("texelcast-inter-700");
});

test("what is typed before a new text has its font chooses no tool and deletes nothing", async ({ editor, page }) => {
  let deliver = (): void => {};
  const delivered = new Promise<void>((resolve) => {
    deliver = resolve;
  });
  await page.context().route(/\.ttf$/, async (route) => {
    await delivered;
    await route.continue();
  });
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  const before = await editor.design();
  await page.getByRole("button", { name: "Add text" }).first().click();
  await page.keyboard.press("b");
  await page.keyboard.press("e");
  await page.keyboard.press("Backspace");
  expect(await editor.design()).toEqual(before);
  await expect(page.getByRole("radio", { name: "Move" })).toBeChecked();
  deliver();
  const words = page.getByRole("textbox", { name: "Words" });
  await expect(words).toBeFocused();
  await page.keyboard.type("be");
  await expect.poll(async () => (await textLayer(editor)).text).toBe("be");
  await words.blur();
  await page.keyboard.press("b");
  await expect(page.getByRole("radio", { name: "Brush" })).toBeChecked();
});

test("a text without words says that nothing of it is seen, until it has some", async ({ editor }) => {
  const words = await openOnWords(editor);
  const note = editor.page.locator("tc-text-fields .note");
  await expect(note).toHaveCount(0);
  await words.fill(" ");
  await expect(note).toHaveText("Without words nothing of it is seen.");
  await words.fill("Hello");
  await expect(note).toHaveCount(0);
});

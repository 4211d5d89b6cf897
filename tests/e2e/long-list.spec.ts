import { makeDecalLayer } from "../../web/editor/document/index.ts";
import { paintPng } from "../support/png-file.ts";
import { expect, test } from "./support/editor-page.ts";
import { file, squareGlb } from "./support/test-files.ts";

const COUNT = 400;

/** Small stamps in the texture, a row of twenty above the other. */
function manyDecals(): string {
  const uri = `data:image/png;base64,${Buffer.from(paintPng(4, 4, () => [200, 40, 60, 255])).toString("base64")}`;
  const layers = Array.from({ length: COUNT }, (_, k) =>
    makeDecalLayer({
      id: `d${k}`,
      name: `Decal ${k}`,
      asset: "dot",
      projector: {
        kind: "uv",
        center: [((k % 20) + 0.5) / 20, (Math.floor(k / 20) + 0.5) / 20],
        size: [0.03, 0.03],
        angle: 0,
      },
    }),
  );
  const assets = { dot: { type: "image/png", uri } };
  return JSON.stringify({ format: "texelcast-design", version: 1, assets, layers });
}

test("of hundreds of layers few have rows in the page, and none is out of the keyboard's or the pointer's reach", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.openDesign([file("many.design.json", manyDecals(), "application/json")]);
  const rows = page.locator("tc-layer-list .row");
  const list = page.locator("tc-layer-list .rows");
  const top = editor.row(`Decal ${COUNT - 1}`);
  const bottom = editor.row("Decal 0");
  const few = async (): Promise<void> => expect(await rows.count()).toBeLessThan(80);
  await top.click();
  await few();
  await expect(list).toHaveAttribute("aria-rowcount", String(COUNT));

  await page.keyboard.press("End");
  await expect(bottom).toBeFocused();
  await expect(bottom).toBeInViewport();
  await expect(bottom).toHaveAttribute("aria-posinset", String(COUNT));
  await expect(bottom).toHaveAttribute("aria-rowindex", String(COUNT));
  await expect(editor.row("Decal 3")).toBeInViewport();
  await few();
  // Scrolled away, the row that the keyboard is on stays; the next key goes on from it.
  await list.evaluate((element) => element.scrollTo(0, 5000));
  await expect.poll(async () => (await rows.first().getAttribute("data-id")) ?? "").not.toMatch(/^d\d{1,2}$/);
  await expect(bottom).toBeFocused();
  await page.keyboard.press("ArrowUp");
  await expect(editor.row("Decal 1")).toBeFocused();
  await expect(editor.row("Decal 1")).toBeInViewport();

  await page.keyboard.press("Shift+Home");
  await expect(top).toBeInViewport();
  await page.keyboard.press(" ");
  expect((await editor.design()).layers.filter(({ visible }) => visible).map(({ id }) => id)).toEqual(["d0"]);
  await few();

  await editor.select("d200");
  const chosen = editor.row("Decal 200");
  await expect(chosen).toBeInViewport();
  await expect(chosen).toHaveAttribute("tabindex", "0");
  await chosen.focus();
  await page.keyboard.press("F2");
  await page.keyboard.type("Crest");
  await page.keyboard.press("Enter");
  const crest = editor.row("Crest");
  await expect(crest).toBeFocused();

  // Held below the list it scrolls on by itself, past rows that were not there when the drag began.
  const from = await crest.boundingBox();
  const area = await list.boundingBox();
  if (!from || !area) throw new Error("The list has no place.");
  const last = await rows.last().getAttribute("data-id");
  const x = from.x + 70;
  await page.mouse.move(x, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move(x, area.y + area.height / 2);
  await page.mouse.move(x, area.y + area.height + 40);
  await expect(page.locator(`tc-layer-list .row[data-id=${last}]`)).toHaveCount(1);
  const past = Number(last?.slice(1)) - 20;
  await expect(page.locator(`tc-layer-list .row[data-id=d${past}]`)).toHaveCount(1);
  await page.mouse.move(x, area.y + area.height / 2);
  await expect(page.locator("tc-layer-list .line")).toBeInViewport();
  await page.mouse.up();
  const ids = (await editor.design()).layers.map(({ id }) => id);
  expect(ids.indexOf("d200")).toBeLessThan(Number(last?.slice(1)));
  expect(ids).toHaveLength(COUNT);
  await expect(crest).toBeFocused();
  await few();
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("the chosen row of a long list stays in sight when the phone is turned or another panel was open, and stays away where it was scrolled away", async ({
    editor,
    page,
  }) => {
    await editor.open();
    await editor.drop([file("many.design.json", manyDecals(), "application/json")], { x: 190, y: 200 });
    await expect(editor.row(`Decal ${COUNT - 1}`)).toBeInViewport();
    const chosen = editor.row("Decal 200");
    await editor.select("d200");
    await expect(chosen).toBeInViewport({ ratio: 0.9 });
    await editor.resize(844, 390);
    await expect(chosen).toBeInViewport({ ratio: 0.9 });
    await editor.resize(390, 844);
    const tabs = page.locator("tc-bottom-sheet nav button");
    await tabs.nth(1).tap();
    await expect(chosen).toHaveCount(0);
    await tabs.nth(0).tap();
    await expect(chosen).toBeInViewport({ ratio: 0.9 });
    await editor.resize(390, 600);
    await expect(chosen).toBeInViewport({ ratio: 0.9 });

    await page.locator("tc-layer-list .rows").evaluate((list) => list.scrollBy(0, 3000));
    await expect(chosen).not.toBeInViewport();
    await editor.resize(390, 844);
    await expect(editor.row("Decal 131")).toBeInViewport();
    await expect(chosen).not.toBeInViewport();
  });
});

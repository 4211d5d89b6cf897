import { expect, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

test("layers are grouped, renamed, dragged into and out of a group, masked and locked, and the history goes anywhere", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const id of ["badge", "number", "flower"]) await editor.addDemoDecal(id);
  const start = await editor.settledHash();
  const shape = async (): Promise<string> => {
    const names = (layers: Awaited<ReturnType<typeof editor.design>>["layers"]): string =>
      layers.map((layer) => (layer.type === "group" ? `${layer.name}(${names(layer.layers)})` : layer.name)).join(", ");
    return names((await editor.design()).layers);
  };

  await editor.row("Number 07").click();
  await editor.row("Flower").click({ modifiers: ["Shift"] });
  await page.keyboard.press("Control+g");
  expect(await shape()).toBe("Travel badge, Group(Number 07, Flower)");
  expect(await editor.settledHash(), "a group paints as its layers do").toBe(start);

  await editor.row("Group").focus();
  await page.keyboard.press("F2");
  await page.keyboard.type("Crest");
  await page.keyboard.press("Enter");
  expect(await shape()).toBe("Travel badge, Crest(Number 07, Flower)");
  await expect(editor.row("Crest")).toBeFocused();

  const drag = async (name: string, onto: string, share: number): Promise<void> => {
    const from = await editor.row(name).boundingBox();
    const to = await editor.row(onto).boundingBox();
    if (!from || !to) throw new Error("A row has no place.");
    const x = from.x + 70;
    await editor.drag({ x, y: from.y + from.height / 2 }, { x, y: to.y + to.height * share }, 6);
  };
  await drag("Travel badge", "Crest", 0.5);
  expect(await shape()).toBe("Crest(Number 07, Flower, Travel badge)");
  await drag("Flower", "Crest", 0.1);
  expect(await shape()).toBe("Crest(Number 07, Travel badge), Flower");
  await editor.row("Flower").focus();
  await page.keyboard.press("Alt+ArrowDown");
  expect(await shape(), "Alt and the arrows go into a group").toBe("Crest(Number 07, Travel badge, Flower)");

  await editor.row("Crest").focus();
  await page.keyboard.press("ArrowLeft");
  await expect(editor.row("Flower")).toHaveCount(0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press(" ");
  const hidden = await editor.settledHash();
  expect(hidden, "a hidden group hides its layers").not.toBe(start);
  await page.keyboard.press(" ");

  await editor.row("Crest").click();
  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that hides all" }).click();
  await expect.poll(() => editor.settledHash(), "a mask hides what it hides").toBe(hidden);
  await expect(editor.row("Crest").locator("[data-action=mask]")).toHaveAttribute("aria-pressed", "true");

  await editor.row("Flower").click();
  await editor.row("Flower").locator("[data-action=locked]").click();
  await page.keyboard.press("Delete");
  await expect(editor.notices).toContainText("Flower is locked");
  await expect(editor.row("Flower")).toHaveCount(1);

  await page.getByRole("tab", { name: "History" }).click();
  const steps = page.locator("tc-history-panel [role=option]");
  await expect(page.locator("tc-history-panel [aria-selected=true]")).toHaveText("Lock layer");
  await steps.filter({ hasText: "Group layers" }).click();
  expect(await shape()).toBe("Travel badge, Group(Number 07, Flower)");
  expect(await editor.settledHash()).toBe(start);
  await page.locator("tc-history-panel .list").press("End");
  expect(await shape()).toBe("Crest(Number 07, Travel badge, Flower)");
  expect(await editor.settledHash()).toBe(hidden);
});

/** What a screen reader says while one works, and where the keyboard is after each act. */
import type { Locator, Page } from "@playwright/test";
import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { file } from "./support/test-files.ts";

const announcer = ({ page }: EditorPage): Locator => page.locator("#announcer");

async function pressOn(button: Locator): Promise<void> {
  await button.focus();
  await button.press("Enter");
}

test("a button whose press leaves it nothing more to do keeps the keyboard", async ({ editor, page }) => {
  await editor.openOnLowest();
  await pressOn(editor.action("duplicate"));
  const undo = page.locator("#undo");
  await pressOn(undo);
  await expect(undo).toBeDisabled();
  await expect(undo).toBeFocused();
  const redo = page.locator("#redo");
  await pressOn(redo);
  await expect(redo).toBeDisabled();
  await expect(redo).toBeFocused();
  await redo.press("Enter");
  expect((await editor.design()).layers).toHaveLength(3);

  await pressOn(page.locator("tc-parts-list li button").first());
  const showAll = page.locator("#show-all-parts");
  await pressOn(showAll);
  await expect(showAll).toBeDisabled();
  await expect(showAll).toBeFocused();

  await pressOn(page.locator("#view-menu"));
  const reset = page.locator("#reset-view");
  await expect(reset).toBeDisabled();
  await page.locator("#light-turn").press("ArrowRight");
  await pressOn(reset);
  await expect(reset).toBeDisabled();
  await expect(reset).toBeFocused();
  await reset.press("Escape");
  await expect(page.locator("#view-menu"), "the panel's own Escape").toBeFocused();
});

test("where the system forces its colours, a button that can do nothing has the colour for that", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.emulateMedia({ forcedColors: "active" });
  const colorOf = (selector: string): Promise<string> =>
    page.locator(selector).evaluate((button) => getComputedStyle(button).color);
  const gray = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement("span"));
    probe.style.color = "GrayText";
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  });
  expect(await colorOf("#help")).not.toBe(gray);
  expect(await colorOf("#undo")).toBe(gray);
  expect(await colorOf("#show-all-parts")).toBe(gray);
});

test("the keyboard goes on beside what a press has taken away", async ({ editor, page }) => {
  await editor.openOnLowest();
  for (const name of ["one.glb", "two.glb"]) {
    await editor.drop([file(name, "this is no model")], await editor.middleOfStage());
  }
  await expect(editor.notices).toHaveCount(2);
  const dismiss = page.locator("tc-notice-stack .dismiss");
  await pressOn(dismiss.first());
  await expect(editor.notices).toHaveCount(1);
  await expect(dismiss).toBeFocused();
  await dismiss.press("Enter");
  await expect(editor.notices).toHaveCount(0);
  await expect(editor.view, "with the last notice, back to the work").toBeFocused();

  await page.locator("tc-layer-list .row[tabindex='0']").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Delete");
  await expect(page.locator("tc-layer-list .row")).toHaveCount(0);
  await expect(page.locator("tc-layer-list .add button")).toBeFocused();
});

test("a key that takes away what had the keyboard leaves it in the view", async ({ editor, page }) => {
  await editor.openOnLowest();
  const flat = page.locator(".tcv-texture");
  await page.locator("tc-layer-properties #flipX").focus();
  await page.keyboard.press("Escape");
  await expect(page.locator("tc-layer-properties #flipX")).toHaveCount(0);
  await expect(editor.view, "the panel has no layer any more").toBeFocused();

  await page.keyboard.press("Alt+3");
  await expect(flat, "the model is not shown any more").toBeFocused();
  await page.keyboard.press("Alt+1");
  await expect(editor.view).toBeFocused();
});

test("a window that becomes another leaves the keyboard on the page", async ({ editor, page }) => {
  await editor.openOnLowest();
  await page.locator("tc-layer-properties #flipX").focus();
  await editor.resize(390, 844);
  await expect(page.locator("tc-layer-properties #flipX"), "the panel is one of the sheet's").toHaveCount(0);
  await expect(editor.view).toBeFocused();

  await page.locator("#sheet-properties").click();
  await page.locator("tc-layer-properties #flipX").focus();
  await editor.resize(1280, 800);
  await expect(editor.view, "the sheet has gone").toBeFocused();

  // What is still there keeps it.
  await page.locator("#help").focus();
  await editor.resize(390, 844);
  await expect(page.locator("#help")).toBeFocused();
});

test("a menu of a row's gives the keyboard back to the row", async ({ editor, page }) => {
  await editor.openOnLowest();
  const row = page.locator("tc-layer-list .row[aria-current=true]");
  await row.focus();
  await page.keyboard.press("ContextMenu");
  await expect(page.getByRole("menuitem", { name: "Rename" })).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(row).toBeFocused();

  // Its button's own goes back to the button, also after that.
  const more = page.locator("tc-layer-list .more button").first();
  await pressOn(more);
  await page.keyboard.press("Escape");
  await expect(more).toBeFocused();
});

test("a menu keeps the keyboard when what had it there can do nothing any more, and Escape closes it", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const more = page.locator("tc-layer-list .more button").first();
  await pressOn(more);
  const rename = page.getByRole("menuitem", { name: "Rename" });
  await expect(rename).toBeFocused();
  // As a model does that opens meanwhile, whose layers are others.
  await page.evaluate(() => window.texelcast.select(null));
  await expect(rename).toBeDisabled();
  await expect(page.getByRole("menuitem", { name: "Select all" })).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(rename).toHaveCount(0);
  await expect(more).toBeFocused();

  // Nothing at all can be done with no layers.
  await editor.removeAllDecals();
  await pressOn(more);
  await expect(page.locator("tc-layer-list [role=menu]:focus")).toHaveAttribute("aria-label", /./);
  await page.keyboard.press("Escape");
  await expect(rename).toHaveCount(0);
  await expect(more).toBeFocused();
});

test("the list of projects says what is done in it, and keeps the keyboard, while it covers the page", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  await editor.action("duplicate").click();
  await expect(page.locator("#keeping")).toBeVisible();
  await page.locator("tc-top-bar .projects button").first().click();
  await page.getByRole("menuitem").first().click();
  // What lies behind a modal dialog is not there for a screen reader.
  const said = page.locator("tc-projects-dialog dialog [aria-live=polite]");
  await pressOn(page.locator("tc-projects-dialog [data-action=duplicate]").first());
  await expect(said).toHaveText("Mug duplicated");
  await pressOn(page.locator("tc-projects-dialog [data-action=delete]").first());
  await expect(said).toHaveText("Mug (copy) deleted");
  const restore = page.locator("tc-projects-dialog [data-action=restore]");
  await expect(restore).toBeFocused();
  await restore.press("Enter");
  await expect(said).toHaveText("Mug (copy) is back");
  await expect(page.locator("tc-projects-dialog .open").first()).toBeFocused();
});

async function openAvatar(editor: EditorPage): Promise<void> {
  const { page } = editor;
  await editor.open();
  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitemradio", { name: "Avatar" }).click();
  await expect(page.locator("tc-stage #play")).toBeVisible();
  await editor.idle();
}

test("the bar of a model that moves and the button in its place hand the keyboard to each other", async ({
  editor,
  page,
}) => {
  await openAvatar(editor);
  const [bar, still] = [page.locator("tc-animation-bar #play"), page.locator("tc-stage .tools #play")];
  await pressOn(still);
  await expect(bar).toBeFocused();
  await bar.press("Enter");
  await expect(bar, "that pauses").toBeFocused();
  await pressOn(page.locator("tc-animation-bar #rest"));
  await expect(still).toBeFocused();

  const eyes = page.locator("tc-parts-list li:not(.off) .eye");
  while ((await eyes.count()) > 0) await eyes.first().click();
  await pressOn(page.locator("tc-stage .empty button"));
  await expect(editor.view).toBeFocused();
});

test("a number beside a slider is not announced, which says it itself", async ({ editor, page }) => {
  await openAvatar(editor);
  await page.locator("tc-stage .tools #play").click();
  await page.locator("#view-menu").click();
  await expect(page.locator("#light-turn")).toBeVisible();
  const outputs = page.locator("output");
  await expect(outputs, "two of the light's, one of the animation's").toHaveCount(3);
  for (const output of await outputs.all()) await expect(output).toHaveAttribute("aria-live", "off");
});

test("the text tool puts words on the model by the keyboard alone", async ({ editor, page }) => {
  await editor.open();
  await editor.view.focus();
  await page.keyboard.press("t");
  // Where there is no cursor yet, Enter does nothing that was not seen coming.
  await page.keyboard.press("Enter");
  await expect(announcer(editor)).toHaveText(/^Cursor in the middle of the view/);
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await expect(page.locator("tc-text-fields textarea")).toBeFocused();
  await page.keyboard.type("Hello");
  await editor.idle();
  expect((await editor.design()).layers.at(-1)).toMatchObject({ type: "text", text: "Hello" });
  await expect(page.locator("#tool-move")).toHaveAttribute("aria-checked", "true");
});

test("what keys do to a decal on the model is said once they rest", async ({ editor, page }) => {
  await editor.openOnLowest();
  await editor.view.focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowUp");
  const numbers = (...names: string[]): Promise<string[]> =>
    Promise.all(names.map(async (name) => Number(await editor.field(name).inputValue()).toFixed(2)));
  await expect(announcer(editor)).toHaveText(/^Position/);
  const [x, y, z] = await numbers("position-x", "position-y", "position-z");
  await expect(announcer(editor)).toHaveText(`Position X ${x}, Y ${y}, Z ${z} mm`);
  await page.keyboard.press("]");
  await expect(announcer(editor)).toHaveText("Spin -1.0°");
  await page.keyboard.press("+");
  await expect(announcer(editor)).toHaveText(/^Size/);
  const [width, height] = await numbers("size-width", "size-height");
  await expect(announcer(editor)).toHaveText(`Size ${width} × ${height} mm`);
});

test("what is written short is heard whole", async ({ editor, page }) => {
  await page.addInitScript(() => localStorage.setItem("texelcast-language", "de"));
  await editor.openOnLowest();
  for (const name of ["Kurs, °", "Neigung, °", "Drehung, °"]) {
    await expect(page.getByRole("spinbutton", { name, exact: true })).toBeVisible();
  }
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("tools that lie in a row are said to", async ({ editor, page }) => {
    await editor.open();
    await expect(page.locator("tc-tool-rail [role=radiogroup]")).toHaveAttribute("aria-orientation", "horizontal");
  });
});

/** The field of a layer's opacity in which a number was typed that is above the most. */
async function refusedOpacity(editor: EditorPage): Promise<{ opacity: Locator; input: Locator }> {
  await editor.openOnLowest();
  const opacity = editor.page.locator("tc-layer-properties [data-field=opacity]");
  const input = opacity.locator("input[role=spinbutton]");
  await input.fill("250");
  await input.press("Enter");
  return { opacity, input };
}

test("a number that is not taken is said with what may be typed, and stays marked while that is heard", async ({
  editor,
}) => {
  const { opacity, input } = await refusedOpacity(editor);
  await expect(announcer(editor)).toHaveText("Opacity: from 0 % to 100 %");
  await expect(opacity).toHaveAttribute("refused");
  await expect(input).toHaveAttribute("aria-invalid", "true");
});

test("beneath the number that is not taken stands what may be typed, until a number is taken", async ({ editor }) => {
  const { opacity, input } = await refusedOpacity(editor);
  const why = opacity.locator(".why");
  await expect(why).toHaveText("from 0 % to 100 %");
  const [field, told] = [await opacity.boundingBox(), await why.boundingBox()];
  if (!field || !told) throw new Error("One of them is not shown.");
  expect(Math.min(Math.abs(told.y - field.y - field.height), Math.abs(field.y - told.y - told.height))).toBeLessThan(8);
  await input.fill("100/4");
  await input.press("Enter");
  await expect(why).toHaveCount(0);
  await expect(opacity).not.toHaveAttribute("refused");
  await expect(input).toHaveAttribute("aria-invalid", "false");
  await expect(input).toHaveValue("25");
});

test("of what is no number is told what one is, and no bound that nobody comes to", async ({ editor, page }) => {
  await editor.openOnLowest();
  const saidOf = async (field: string, typed: string): Promise<string> => {
    await editor.setField(field, typed);
    return page.locator(`tc-layer-properties [data-field=${field}] .why`).innerText();
  };
  expect(await saidOf("position-x", "left")).toBe("a number");
  await expect(announcer(editor)).toHaveText("Position X: a number");
  expect(await saidOf("yaw", "left")).toBe("a number");
  expect(await saidOf("size-width", "wide")).toBe("0.01 mm at least");
  expect(await saidOf("tilt", "up")).toBe("from -90 ° to 90 °");
});

test("what may be typed is told within the window, and goes with the field's place and use", async ({
  editor,
  page,
}) => {
  const { opacity } = await refusedOpacity(editor);
  const why = page.locator("tc-number .why");
  await expect(why).toHaveCount(1);
  await editor.resize(1100, 700);
  // At once: after some seconds it goes by itself.
  expect(await why.count(), "the field is elsewhere now").toBe(0);

  const last = page.locator("tc-layer-properties [data-field=position-z]");
  await last.locator("input[role=spinbutton]").fill("1e99");
  await last.locator("input[role=spinbutton]").press("Enter");
  await expect(why).toHaveCount(1);
  const told = await why.boundingBox();
  expect(told && told.x + told.width).toBeLessThanOrEqual(1100);

  const rowOpacity = page.locator("tc-layer-list tc-number");
  await rowOpacity.locator("input[role=spinbutton]").fill("250");
  await rowOpacity.locator("input[role=spinbutton]").press("Enter");
  await expect(rowOpacity).toHaveAttribute("refused");
  await page.evaluate(() => window.texelcast.select(null));
  await expect(opacity).toHaveCount(0);
  expect(await rowOpacity.getAttribute("refused"), "no layer is chosen that could have an opacity").toBeNull();
});

test("what may be typed is not told where its field is out of sight", async ({ editor, page }) => {
  await editor.openOnLowest();
  const width = page.locator("tc-layer-properties [data-field=size-width]");
  await width.locator("input[role=spinbutton]").fill("-7");
  // Taken by a press elsewhere, which leads far down the panel.
  await page.evaluate(() => {
    const find = (root: ParentNode): Element | null => {
      for (const one of root.querySelectorAll("*")) {
        if (one.localName === "tc-layer-properties")
          return one.shadowRoot?.querySelector("[data-field=size-width]") ?? null;
        const found = one.shadowRoot && find(one.shadowRoot);
        if (found) return found;
      }
      return null;
    };
    const field = find(document) as HTMLElement | null;
    if (field) field.style.cssText = "position: fixed; top: -300px";
    field?.shadowRoot?.querySelector("input")?.blur();
  });
  await expect(width).toHaveAttribute("refused");
  expect(await width.locator(".why").count()).toBe(0);
});

/** The ring of what has the focus: how opaque it is, and whether all of it is in what scrolls or cuts round it. */
const focusRing = (page: Page) =>
  page.evaluate(() => {
    const above = (node: Element): Element | null => node.assignedSlot ?? node.parentElement ?? hostOf(node);
    const hostOf = (node: Element): Element | null => (node.getRootNode() as Partial<ShadowRoot>).host ?? null;
    let focused = document.activeElement;
    while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
    if (!focused || focused === document.body) return null;
    const name = `${hostOf(focused)?.localName ?? ""} ${focused.id || focused.getAttribute("aria-label")}`;
    // A number's field has its ring round its label and its unit, too, and one of several choices round its words.
    const ofChoice = focused.matches("[type=radio]") ? focused.nextElementSibling : null;
    const ringed = ofChoice ?? (focused.closest(".box") ? hostOf(focused) : focused) ?? focused;
    const { outlineStyle, outlineOffset, outlineWidth } = getComputedStyle(ringed);
    const drawnInside = outlineStyle === "none";
    const out = drawnInside ? 0 : Number.parseFloat(outlineOffset) + Number.parseFloat(outlineWidth);
    const box = ringed.getBoundingClientRect();
    let opacity = 1;
    let cut = false;
    for (let node: Element | null = ringed; node; node = above(node)) {
      const style = getComputedStyle(node);
      opacity *= Number(style.opacity);
      if (node === ringed || style.overflow === "visible") continue;
      const room = node.getBoundingClientRect();
      cut ||= box.left - out < room.left - 0.5 || box.right + out > room.right + 0.5;
      cut ||= box.top - out < room.top - 0.5 || box.bottom + out > room.bottom + 0.5;
    }
    return { name, opacity, cut };
  });

test("the ring of what scrolls, where Firefox's Tab stops too, is whole", async ({ editor, page }) => {
  await editor.open();
  for (let more = 0; more < 8; more += 1) await editor.addDemoDecal("badge");
  await page.keyboard.press("Tab");
  const faults: string[] = [];
  const scrolled: string[] = [];
  for (;;) {
    const name = await page.evaluate((before) => {
      const visit = (root: ParentNode): HTMLElement[] =>
        [...root.querySelectorAll<HTMLElement>("*")].flatMap((each) =>
          each.shadowRoot ? [each, ...visit(each.shadowRoot)] : [each],
        );
      const next = visit(document).filter((each) => {
        const { overflowX, overflowY } = getComputedStyle(each);
        const scrolls = /auto|scroll/.test(`${overflowX} ${overflowY}`) && each.checkVisibility();
        return scrolls && (each.scrollHeight > each.clientHeight || each.scrollWidth > each.clientWidth);
      })[before];
      if (!next) return null;
      next.tabIndex = 0;
      next.focus();
      return `${next.localName}.${next.className}`;
    }, scrolled.length);
    if (name === null) break;
    scrolled.push(name);
    if ((await focusRing(page))?.cut) faults.push(name);
  }
  expect(faults).toEqual([]);
  expect(scrolled).toEqual(expect.arrayContaining(["div.lower", "div.rows"]));
});

test("wherever Tab comes to, the ring is whole and none is pale", async ({ editor, page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.emulateMedia({ reducedMotion: "reduce" });
  await editor.openOnLowest();
  const stops: string[] = [];
  const faults: string[] = [];
  for (;;) {
    await page.keyboard.press("Tab");
    const ring = await focusRing(page);
    if (ring === null) break;
    stops.push(ring.name);
    if (ring.opacity < 1 || ring.cut) faults.push(`${ring.name}: ${ring.opacity}${ring.cut ? ", cut" : ""}`);
  }
  expect(faults).toEqual([]);
  expect(stops.length).toBeGreaterThan(60);
});

test("who comes back from another tab by its keys sees what was looked at before, wherever the keyboard was", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const lower = page.locator("tc-side-panel .lower");
  const field = editor.field("position-x");
  await field.focus();
  const released = async (ctrlKey: boolean): Promise<number> => {
    await lower.evaluate((panel) => panel.scrollTo(0, panel.scrollHeight));
    const init = { key: "Tab", ctrlKey, bubbles: true, composed: true };
    await field.evaluate((input, init) => input.dispatchEvent(new KeyboardEvent("keyup", init)), init);
    return lower.evaluate((panel) => panel.scrollHeight - panel.clientHeight - panel.scrollTop);
  };
  expect(await released(true)).toBeLessThan(2);
  expect(await released(false), "by Tab alone it is led to the field").toBeGreaterThan(20);
});

test("Escape gives a field back what stood there, then leads to the view, and Enter leaves nobody nowhere", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const before = await editor.design();
  const name = page.locator("tc-layer-properties #name");
  for (const field of [editor.field("position-x"), name]) {
    const stood = await field.inputValue();
    await field.focus();
    await page.keyboard.type("7");
    await page.keyboard.press("Escape");
    await expect(field).toHaveValue(stood);
    await expect(field, "the typing has ended, not the visit").toBeFocused();
    await page.keyboard.press("Escape");
    await expect(editor.view).toBeFocused();
    expect(await editor.selectedName(), "the field was left, not the layer").not.toBe("");
  }
  expect(await editor.design()).toEqual(before);

  await name.fill("Renamed");
  await page.keyboard.press("Enter");
  await expect(name).toBeFocused();
  await expect.poll(() => editor.selectedName()).toBe("Renamed");

  const text = page.locator("tc-text-fields #text");
  await page.getByRole("button", { name: "Add text" }).click();
  await text.fill("Words");
  await text.press("Escape");
  await expect(editor.view).toBeFocused();
  await expect.poll(async () => (await editor.design()).layers.at(-1)).toMatchObject({ type: "text", text: "Words" });
});

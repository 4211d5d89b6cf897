import { expect, test } from "./support/editor-page.ts";
import { file, squareGlb, twoSquaresGlb } from "./support/test-files.ts";

test("numeric fields move, turn, size and fade the selected decal, each as one step", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const id = await editor.addDemoDecal("badge");
  const hashes = [await editor.settledHash()];
  const fields = [
    ["position-x", "20"],
    ["spin", "30"],
    ["size-width", "0.5 m"],
    ["opacity", "60"],
  ] as const;
  for (const [field, value] of fields) {
    await editor.setField(field, value);
    hashes.push(await editor.settledHash());
  }
  expect(new Set(hashes).size).toBe(hashes.length);
  const { projector, opacity } = await editor.decal(id);
  if (projector.kind !== "planar") throw new Error("The decal is not planar.");
  expect(projector.position[0]).toBe(0.2);
  expect(projector.size[0]).toBe(0.5);
  expect(projector.size[1], "width and height stay in proportion").toBeCloseTo(0.5, 6);
  expect(opacity).toBe(0.6);
  for (const hash of hashes.toReversed().slice(1)) {
    await page.locator("#undo").click();
    expect(await editor.settledHash()).toBe(hash);
  }
});

test("a field is scrubbed by its label, live, as one step; what is no number is not taken", async ({
  editor,
  page,
}) => {
  await editor.open();
  const start = await editor.hash();
  const label = await page.locator('tc-number[data-field="spin"] label').boundingBox();
  if (!label) throw new Error("There is no label.");
  const from = { x: label.x + 8, y: label.y + label.height / 2 };
  const seen = new Set([start]);
  await editor.drag(from, { x: from.x + 40, y: from.y }, 5, async () => {
    const known = seen.size;
    await expect.poll(async () => seen.add(await editor.hash()).size).toBeGreaterThan(known);
  });
  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(start);
  await expect(page.locator("#undo")).toBeDisabled();

  await editor.field("spin").fill("about ten");
  await editor.field("spin").press("Tab");
  expect(await editor.settledHash()).toBe(start);
  await expect(editor.field("spin")).toHaveValue("0");

  const width = editor.field("size-width");
  const before = await width.inputValue();
  for (const nothing of ["0", "-3"]) {
    await width.fill(nothing);
    await expect(width, "what nothing can be left of is marked").toHaveAttribute("aria-invalid", "true");
    await width.press("Tab");
    await expect(width).toHaveValue(before);
  }
  expect(await editor.settledHash()).toBe(start);
});

test("lengths are shown in the unit that fits the model, taken in others, and stay within what a design can have", async ({
  editor,
  page,
}) => {
  await editor.open();
  const id = await editor.lowestLayer();
  const numbers = async () => {
    const { projector } = await editor.decal(id);
    if (projector.kind !== "planar") throw new Error("The decal is not planar.");
    return projector;
  };
  await expect(editor.field("position-x")).toHaveAccessibleName("Position X, mm");
  await expect(page.locator("tc-layer-properties h3").filter({ hasText: "Position" })).toHaveText("Position mm");
  for (const [typed, metres] of [
    ["2 cm", 0.02],
    ["-3,5", -0.0035],
    ["0.01 m", 0.01],
    ["2e12", 1e9],
    ["-1e300", -1e9],
  ] as const) {
    await editor.setField("position-x", typed);
    expect((await numbers()).position[0], typed).toBe(metres);
  }
  await expect(editor.field("position-x"), "not what was typed").toHaveAttribute("aria-invalid", "true");
  await editor.setField("size-depth", "1e300");
  expect((await numbers()).size[2]).toBe(1e9);
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  await expect(editor.field("position-x")).toHaveAccessibleName("Position X, cm");
});

test("the ends of a gradient that are set upon each other stay apart", async ({ editor, page }) => {
  await editor.open();
  await page.locator("tc-layer-list .add button").first().click();
  await page.getByRole("menuitem", { name: /gradient/i }).click();
  const ends = async () => {
    const fill = (await editor.design()).layers.find(({ type }) => type === "fill");
    if (fill?.type !== "fill" || fill.gradient?.kind !== "linear") throw new Error("There is no gradient.");
    return fill.gradient;
  };
  for (const axis of ["x", "y", "z"]) await editor.setField(`from-${axis}`, "7");
  for (const axis of ["x", "y", "z"]) await editor.setField(`to-${axis}`, "7");
  const { from, to } = await ends();
  expect(from).toEqual([0.007, 0.007, 0.007]);
  expect(to).not.toEqual(from);
  expect(Math.hypot(...to.map((part, each) => part - (from[each] ?? 0)))).toBeLessThan(0.001);
});

test("a key in the midst of a scrub or a slider's drag takes that back, and not the step before", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  await editor.setField("spin", "12");
  const before = await editor.decal(id);
  const middle = async (selector: string) => {
    await page.locator(selector).scrollIntoViewIfNeeded();
    const box = await page.locator(selector).boundingBox();
    if (!box) throw new Error(`There is no ${selector}.`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  };
  for (const selector of ['tc-number[data-field="position-x"] label', "tc-layer-properties #opacity"]) {
    for (const key of ["Control+z", "Escape"]) {
      const { x, y } = await middle(selector);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 30, y, { steps: 3 });
      await expect.poll(async () => await editor.decal(id), `${selector} is previewed, ${key}`).not.toEqual(before);
      await page.keyboard.press(key);
      await expect.poll(async () => await editor.decal(id), `${selector}, ${key}`).toEqual(before);
      await page.mouse.move(x - 50, y, { steps: 3 });
      await page.mouse.up();
      await editor.idle();
      expect(await editor.decal(id), `${selector}, ${key}, and the pointer goes on`).toEqual(before);
    }
  }
  await page.locator("#undo").focus();
  const { x, y } = await middle('tc-number[data-field="position-x"] label');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 30, y, { steps: 3 });
  await page.keyboard.press("Delete");
  await page.mouse.up();
  expect((await editor.decal(id)).projector, "what is scrubbed is not deleted").not.toEqual(before.projector);
  await page.locator("#undo").click();
  expect(await editor.decal(id)).toEqual(before);

  await page.locator("tc-layer-properties #opacity").press("ArrowLeft");
  expect((await editor.decal(id)).opacity, "the slider is used again").toBeCloseTo(before.opacity - 0.01, 6);
});

test("what is moved or sized by numbers paints the materials that it comes to lie on, as what is dragged there", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  const id = await editor.addDemoDecal("badge");
  const material = async () => (await editor.decal(id)).material;
  await editor.setField("position-x", "-55");
  expect(await material()).toBe(0);
  await editor.setField("position-x", "55");
  expect(await material()).toBe(1);
  await editor.setField("size-width", "200");
  expect(await material()).toEqual([0, 1]);
  await page.locator("#undo").click();
  expect(await material()).toBe(1);
  await editor.addLayer("Add text");
  const words = page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  const materialOfText = async () => (await editor.design()).layers.find(({ type }) => type === "text")?.material;
  await editor.setField("position-x", "-55");
  expect(await materialOfText()).toBe(0);
  await words.fill("Words that go on over the border of both of the squares");
  await words.press("Tab");
  await expect.poll(materialOfText).toEqual([0, 1]);
});

test("what a scrub meets in passing does not stay with the layer", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  const dab = { kind: "planar", position: [-0.6, 0, 0], rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.2], flow: 1 };
  const stroke = { id: "stroke", type: "stroke", material: 0, brush: { tip: "round" }, dabs: [dab] };
  const painting = { id: "painting", type: "paint", strokes: [stroke], mirror: { axis: "x", offset: -0.6 } };
  const layers = [painting, { ...stroke, id: "alone", angleFade: [20, 40] }];
  const design = { format: "texelcast-design", version: 1, assets: {}, layers };
  await editor.openDesign([file("mirrored.design.json", JSON.stringify(design), "application/json")]);
  const layer = async (id: string): Promise<unknown> => (await editor.design()).layers.find((each) => each.id === id);
  /** By its label: as far as pixels, and from there to others. */
  const scrub = async (field: string, far: number, passing: () => Promise<void>, end: number): Promise<void> => {
    const label = page.locator(`tc-number[data-field="${field}"] label`);
    await label.scrollIntoViewIfNeeded();
    const [{ x, y, height }] = await editor.places(label);
    const at = { x: x + 4, y: y + height / 2 };
    const before = await editor.field(field).getAttribute("aria-valuenow");
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.keyboard.down("Shift");
    await page.mouse.move(at.x + far, at.y, { steps: 8 });
    await passing();
    // The panel follows at a pace of its own.
    await expect(editor.field(field)).not.toHaveAttribute("aria-valuenow", before ?? "");
    await page.mouse.move(at.x + end, at.y, { steps: 8 });
    await page.keyboard.up("Shift");
    await page.mouse.up();
    await editor.idle();
  };

  await editor.select("painting");
  const met = (material: unknown) => async () =>
    await expect.poll(() => layer("painting")).toMatchObject({ strokes: [{ material }] });
  await scrub("mirror’s-place", 60, met([0, 1]), 10);
  await met(0)();
  expect(await layer("painting"), "it was moved").not.toMatchObject({ mirror: { offset: -0.6 } });

  await editor.select("alone");
  const faded = (angleFade: unknown) => async () =>
    await expect.poll(() => layer("alone")).toMatchObject({ angleFade });
  await scrub("fade-from", 6, faded([80, 80]), 1);
  await faded([30, 40])();
});

test("what is typed is for the layer that it was typed for, when a press on the model chooses another", async ({
  editor,
  page,
}) => {
  await editor.open();
  const [mark, smiley] = (await editor.design()).layers;
  if (!mark || !smiley) throw new Error("The mug has no two decals.");
  const press = await editor.pointOf(mark.id);
  const depth = async ({ id }: { id: string }) => {
    const { projector } = await editor.decal(id);
    return projector.kind === "planar" ? projector.size[2] : 0;
  };
  const before = await depth(mark);
  const pressMark = async () => {
    await page.mouse.click(press.x, press.y);
    await expect(page.locator("tc-layer-list [aria-current=true] .name")).toHaveText(mark.name);
  };
  await editor.select(smiley.id);
  await editor.field("size-depth").fill("33");
  await pressMark();
  expect([await depth(mark), await depth(smiley)]).toEqual([before, 0.033]);
  await expect(editor.field("size-depth")).toHaveValue(String(before * 1000));

  await editor.select(smiley.id);
  await editor.field("layer-opacity").fill("40");
  await pressMark();
  expect([(await editor.decal(mark.id)).opacity, (await editor.decal(smiley.id)).opacity]).toEqual([1, 0.4]);

  await editor.select(smiley.id);
  await page.locator("tc-layer-properties #name").fill("Grin");
  await pressMark();
  expect((await editor.design()).layers.map(({ name }) => name)).toEqual([mark.name, "Grin"]);
  await page.locator("tc-layer-properties #name").fill("  ");
  await page.locator("tc-layer-properties #name").press("Enter");
  await expect(page.locator("tc-layer-properties #name"), "no name is none").toHaveValue(mark.name);

  await editor.field("size-depth").fill("20");
  await editor.field("size-depth").press("ArrowUp");
  expect(await depth(mark), "a step from what was typed").toBeCloseTo(0.0201, 9);
});

test("after a slider or a switch was used, Ctrl+Z undoes it and the arrow keys stay its own", async ({
  editor,
  page,
}) => {
  await editor.open();
  const start = await editor.hash();
  const id = await editor.lowestLayer();
  const { projector } = await editor.decal(id);
  const slider = page.locator("tc-layer-properties #opacity");
  await slider.focus();
  await editor.quickly(async () => {
    for (let step = 0; step < 2; step += 1) await page.keyboard.press("ArrowLeft");
  });
  expect((await editor.decal(id)).opacity).toBeCloseTo(0.98, 6);
  expect((await editor.decal(id)).projector, "the decal was not nudged").toEqual(projector);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(start);
  await page.getByRole("radio", { name: "Pixels" }).check();
  expect((await editor.decal(id)).filter).toBe("nearest");
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(start);
});

test("arrow keys nudge the decal, Shift further; quick nudges are one step", async ({ editor, page }) => {
  await editor.open();
  const id = await editor.lowestLayer();
  const start = await editor.hash();
  const place = async () => {
    const { projector } = await editor.decal(id);
    return projector.kind === "planar" ? projector.position : [0, 0, 0];
  };
  const at = await place();
  await page.locator("tc-stage").hover();
  await page.keyboard.press("ArrowUp");
  const near = await place();
  await page.keyboard.press("Control+z");
  expect(await place()).toEqual(at);
  await editor.quickly(async () => {
    for (const key of ["ArrowUp", "Shift+ArrowUp"]) await page.keyboard.press(key);
  });
  const far = await place();
  const rise = (from: readonly number[], to: readonly number[]) => (to[1] ?? 0) - (from[1] ?? 0);
  expect(rise(at, near)).toBeGreaterThan(0);
  expect(rise(at, far)).toBeGreaterThan(rise(at, near) * 6);
  expect(await editor.settledHash()).not.toBe(start);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(start);
});

test("keys mean the text while one types in a field", async ({ editor, page }) => {
  await editor.open();
  const before = await editor.design();
  const downloads: string[] = [];
  page.on("download", (download) => downloads.push(download.suggestedFilename()));
  const name = page.locator("tc-layer-properties #name");
  await name.click();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Delete");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Escape");
  await editor.field("position-x").click();
  await page.keyboard.press("Delete");
  await page.keyboard.press("Escape");
  expect(await editor.design()).toEqual(before);
  await editor.field("position-x").click();
  await page.keyboard.press("Control+s");
  await expect.poll(() => downloads, "saving is the page's, wherever the focus is").toEqual(["Mug.design.json"]);
});

test("a decal that is added again lies beside the first, and a copy of it beside both", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  const second = await editor.addDemoDecal("badge");
  await editor.select(second);
  await page.keyboard.press("Control+d");
  await editor.select(second);
  await page.keyboard.press("Control+d");
  const { layers } = await editor.design();
  const places = layers.map((layer) =>
    layer.type === "decal" && layer.projector.kind === "planar" ? layer.projector.position.join() : "",
  );
  expect(places).toHaveLength(4);
  expect(new Set(places).size, "each has a place of its own").toBe(4);
});

test("decals are duplicated, reordered, hidden, renamed and deleted", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const placeFields = ["position-x", "position-y"];
  await editor.addDemoDecal("badge");
  const badge = await Promise.all(placeFields.map((name) => editor.field(name).inputValue()));
  await editor.addDemoDecal("number");
  // Over the badge, so that the picture tells what lies above.
  for (const [index, name] of placeFields.entries()) await editor.setField(name, badge[index] ?? "");
  await editor.row("Number 07").focus();
  const names = async () => (await editor.design()).layers.map(({ name }) => name);
  const start = await editor.settledHash();

  await page.keyboard.press("Control+d");
  expect(await names()).toEqual(["Travel badge", "Number 07", "Number 07 2"]);
  expect(await editor.settledHash()).not.toBe(start);
  await page.keyboard.press("Delete");
  expect(await editor.settledHash()).toBe(start);

  await editor.row("Travel badge").click();
  await editor.action("up").click();
  expect(await names()).toEqual(["Number 07", "Travel badge"]);
  const swapped = await editor.settledHash();
  expect(swapped).not.toBe(start);
  await page.keyboard.press("Alt+ArrowDown");
  expect(await names()).toEqual(["Travel badge", "Number 07"]);
  await editor.row("Travel badge").focus();
  await page.keyboard.press("Alt+ArrowUp");
  expect(await names()).toEqual(["Number 07", "Travel badge"]);
  await page.keyboard.press("Alt+ArrowDown");
  expect(await names()).toEqual(["Travel badge", "Number 07"]);
  expect(await editor.settledHash()).toBe(start);

  const row = await editor.row("Number 07").boundingBox();
  const goal = await editor.row("Travel badge").boundingBox();
  if (!row || !goal) throw new Error("A row has no place.");
  await editor.drag({ x: row.x + 60, y: row.y + 14 }, { x: row.x + 60, y: goal.y + goal.height - 4 }, 6);
  expect(await names()).toEqual(["Number 07", "Travel badge"]);
  expect(await editor.settledHash()).toBe(swapped);

  await editor.row("Travel badge").locator("[data-action=visible]").click();
  const hidden = await editor.settledHash();
  expect(hidden).not.toBe(swapped);
  await editor.row("Travel badge").locator("[data-action=visible]").click();
  expect(await editor.settledHash()).toBe(swapped);

  await page.locator("tc-layer-properties #name").fill("Crest");
  await page.locator("tc-layer-properties #name").press("Enter");
  expect(await names()).toContain("Crest");
});

test("every switch of the panel reaches the texture or the design", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const id = await editor.addDemoDecal("number");
  let last = await editor.settledHash();
  const changes = async (claim: string) => {
    const now = await editor.settledHash();
    expect(now, claim).not.toBe(last);
    last = now;
  };
  await page.locator("#flipX").click();
  await changes("flipped left to right");
  await page.locator("#flipY").click();
  await changes("flipped top to bottom");
  await page.getByRole("radio", { name: "Pixels" }).check();
  await changes("nearest pixel");
  await page.getByRole("radio", { name: "Seamless" }).check();
  await editor.setField("tilt", "-60");
  await changes("tilted");
  await editor.setField("fade-from", "20");
  await changes("fades earlier");
  await page.locator("#backfaces").check();
  await page.locator("#through").check();
  expect(await editor.decal(id)).toMatchObject({
    flipX: true,
    flipY: true,
    filter: "nearest",
    wrap: "repeat",
    angleFade: [20, 90],
    backfaces: true,
    occlusion: "none",
  });
});

test("a layer's blend mode is chosen in the list, its mixing and its hold on alpha in the panel", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const id = await editor.addDemoDecal("number");
  const start = await editor.settledHash();
  const mode = page.getByRole("combobox", { name: "Blend mode" });
  await expect(mode).toHaveValue("normal");
  await expect(mode.getByRole("option")).toHaveCount(17);
  await mode.selectOption("Difference");
  const inSrgb = await editor.settledHash();
  expect(inSrgb).not.toBe(start);
  await page.getByRole("radio", { name: "As light" }).check();
  expect(await editor.settledHash()).not.toBe(inSrgb);
  await page.locator("#lockAlpha").check();
  expect(await editor.decal(id)).toMatchObject({ blend: "difference", blendSpace: "linear", lockAlpha: true });

  const { projector } = await editor.decal(id);
  await mode.focus();
  await page.keyboard.press("ArrowUp");
  const { blend, projector: kept } = await editor.decal(id);
  expect(blend, "the keys are the choice's own").toBe("soft-light");
  expect(kept, "and move neither the decal").toEqual(projector);
  expect(await editor.selectedName(), "nor the selection").toContain("Number 07");

  for (let step = 0; step < 4; step += 1) await page.keyboard.press("Control+z");
  await expect.poll(() => editor.settledHash()).toBe(start);
  await expect(mode).toHaveValue("normal");
});

test("texture size and gutter are the user's choice, and the decal is drawn anew at each size", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  const { bakeCount } = await editor.stats();
  await page.locator("tc-target-settings #size").selectOption("512");
  await expect.poll(() => editor.textureSize()).toEqual({ width: 512, height: 512 });
  await editor.idle();
  expect((await editor.stats()).bakeCount).toBe(bakeCount + 1);
  const small = await editor.hash();
  await page.locator("tc-target-settings #size").selectOption("256");
  await expect.poll(() => editor.textureSize()).toEqual({ width: 256, height: 256 });
  expect(await editor.settledHash()).not.toBe(small);
  await page.locator("tc-target-settings #gutter").selectOption("8");
  await editor.idle();
  await expect(editor.notices).toHaveCount(0);
});

test("the maps behind the texture are shown beside the model", async ({ editor, page }) => {
  await editor.open();
  for (const name of ["Positions", "Normals", "Coverage", "Overlap", "Texture"]) {
    await page.getByRole("tab", { name }).click();
    await expect(page.getByRole("tab", { name })).toHaveAttribute("aria-selected", "true");
    await editor.idle();
    const panel = await page.locator("tc-texture-panel").boundingBox();
    const outlines = await page.locator("#outlines").boundingBox();
    if (!panel || !outlines) throw new Error("A part of the page has no place.");
    expect(outlines.x, "the panel keeps its width").toBeLessThan(panel.x + panel.width - 40);
  }
  await page.locator("#outlines").uncheck();
  await page.locator("#layout-model").click();
  await expect(page.locator("tc-texture-panel")).toHaveCount(0);
  await expect(editor.notices).toHaveCount(0);
});

test("what a step back brings back is chosen again, alone or with the others, and not what lies beside it", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const name of ["flower", "badge", "smiley"]) await editor.addDemoDecal(name);
  const chosen = async (): Promise<string[]> => page.locator("tc-layer-list [aria-selected=true]").allInnerTexts();
  await editor.row("Flower").click();
  await editor.row("Travel badge").click({ modifiers: ["Control"] });
  const before = await chosen();
  expect(before).toHaveLength(2);
  await page.keyboard.press("Delete");
  expect((await editor.design()).layers).toHaveLength(1);
  await editor.row("Smiley").click();
  await page.keyboard.press("Control+z");
  await expect.poll(chosen).toEqual(before);
});

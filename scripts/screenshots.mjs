/**
 * `npm run screenshots`: builds the site and takes the README's and the guide's pictures from the real page, by real mouse and keys:
 *   docs/images/editor.png   the editor while a decal is being moved over the mug
 *   docs/images/maps.png     what the engine works with: texture, positions, normals
 *   docs/images/line-up.png  a decal that has come into line with another one, in the midst of its drag
 *   docs/images/pixels.png   a blank skin in pixel mode, with what a pencil and a bucket have left
 */
import { mkdirSync } from "node:fs";
import { inRoot } from "./bootstrap/paths.mjs";
import { withSiteInChromium } from "./site-in-chromium.mjs";

/** CSS pixels. */
const EDITOR_SIZE = { width: 1600, height: 940 };
/** Low enough that the texture fills its panel. */
const MAPS_SIZE = { width: 1600, height: 610 };
const GUIDE_SIZE = { width: 1280, height: 720 };

await withSiteInChromium(4180, async (browser, address) => {
  mkdirSync(inRoot("docs/images"), { recursive: true });
  const page = await browser.newPage({ viewport: EDITOR_SIZE, colorScheme: "light" });
  await openEditor(page, address);
  await takeEditor(page);
  await takeMaps(page, browser);
  await page.close();
  for (const take of [takeLineUp, takePixels]) {
    const context = await browser.newContext({ viewport: GUIDE_SIZE, colorScheme: "light", deviceScaleFactor: 2 });
    const guide = await context.newPage();
    await openEditor(guide, address);
    await take(guide);
    await context.close();
  }
});

/** @param {import("@playwright/test").Page} page @param {string} address */
async function openEditor(page, address) {
  await page.addInitScript(() => localStorage.setItem("texelcast-hint-seen", "yes"));
  await page.goto(address);
  await page.waitForFunction(() => "texelcast" in window);
  await page.evaluate(() => window.texelcast.ready);
}

/** @param {import("@playwright/test").Page} page */
async function settle(page) {
  await page.evaluate(() => window.texelcast.idle());
  // The camera glides to its place and shadows fade in.
  await page.waitForTimeout(1500);
}

/** @param {import("@playwright/test").Page} page */
async function takeEditor(page) {
  await settle(page);
  const from = await page.evaluate(() => {
    const { texelcast } = window;
    const [layer] = texelcast.design().layers;
    if (layer?.type !== "decal" || layer.projector.kind !== "planar") throw new Error("The mug has no decal.");
    texelcast.select(layer.id);
    return texelcast.project(...layer.projector.position);
  });
  if (!from) throw new Error("The decal is not in view.");
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 100, from.y - 22, { steps: 12 });
  await page.mouse.up();
  // The pointer rests on the decal: the texture view marks the same place.
  await settle(page);
  const path = inRoot("docs/images/editor.png");
  await page.screenshot({ path });
  console.log(path);
}

/** @param {import("@playwright/test").Page} page @param {import("@playwright/test").Browser} browser */
async function takeMaps(page, browser) {
  /** @type {{ name: string, picture: string }[]} */
  const maps = [];
  await page.setViewportSize(MAPS_SIZE);
  for (const name of ["Texture", "Positions", "Normals"]) {
    await page.getByRole("tab", { name }).click();
    await page.locator("tc-texture-panel #outlines").setChecked(name === "Texture");
    await page.locator("tc-texture-panel").getByRole("button", { name: "Fit" }).click();
    await page.mouse.move(4, 4);
    await settle(page);
    const picture = await page.locator("tc-texture-panel [role=tabpanel]").screenshot();
    maps.push({ name, picture: picture.toString("base64") });
  }
  const figures = maps.map(
    ({ name, picture }) =>
      `<figure><img src="data:image/png;base64,${picture}"><figcaption>${name}</figcaption></figure>`,
  );
  // Of its own: the editor's page keeps its policy, which takes no style that is written here.
  const sheet = await browser.newPage({ viewport: MAPS_SIZE });
  await sheet.setContent(`<!doctype html><style>
    body { margin: 0; display: flex; gap: 16px; width: max-content; padding: 16px; background: #fff; }
    figure { margin: 0; text-align: center; font: 15px/2.2 system-ui, sans-serif; color: #5a616c; }
    img { display: block; border-radius: 8px; }
  </style>${figures.join("")}`);
  const path = inRoot("docs/images/maps.png");
  await sheet.locator("body").screenshot({ path });
  console.log(path);
}

/** @param {import("@playwright/test").Page} page */
async function takeLineUp(page) {
  await settle(page);
  await page.locator("tc-decal-palette [data-decal=number]").click();
  await settle(page);
  const [mark, number] = await page.evaluate(() =>
    [0, -1].map((at) => {
      const layer = window.texelcast.design().layers.at(at);
      const place = layer?.type === "decal" && layer.projector.kind === "planar" ? layer.projector.position : null;
      return place && window.texelcast.project(...place);
    }),
  );
  if (!mark || !number) throw new Error("The decals are not in view.");
  await page.mouse.move(number.x, number.y);
  await page.mouse.down();
  // It lies beside the mark already, and would come into line with the mug's own middle.
  await page.mouse.move(mark.x + 106, mark.y - 20, { steps: 8 });
  await settle(page);
  const line = page.locator(".tcv-root:not(.tcv-texture) .tcv-alignment-line");
  // Seen from above, what is level is no level line on the screen.
  for (let down = -14; !(await line.getAttribute("d")); down += 2) {
    if (down > 14) throw new Error("The decals do not come into line.");
    await page.mouse.move(mark.x + 106, mark.y + down, { steps: 2 });
    await settle(page);
  }
  const path = inRoot("docs/images/line-up.png");
  await page.locator("tc-stage").screenshot({ path });
  await page.mouse.up();
  console.log(path);
}

/** @param {import("@playwright/test").Page} page */
async function takePixels(page) {
  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitem", { name: "New from template…" }).click();
  await page.locator("tc-template-dialog [data-template=block-wide]").click();
  await settle(page);
  const box = await page.locator(".tcv-root:not(.tcv-texture)").boundingBox();
  if (!box) throw new Error("The page shows no model.");
  /** @param {number} right @param {number} down parts of the view */
  const at = (right, down) => /** @type {const} */ ([box.x + box.width * right, box.y + box.height * down]);
  await page.keyboard.press("g");
  await page.locator("#tool-color").fill("#e4572e");
  await page.mouse.click(...at(0.5, 0.52));
  await settle(page);
  await page.keyboard.press("n");
  await page.locator("#tool-color").fill("#fff1d6");
  for (const side of [-1, 1]) {
    await page.mouse.move(...at(0.49 + side * 0.06, 0.44));
    await page.mouse.down();
    await page.mouse.move(...at(0.49 - side * 0.06, 0.6), { steps: 12 });
    await page.mouse.up();
  }
  await page.locator("tc-texture-panel #guide").setChecked(true);
  await page.mouse.move(4, 4);
  await settle(page);
  const path = inRoot("docs/images/pixels.png");
  await page.screenshot({ path });
  console.log(path);
}

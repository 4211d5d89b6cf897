/**
 * `npm run screenshots`: builds the site and takes the README's pictures from the real page, by real mouse and keys:
 *   docs/images/editor.png  the editor while a decal is being moved over the mug
 *   docs/images/maps.png    what the engine works with: texture, positions, normals
 */
import { mkdirSync } from "node:fs";
import { inRoot } from "./bootstrap/paths.mjs";
import { withSiteInChromium } from "./site-in-chromium.mjs";

/** CSS pixels. */
const EDITOR_SIZE = { width: 1600, height: 940 };
/** Low enough that the texture fills its panel. */
const MAPS_SIZE = { width: 1600, height: 610 };

await withSiteInChromium(4180, async (browser, address) => {
  mkdirSync(inRoot("docs/images"), { recursive: true });
  const page = await browser.newPage({ viewport: EDITOR_SIZE, colorScheme: "light" });
  await page.addInitScript(() => localStorage.setItem("texelcast-hint-seen", "yes"));
  await page.goto(address);
  await page.waitForFunction(() => "texelcast" in window);
  await page.evaluate(() => window.texelcast.ready);
  await takeEditor(page);
  await takeMaps(page, browser);
});

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

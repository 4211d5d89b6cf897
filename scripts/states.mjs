/**
 * `npm run states [-- words…]`: a picture of each state of the page, on each screen, into build/states; and sheets of them
 * side by side, which is the quick way to look. Words choose: "phone" all that have it in their name, "phone decal" those
 * with both.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { inRoot } from "./bootstrap/paths.mjs";
import { withSiteInChromium } from "./site-in-chromium.mjs";
import { CHAPTERS } from "./states/chapters.mjs";
import { LOOKS } from "./states/looks.mjs";
import { PageHand } from "./states/page-hand.mjs";

/** Pixels of a sheet, which is as much as one sees at once. */
const SHEET_WIDTH = 1180;
const SHEET_HEIGHT = 1300;

const words = process.argv.slice(2);
const folder = inRoot("build/states");
/** @type {string[]} */
const faults = [];

await withSiteInChromium(4190, async (browser, address) => {
  for (const look of LOOKS) {
    /** @type {string[]} */
    const taken = [];
    for (const chapter of CHAPTERS) {
      if (!words.every((word) => `${look.name} ${chapter.name}`.includes(word))) continue;
      taken.push(...(await takeChapter(browser, address, look, chapter)));
    }
    if (taken.length > 0) await makeSheets(browser, look, taken);
  }
});
for (const fault of faults) console.error(fault);
if (faults.length > 0) process.exitCode = 1;

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {string} address
 * @param {import("./states/looks.mjs").Look} look
 * @param {import("./states/chapters.mjs").Chapter} chapter
 * @returns {Promise<string[]>} names of the pictures taken
 */
async function takeChapter(browser, address, look, chapter) {
  const context = await browser.newContext({
    viewport: look.viewport,
    hasTouch: look.touch,
    isMobile: look.touch,
    colorScheme: look.scheme,
    reducedMotion: "reduce",
  });
  const taken = [];
  let name = chapter.name;
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(20_000);
    if (!chapter.firstVisit) await page.addInitScript(() => localStorage.setItem("texelcast-hint-seen", "yes"));
    await chapter.before?.(page);
    await page.goto(`${address}?${look.query}`);
    const hand = new PageHand(page, look);
    if (!chapter.unready) await hand.ready();
    mkdirSync(`${folder}/${look.name}`, { recursive: true });
    for (const [state, open] of chapter.states) {
      name = `${chapter.name}-${state}`;
      const after = await open(hand);
      // A gesture under way never comes to rest.
      if (!chapter.unready && !after) await hand.settle();
      await hand.drawn();
      await page.screenshot({ path: `${folder}/${look.name}/${name}.png` });
      taken.push(name);
      await after?.();
    }
    console.log(`${look.name}: ${chapter.name}`);
  } catch (error) {
    faults.push(`${look.name}, ${name}: ${error instanceof Error ? error.message : error}`);
  } finally {
    await context.close();
  }
  return taken;
}

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {import("./states/looks.mjs").Look} look
 * @param {readonly string[]} names
 */
async function makeSheets(browser, look, names) {
  const columns = Math.max(2, Math.round((1.3 * SHEET_WIDTH) / look.viewport.width));
  const width = Math.min(look.viewport.width, Math.floor(SHEET_WIDTH / columns) - 8);
  const rowHeight = (width * look.viewport.height) / look.viewport.width + 26;
  const perSheet = columns * Math.max(1, Math.floor(SHEET_HEIGHT / rowHeight));
  const page = await browser.newPage({ viewport: { width: SHEET_WIDTH, height: 400 } });
  for (let start = 0; start < names.length; start += perSheet) {
    const figures = names.slice(start, start + perSheet).map((name) => {
      const data = readFileSync(`${folder}/${look.name}/${name}.png`).toString("base64");
      return `<figure><figcaption>${name}</figcaption><img width="${width}" src="data:image/png;base64,${data}"></figure>`;
    });
    await page.setContent(`<!doctype html><style>
      body { display: flex; flex-wrap: wrap; gap: 6px; margin: 0; background: #c33; }
      figure { margin: 0; }
      figcaption { font: 13px/20px system-ui; color: #fff; }
      img { display: block; }
    </style>${figures.join("")}`);
    const sheet = await page.locator("body").screenshot();
    writeFileSync(`${folder}/${look.name}-${start / perSheet + 1}.png`, sheet);
  }
  await page.close();
}

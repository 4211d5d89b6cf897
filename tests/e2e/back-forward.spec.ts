/** Pages that the browser keeps while another one is shown, and gives back as they were: its cache for back and forward. */
import { type Browser, chromium, expect, type Page, test } from "@playwright/test";
import { chromiumLaunch } from "../../scripts/bootstrap/chromium.mjs";

let browser: Browser;
let page: Page;
const faults: string[] = [];

test.beforeEach(async ({ baseURL }) => {
  // Playwright's own browsers are begun without that cache.
  browser = await chromium.launch({ ...chromiumLaunch(), ignoreDefaultArgs: ["--disable-back-forward-cache"] });
  page = await browser.newPage({ baseURL: baseURL ?? "" });
  faults.length = 0;
  page.on("pageerror", (error) => faults.push(error.message));
  await page.route("**/elsewhere.html", (route) =>
    route.fulfill({ contentType: "text/html", body: "<h1>Elsewhere</h1>" }),
  );
  await page.addInitScript(() => {
    localStorage.setItem("texelcast-hint-seen", "yes");
    const given: boolean[] = [];
    Object.assign(window, { given });
    addEventListener("pageshow", ({ persisted }) => given.push(persisted));
  });
});
test.afterEach(() => browser.close());

/** To another page and back again; whether this one was kept meanwhile. */
async function awayAndBack(): Promise<boolean> {
  await page.goto("elsewhere.html");
  await expect(page.getByRole("heading")).toHaveText("Elsewhere");
  // What is given back is not loaded.
  await page.goBack({ waitUntil: "commit" });
  const given = (): Promise<boolean[]> => page.evaluate(() => (window as unknown as { given: boolean[] }).given);
  await expect.poll(given).toHaveLength(2);
  return (await given()).at(-1) === true;
}

for (const mode of ["shop", "full"]) {
  test(`an element in ${mode} mode goes on with its design and its engine`, async () => {
    await page.goto(`element.html?loading=eager&mode=${mode}`);
    const printed = (): Promise<string> =>
      page.evaluate(async () => {
        const editor = document.querySelector("texelcast-editor");
        return (await editor?.exportTexture({ size: 256 }))?.sha256 ?? "";
      });
    await page.evaluate(async () => {
      const editor = document.querySelector("texelcast-editor");
      const told: string[] = [];
      Object.assign(window, { told });
      for (const type of ["load", "error"] as const) editor?.addEventListener(type, () => told.push(type));
      await editor?.addDecal("demo/decals/flower.png");
    });
    const before = await printed();
    expect(await awayAndBack()).toBe(true);
    expect(await printed()).toBe(before);
    const steps = await page.evaluate(async () => {
      const editor = document.querySelector("texelcast-editor");
      await editor?.addText("Back");
      return editor?.undo();
    });
    expect(steps).toBe(true);
    expect(await printed()).toBe(before);
    const told = await page.evaluate(() => (window as unknown as { told: string[] }).told);
    expect(told.filter((type) => type === "error")).toEqual([]);
    expect(faults).toEqual([]);
  });
}

test("what an engine never gets, as its page was held still meanwhile, a new one asks for again without a word", async () => {
  let asked = 0;
  await page.route("**/assets/print-file-*.js", async (route) => {
    // Chromium loses some of what a worker asks for while its page is put away.
    if (++asked > 1) await route.continue();
  });
  await page.goto("element.html?loading=eager&mode=shop");
  await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor");
    const told: string[] = [];
    editor?.addEventListener("error", ({ detail }) => told.push(detail.error.message));
    await editor?.addDecal("demo/decals/flower.png");
    Object.assign(window, { told, printed: editor?.exportTexture({ size: 256 }) });
  });
  await expect.poll(() => asked).toBe(1);
  expect(await awayAndBack()).toBe(true);
  const { sha256, told } = await page.evaluate(async () => {
    const { told, printed } = window as unknown as { told: string[]; printed: Promise<{ sha256: string }> };
    return { told, sha256: (await printed).sha256 };
  });
  expect(sha256).toMatch(/^[0-9a-f]{64}$/);
  expect(told).toEqual([]);
  expect(asked).toBe(2);
  expect(faults).toEqual([]);
});

test("the page goes on with its project, and a project that was changed since is opened as it is now", async () => {
  const ready = async (): Promise<void> => {
    await page.waitForFunction(() => window.texelcast !== undefined);
    await page.evaluate(() => window.texelcast.ready);
  };
  const layers = (): Promise<number> => page.evaluate(() => window.texelcast.design().layers.length);
  const duplicate = async (): Promise<void> => {
    await page.evaluate(() => {
      const { design, select } = window.texelcast;
      select(design().layers[0]?.id ?? null);
    });
    await page.keyboard.press("Control+d");
    await page.evaluate(async () => {
      await window.texelcast.idle();
      await window.texelcast.kept();
    });
  };
  await page.goto("./");
  await ready();
  const first = await layers();
  await duplicate();
  expect(await awayAndBack()).toBe(true);
  expect(await layers()).toBe(first + 1);
  // Another visit opens the project, which the page that is kept would hold, too.
  await page.goto("elsewhere.html");
  await page.goto("./");
  await ready();
  await duplicate();
  expect(await layers()).toBe(first + 2);
  for (let i = 0; i < 2; i++) await page.goBack({ waitUntil: "commit" });
  await ready();
  await expect.poll(layers).toBe(first + 2);
  const notices = page.locator("tc-notice-stack section");
  await expect(notices, "and not as one that another tab has open").toHaveCount(1);
  await expect(notices).toContainText("Mug is back as you left it");
  expect(faults).toEqual([]);
});

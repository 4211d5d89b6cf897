import { chromium } from "@playwright/test";
import { chromiumLaunch } from "/work/main/scripts/bootstrap/chromium.mjs";
const browser = await chromium.launch(chromiumLaunch());
const page = await browser.newPage({ baseURL: "http://localhost:4391/", viewport: { width: 1000, height: 700 } });
page.on("console", (m) => m.type() === "error" && console.log(m.text()));
for (const m of ["mug", "avatar", "skateboard", "block-slim"]) {
  await page.goto(`element.html?mode=shop&loading=eager&locale=en&src=demo/${m}.glb`);
  await page.evaluate(async () => { const e = document.querySelector("texelcast-editor") as any; await e.start(); });
  console.log(m, await page.evaluate(async () => { const t0 = performance.now(); const e = document.querySelector("texelcast-editor") as any; const id = await e.addText("Hello"); const t1 = performance.now(); return [(await e.exportDesign()).design.layers.at(-1).color, t1 - t0]; }));
  await page.waitForTimeout(300); await page.screenshot({ path: `/tmp/p/l9-${m}.png` });
}
await page.goto("?model=demo/skateboard.glb"); await page.waitForTimeout(4000);
await page.getByRole("button", { name: /text/i }).first().click(); await page.waitForTimeout(1500);
await page.screenshot({ path: `/tmp/p/l9-editor.png` });
await browser.close();

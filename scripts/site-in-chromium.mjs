/** The built site in a real Chromium, for the scripts that take its pictures. */
import { chromiumLaunch } from "./bootstrap/chromium.mjs";
import { inRoot } from "./bootstrap/paths.mjs";
import { bootstrapOrExit } from "./bootstrap.mjs";

/**
 * Builds the site, serves it and hands over a browser; both end with `use`.
 *
 * @param {number} port that the site is served on, or the next free one
 * @param {(browser: import("@playwright/test").Browser, address: string) => Promise<void>} use
 */
export async function withSiteInChromium(port, use) {
  await bootstrapOrExit("test");
  const { build, preview } = await import("vite");
  const { chromium } = await import("@playwright/test");
  const configFile = inRoot("vite.config.ts");
  await build({ configFile, logLevel: "warn" });
  const server = await preview({ configFile, preview: { port } });
  const browser = await chromium.launch(chromiumLaunch());
  try {
    await use(browser, server.resolvedUrls?.local[0] ?? "");
  } finally {
    await browser.close();
    await server.close();
  }
}

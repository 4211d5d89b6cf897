/** A Chromium for the end-to-end tests. */
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { SetUpError } from "./set-up-error.mjs";
import { canAptInstall, isProgram, onPath, provide } from "./system.mjs";

/** @type {import("./stamps.mjs").Step} */
export const chromium = {
  isFresh: () => findChromium() !== null,
  async bringUpToDate(progress) {
    if (findChromium()) return;
    if (!canAptInstall()) {
      throw new SetUpError(
        "The end-to-end tests need Chromium, and none was found. Install it, then run the same command again:\n" +
          "  Any system:      npx playwright install --with-deps chromium\n" +
          "  or name yours:   TEXELCAST_CHROMIUM=/path/to/chrome npm test",
      );
    }
    await provide([{ what: "Chromium", debian: "chromium", brew: "chromium", choco: "chromium" }], progress);
  },
};

/** The path of the browser to test with: TEXELCAST_CHROMIUM, the system's, or Playwright's own; null where there is none. */
export function findChromium() {
  const named = process.env.TEXELCAST_CHROMIUM;
  if (named) return isProgram(named) ? named : null;
  return onPath("chromium", "chromium-browser", "google-chrome", "google-chrome-stable") ?? playwrightsOwn();
}

function playwrightsOwn() {
  try {
    const file = createRequire(import.meta.url)("playwright-core").chromium.executablePath();
    return existsSync(file) ? file : null;
  } catch {
    return null; // before npm ci
  }
}

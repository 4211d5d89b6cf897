/** Firefox, driven by WebDriver BiDi, on a screen of its own. */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import puppeteer, { type Browser } from "puppeteer-core";
import { findFirefox } from "../../../scripts/bootstrap/firefox.mjs";
import { openVirtualScreen } from "../../support/virtual-screen.ts";

export interface FirefoxBrowser {
  readonly browser: Browser;
  close(): Promise<void>;
}

export async function launchFirefox(): Promise<FirefoxBrowser> {
  const screen = await openVirtualScreen();
  // Firefox refuses root a home that belongs to somebody else, as containers have it.
  const home = mkdtempSync(join(tmpdir(), "texelcast-firefox-"));
  const tidyUp = () => {
    screen.close();
    rmSync(home, { recursive: true, force: true });
  };
  try {
    const browser = await puppeteer.launch({
      browser: "firefox",
      protocol: "webDriverBiDi",
      executablePath: findFirefox() ?? undefined,
      // Elsewhere the system draws WebGL for headless windows too.
      headless: process.platform !== "linux",
      // Whatever Firefox thinks of the machine's graphics driver.
      extraPrefsFirefox: { "webgl.force-enabled": true },
      env: { ...process.env, HOME: home, ...screen.environment },
    });
    return { browser, close: () => browser.close().finally(tidyUp) };
  } catch (error) {
    tidyUp();
    throw error;
  }
}

/** Firefox, driven by WebDriver BiDi, on a screen of its own. */
import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Readable } from "node:stream";
import puppeteer, { type Browser } from "puppeteer-core";
import { findFirefox, findXvfb } from "../../../scripts/bootstrap/firefox.mjs";

export interface FirefoxBrowser {
  readonly browser: Browser;
  close(): Promise<void>;
}

export async function launchFirefox(): Promise<FirefoxBrowser> {
  const xvfb = process.platform === "linux" ? findXvfb() : null;
  const screen = xvfb ? await startScreen(xvfb) : null;
  // Firefox refuses root a home that belongs to somebody else, as containers have it.
  const home = mkdtempSync(join(tmpdir(), "texelcast-firefox-"));
  const tidyUp = () => {
    screen?.process.kill();
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
      env: { ...process.env, HOME: home, ...(screen && { DISPLAY: screen.display }) },
    });
    return { browser, close: () => browser.close().finally(tidyUp) };
  } catch (error) {
    tidyUp();
    throw error;
  }
}

/** A screen with the first free number, which Xvfb writes to the descriptor that it is told. */
async function startScreen(xvfb: string): Promise<{ readonly process: ChildProcess; readonly display: string }> {
  const args = ["-displayfd", "3", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"];
  const child = spawn(xvfb, args, { stdio: ["ignore", "ignore", "pipe", "pipe"] });
  let words = "";
  child.stderr?.on("data", (text) => {
    words += text;
  });
  const ended = once(child, "close").then(([code]) => {
    throw new Error(`${xvfb} ended with exit code ${code}: ${words.trim()}`);
  });
  ended.catch(() => {}); // its end after the tests is no fault
  const [number] = await Promise.race([once(child.stdio[3] as Readable, "data"), ended]);
  return { process: child, display: `:${String(number).trim()}` };
}

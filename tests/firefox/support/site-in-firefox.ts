/** The built site, served, and a page of Firefox. */
import type { Page } from "puppeteer-core";
import { serveBuiltSite } from "../../support/built-site.ts";
import { launchFirefox } from "./firefox-browser.ts";

export interface SiteInFirefox {
  readonly address: string;
  readonly page: Page;
  /** What the page has written to the console as an error, or thrown and not caught. */
  readonly faults: readonly string[];
  close(): Promise<void>;
}

/** @param headers sent with every file */
export async function openSiteInFirefox(headers: Readonly<Record<string, string>> = {}): Promise<SiteInFirefox> {
  const server = await serveBuiltSite(headers);
  const firefox = await launchFirefox();
  const page = await firefox.browser.newPage();
  const faults: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`page: ${String(error)}`));
  await page.setViewport({ width: 1280, height: 800 });
  const close = async (): Promise<void> => {
    await firefox.close();
    await server.close();
  };
  return { address: server.address, page, faults, close };
}

/** The built site, served, and a page of WebKit. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { WebDriver } from "selenium-webdriver";
import type { PluginOption } from "vite";
import { serveBuiltSite } from "../../support/built-site.ts";
import { launchWebkit } from "./webkit-browser.ts";

export interface SiteInWebkit {
  readonly address: string;
  readonly driver: WebDriver;
  /** Runs a function in the page, as the page's own script would; it uses nothing from outside itself. */
  evaluate<Given extends readonly unknown[], Result>(
    run: (...given: Given) => Result,
    ...given: Given
  ): Promise<Awaited<Result>>;
  /** What the page that is open has written to the console as an error, or thrown and not caught. */
  faults(): Promise<readonly string[]>;
  close(): Promise<void>;
}

declare global {
  interface Window {
    faultsForTests: string[];
    /** The first element that fits the selector, in the document or in any shadow tree of it. */
    findForTests(selector: string, root?: ParentNode): HTMLElement | null;
  }
}

export async function openSiteInWebkit(): Promise<SiteInWebkit> {
  const site = await serveBuiltSite({}, [FAULTS]);
  const { driver, close } = await launchWebkit().catch(async (error) => {
    await site.close();
    throw error;
  });
  await driver.manage().window().setRect({ width: 1280, height: 840 });
  const evaluate: SiteInWebkit["evaluate"] = async (run, ...given) => {
    const { result, fault } = await driver.executeAsyncScript<{ result?: never; fault?: string }>(
      `const [given, done] = arguments;
       Promise.resolve().then(() => (${run})(...given))
         .then((result) => done({ result }), (thrown) => done({ fault: String(thrown) + "\\n" + thrown?.stack }));`,
      given,
    );
    if (fault !== undefined) throw new Error(`In the page: ${fault}`);
    return result as never;
  };
  return {
    address: site.address,
    driver,
    evaluate,
    faults: () => evaluate(() => window.faultsForTests),
    close: () => close().finally(site.close),
  };
}

/** WebDriver tells nothing of the console, and looks into no shadow tree: a script does, which each page loads before all others. */
const FAULTS: PluginOption = {
  name: "faults-for-tests",
  configurePreviewServer({ config, middlewares }) {
    middlewares.use(({ url }, response, next) => {
      const { pathname } = new URL(url ?? "/", "http://site/");
      if (pathname === "/faults-for-tests.js") {
        response.setHeader("content-type", "text/javascript");
        response.end(`(${prepare})();`);
      } else if (pathname === "/" || /^\/\w+\.html$/.test(pathname)) {
        const page = readFileSync(join(config.build.outDir, pathname === "/" ? "index.html" : pathname), "utf8");
        response.setHeader("content-type", "text/html");
        response.end(page.replace("<title>", '<script src="./faults-for-tests.js"></script><title>'));
      } else {
        next();
      }
    });
  },
};

function prepare(): void {
  window.findForTests = (selector, root = document) =>
    root.querySelector<HTMLElement>(selector) ??
    [...root.querySelectorAll("*")].reduce<HTMLElement | null>(
      (found, { shadowRoot }) => found ?? (shadowRoot && window.findForTests(selector, shadowRoot)),
      null,
    );
  window.faultsForTests = [];
  const { error } = console;
  console.error = (...said: unknown[]) => {
    window.faultsForTests.push(`console: ${said.map(String).join(" ")}`);
    error.apply(console, said);
  };
  addEventListener("error", ({ message }) => window.faultsForTests.push(`page: ${message}`));
  addEventListener("unhandledrejection", ({ reason }) => window.faultsForTests.push(`page: ${String(reason)}`));
}

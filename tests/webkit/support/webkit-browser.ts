/** WebKit, driven by WebDriver, on a screen of its own. */
import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import { Builder, type WebDriver } from "selenium-webdriver";
import { findWebkitDriver } from "../../../scripts/bootstrap/webkit.mjs";
import { freePort } from "../../../scripts/test/free-port.mjs";
import { openVirtualScreen } from "../../support/virtual-screen.ts";

export interface WebkitBrowser {
  readonly driver: WebDriver;
  close(): Promise<void>;
}

/** As long as a busy machine may take to start the driver, milliseconds. */
const PATIENCE = 20_000;

export async function launchWebkit(): Promise<WebkitBrowser> {
  const path = findWebkitDriver();
  if (path === null) throw new Error("There is no WebKitWebDriver here.");
  const screen = await openVirtualScreen();
  const port = await freePort();
  const environment = {
    ...process.env,
    ...screen.environment,
    GDK_BACKEND: "x11",
    LIBGL_ALWAYS_SOFTWARE: "1",
    // In a container there is no right to make one. All that is opened here are this checkout's own pages.
    WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
  };
  const child = spawn(path, [`--port=${port}`, "--host=127.0.0.1"], { env: environment, stdio: "ignore" });
  const ended = once(child, "close");
  const tidyUp = async () => {
    child.kill();
    await ended;
    screen.close();
  };
  try {
    const server = `http://127.0.0.1:${port}`;
    await isListening(server, child);
    const driver = await new Builder().usingServer(server).withCapabilities({ browserName: "MiniBrowser" }).build();
    await driver.manage().setTimeouts({ script: 80_000, pageLoad: 80_000 });
    return { driver, close: () => driver.quit().finally(tidyUp) };
  } catch (error) {
    await tidyUp();
    throw error;
  }
}

async function isListening(server: string, child: ChildProcess): Promise<void> {
  const late = Date.now() + PATIENCE;
  while (child.exitCode === null && Date.now() < late) {
    const answer = await fetch(`${server}/status`).catch(() => null);
    if (answer?.ok) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  throw new Error(`WebKitWebDriver did not start (exit code ${child.exitCode}).`);
}

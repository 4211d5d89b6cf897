/**
 * A WebKit for its stage of the tests: WebKitGTK's, which has the engine of Safari, with the driver that comes with it. On a virtual screen
 * (virtual-screen.mjs) it draws WebGL on the processor.
 */
import { canAptInstall, howToInstall, isProgram, onPath } from "./system.mjs";
import { screenNeeds } from "./virtual-screen.mjs";

/** @type {import("./system.mjs").Need} */
const WEBKIT = {
  what: "WebKitGTK and its driver, for the page's tests in it",
  debian: "webkit2gtk-driver",
  note: "WebKit:          WebKitWebDriver on PATH, or TEXELCAST_WEBKIT_DRIVER=/path/to/WebKitWebDriver (Linux alone)",
};

/** Installed where we may; elsewhere the stage says what it lacks and is skipped. @type {import("./stamps.mjs").Step} */
export const webkit = {
  isFresh: () => !canAptInstall() || webkitNeeds().length === 0,
  needs: () => (canAptInstall() ? webkitNeeds() : []),
  bringUpToDate: async () => {},
};

/** The path of WebKit's driver: TEXELCAST_WEBKIT_DRIVER, or the system's; null where there is none. */
export function findWebkitDriver() {
  const named = process.env.TEXELCAST_WEBKIT_DRIVER;
  if (named) return isProgram(named) ? named : null;
  return process.platform === "linux" ? onPath("WebKitWebDriver") : null;
}

/** Why the tests in WebKit cannot run here, with what to install; null where they can. */
export function whyNoWebkit() {
  const needs = webkitNeeds();
  return needs.length === 0 ? null : howToInstall(needs);
}

function webkitNeeds() {
  return [...(findWebkitDriver() ? [] : [WEBKIT]), ...screenNeeds()];
}

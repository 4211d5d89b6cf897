/**
 * A WebKit for its stage of the tests: WebKitGTK's, which has the engine of Safari, with the driver that comes with it. On a virtual screen
 * (virtual-screen.mjs) it draws WebGL on the processor.
 */
import { optionalStep, whyNot } from "./optional-step.mjs";
import { canAptInstall, isProgram, onPath } from "./system.mjs";
import { screenNeeds } from "./virtual-screen.mjs";

/** @type {import("./system.mjs").Need} */
const WEBKIT = {
  what: "WebKitGTK and its driver, for the page's tests in it",
  debian: "webkit2gtk-driver",
  note: "WebKit:          WebKitWebDriver on PATH, or TEXELCAST_WEBKIT_DRIVER=/path/to/WebKitWebDriver (Linux alone)",
};

/** Installed where we may. */
export const webkit = optionalStep(webkitNeeds, canAptInstall);

/** The path of WebKit's driver: TEXELCAST_WEBKIT_DRIVER, or the system's; null where there is none. */
export function findWebkitDriver() {
  const named = process.env.TEXELCAST_WEBKIT_DRIVER;
  if (named) return isProgram(named) ? named : null;
  return process.platform === "linux" ? onPath("WebKitWebDriver") : null;
}

/** Why the tests in WebKit cannot run here, with what to install; null where they can. */
export const whyNoWebkit = () => whyNot(webkitNeeds());

function webkitNeeds() {
  return [...(findWebkitDriver() ? [] : [WEBKIT]), ...screenNeeds()];
}

/** A Firefox for its stage of the tests, on a screen that nobody sees (virtual-screen.mjs). */
import { existsSync, readFileSync } from "node:fs";
import { optionalStep, whyNot } from "./optional-step.mjs";
import { canAptInstall, isProgram, onPath } from "./system.mjs";
import { screenNeeds } from "./virtual-screen.mjs";

/** @type {import("./system.mjs").Need} */
const FIREFOX = {
  what: "Firefox, for the page's tests in it",
  debian: "firefox-esr",
  brew: "--cask firefox",
  choco: "firefox",
  note: "Firefox:         https://www.mozilla.org/firefox, or TEXELCAST_FIREFOX=/path/to/firefox (not a snap: it cannot read the tests' profile)",
};

/** Installed on Debian. */
export const firefox = optionalStep(firefoxNeeds, mayInstall);

/** The path of the Firefox to test with: TEXELCAST_FIREFOX, or the system's; null where there is none that can be driven. */
export function findFirefox() {
  const named = process.env.TEXELCAST_FIREFOX;
  if (named) return isProgram(named) ? named : null;
  const snap = existsSync("/snap/bin/firefox");
  const known = [
    "/Applications/Firefox.app/Contents/MacOS/firefox",
    "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
  ].find((file) => existsSync(file));
  return onPath("firefox-esr") ?? (snap ? null : onPath("firefox")) ?? known ?? null;
}

/** Why the tests in Firefox cannot run here, with what to install; null where they can. */
export const whyNoFirefox = () => whyNot(firefoxNeeds());

function firefoxNeeds() {
  return [...(findFirefox() ? [] : [FIREFOX]), ...screenNeeds()];
}

/** Systems made from Debian, Ubuntu for one, have no package of this name. */
function mayInstall() {
  return (
    canAptInstall() && existsSync("/etc/os-release") && /^ID=debian$/m.test(readFileSync("/etc/os-release", "utf8"))
  );
}

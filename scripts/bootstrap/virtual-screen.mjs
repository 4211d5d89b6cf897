/** A screen that nobody sees. Browsers give no WebGL to a headless window on Linux, while on such a one Mesa draws it on the processor. */
import { onPath } from "./system.mjs";

/** @type {import("./system.mjs").Need} */
const SCREEN = { what: "Xvfb, a screen that nobody sees", debian: "xvfb" };

export function findXvfb() {
  return onPath("Xvfb");
}

/** What is missing. @returns {readonly import("./system.mjs").Need[]} */
export function screenNeeds() {
  const has = process.platform !== "linux" || findXvfb() !== null || process.env.DISPLAY;
  return has ? [] : [SCREEN];
}

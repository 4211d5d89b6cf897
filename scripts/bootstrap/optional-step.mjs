/** What a stage of the tests needs and can be left out with: where we may not install it, the stage says what it lacks and is skipped. */
import { howToInstall } from "./system.mjs";

/**
 * @param {() => readonly import("./system.mjs").Need[]} needs what is missing @param {() => boolean} mayInstall
 * @returns {import("./stamps.mjs").Step}
 */
export function optionalStep(needs, mayInstall) {
  return {
    isFresh: () => !mayInstall() || needs().length === 0,
    needs: () => (mayInstall() ? [...needs()] : []),
    bringUpToDate: async () => {},
  };
}

/** Why a stage cannot run here, with what to install; null where it can. @param {readonly import("./system.mjs").Need[]} needs */
export function whyNot(needs) {
  return needs.length === 0 ? null : howToInstall(needs);
}

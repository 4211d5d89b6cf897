/** The folders that scripts share. Everything that is made lands under build/, which git ignores. */
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const BUILD = join(ROOT, "build");

/** @param {...string} parts a path relative to the checkout */
export function inRoot(...parts) {
  return join(ROOT, ...parts);
}

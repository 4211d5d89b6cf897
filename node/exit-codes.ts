/** What the process answers, for scripts (docs/command-line.md). */
import type { TexelcastError } from "../web/core/texelcast-error.ts";

export const EXIT_OK = 0;
/** A fault of Texelcast's own. */
export const EXIT_INTERNAL = 1;
/** The command was not understood. */
export const EXIT_USAGE = 2;
/** A file, or what it holds, cannot be used; or the result cannot be written. */
export const EXIT_BAD_INPUT = 3;

/** Codes that no input may cause. All others tell of an input. */
const INTERNAL_CODES = new Set(["internal", "engine-crashed", "disposed", "stale-handle", "not-baked", "no-model"]);

/** Whose fault it is, as an exit code: the caller's words, an input's, or Texelcast's own. */
export function exitCodeOf(error: TexelcastError): number {
  if (error.code === "bad-argument") return EXIT_USAGE;
  return INTERNAL_CODES.has(error.code) ? EXIT_INTERNAL : EXIT_BAD_INPUT;
}

/** Why a page's browser began no worker or found no three.js, where that is the page's own doing; loaded when it has not. */
import { TexelcastError } from "../core/texelcast-error.ts";

/**
 * The page's owner is told what to set, by "unsupported"; whatever else was thrown comes back as it is. Browsers tell of all this in
 * words of their own alone: a page without an origin by a SecurityError, the others by a TypeError.
 */
export function refused(thrown: unknown): unknown {
  if (thrown instanceof TexelcastError || !(thrown instanceof Error)) return thrown;
  if (thrown.name === "SecurityError" && self.origin === "null") {
    return new TexelcastError("unsupported", "A page without an origin of its own may begin no worker.", {
      field: "sandbox",
      hint: "Add allow-same-origin to the iframe's sandbox, beside allow-scripts.",
      reason: "no-origin",
      cause: thrown,
    });
  }
  if (thrown.name === "TypeError" && /(?:specifier|Module name).*\bthree\b/.test(thrown.message)) {
    return new TexelcastError("unsupported", "The page does not say where three.js is.", {
      field: "three",
      hint: "Without a bundler take standalone.js, which has it inside, or write an import map: docs/guides/plain-html.md has both.",
      reason: "no-three",
      cause: thrown,
    });
  }
  // Chromium and Safari name the type, Firefox the violation.
  if (thrown.name !== "TypeError" || !/Trusted|Sink type/.test(thrown.message)) return thrown;
  return new TexelcastError("unsupported", "The page's Trusted Types keep the engine's worker from beginning.", {
    field: "require-trusted-types-for",
    hint: "Give the page a default policy that lets its own scripts' addresses through: docs/guides/plain-html.md has it.",
    reason: "trusted-types",
    cause: thrown,
  });
}

/** What a print is asked for, refused in the engine's words: in the engine itself, and in Node before a model is read for it. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { printOptionFault } from "./print-options.ts";

/** @throws TexelcastError "bad-argument", "bad-size", with the option in `field`. */
export function checkPrintOptions(options: unknown): void {
  const fault = printOptionFault(options);
  if (fault === null) return;
  const { field, value, allowed, kind } = fault;
  if (kind === "unknown") {
    throw new TexelcastError("bad-argument", `A print has no option “${field}”.`, {
      ...{ field, value },
      hint: `There are ${allowed}.`,
    });
  }
  if (kind === "clash") {
    throw new TexelcastError(
      "bad-argument",
      `A print's size leaves no choice of its DPI, so ${value} cannot be kept.`,
      {
        ...{ field, value },
        hint: "Give `size` or `dpi`; flat art of a zone (`flattened`) takes both.",
      },
    );
  }
  throw new TexelcastError(field === "size" ? "bad-size" : "bad-argument", `A print's ${field} cannot be ${value}.`, {
    ...{ field, value },
    hint: `It may be ${allowed}.`,
  });
}

/** Whatever was thrown, as the element tells it. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { ToldError } from "../editor/strings/told-error.ts";
import type { ErrorDetail } from "./element-api.ts";
import type { Words } from "./words/words.ts";

/** What the user sees of an error. */
export interface ShownError {
  readonly message: string;
  readonly hint?: string;
}

/** The error in the element's language; what was called off stays as it is. */
export function typedError(thrown: unknown, { errors, told }: Words): TexelcastError {
  // A browser's own words, as of a script that cannot be had, are the page's and not its user's.
  const error = TexelcastError.wrap(thrown, "internal", errors.unexpected, { value: String(thrown) });
  // Once is enough, and the element's own are in its words from the start.
  if (error instanceof ToldError || isCancelled(error)) return error;
  const json = error.toJSON();
  const { message, hint } = told(json);
  if (message === error.message) return error;
  return new ToldError(error.code, message, { ...json, hint, cause: error });
}

export function errorDetail(error: TexelcastError): ErrorDetail {
  const { code, message, hint = "" } = error;
  return { error: error.toJSON(), code, message, hint };
}

/** Nobody needs to hear of what was called off, or of what an element had under way that was taken out of the page. */
export function isCancelled(thrown: unknown): boolean {
  const { code, name } = (thrown ?? {}) as Partial<TexelcastError>;
  return code === "disposed" || name === "AbortError";
}

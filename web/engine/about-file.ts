import { TexelcastError } from "../core/texelcast-error.ts";

/** The core knows bytes, not names: this puts the file's name in front of what it says. */
export function aboutFile(error: unknown, name: string): unknown {
  if (!(error instanceof TexelcastError) || error.code === "engine-crashed") return error;
  return new TexelcastError(error.code, `“${name}”: ${error.message}`, {
    subject: name,
    ...(error.field !== undefined && { field: error.field }),
    ...(error.value !== undefined && { value: error.value }),
    ...(error.hint !== undefined && { hint: error.hint }),
    ...(error.reason !== undefined && { reason: error.reason }),
    cause: error,
  });
}

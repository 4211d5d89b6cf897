import { TexelcastError } from "../core/texelcast-error.ts";
import { REPAIR } from "./gltf-json.ts";

/** The core knows bytes, not files: this puts the model's name in front of what it says, and what to do behind it. */
export function aboutFile(error: unknown, name: string): unknown {
  if (!(error instanceof TexelcastError) || error.code === "engine-crashed") return error;
  return new TexelcastError(error.code, `“${name}”: ${error.message}`, {
    subject: name,
    ...(error.field !== undefined && { field: error.field }),
    ...(error.value !== undefined && { value: error.value }),
    hint: error.hint ?? (error.code === "out-of-budget" ? "Simplify the model." : REPAIR),
    ...(error.reason !== undefined && { reason: error.reason }),
    cause: error,
  });
}

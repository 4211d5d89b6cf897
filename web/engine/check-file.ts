/** A file as an engine is given it, checked at its door: whoever uses an engine directly learns which part is wrong. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ModelSource } from "./engine-api.ts";

/** @throws TexelcastError "bad-argument" for what is no name with bytes, and for side files that are not the same. */
export function checkFile(file: ModelSource): void {
  const given: { readonly [field in keyof ModelSource]?: unknown } = file ?? {};
  const { name, bytes, resources } = given;
  const isNamed = typeof name === "string";
  // By its tag: another window's arrays are none of this one's.
  const isWhole = (bytes as { [Symbol.toStringTag]?: unknown } | undefined)?.[Symbol.toStringTag] === "Uint8Array";
  if (isNamed && isWhole && Symbol.iterator in Object(resources ?? [])) {
    for (const [uri, own] of (resources ?? []) as NonNullable<ModelSource["resources"]>) {
      checkFile({ name: uri, bytes: own });
    }
    return;
  }
  const field = isNamed ? (isWhole ? "resources" : "bytes") : "name";
  throw new TexelcastError("bad-argument", `The file's ${field} is not what it must be.`, {
    ...(isNamed && { subject: name }),
    field,
    value: Object.prototype.toString.call(given[field]),
    hint: "A file is { name: string, bytes: Uint8Array, resources?: Map }.",
  });
}

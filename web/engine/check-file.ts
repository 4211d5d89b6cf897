/** A file as an engine is given it, checked at its door: whoever uses an engine directly learns which part is wrong. */
import { TexelcastError } from "../core/texelcast-error.ts";

/** @throws TexelcastError "bad-argument" for what is no name with bytes. */
export function checkFile(file: { readonly name: string; readonly bytes: Uint8Array }): void {
  const { name, bytes }: { name?: unknown; bytes?: { [Symbol.toStringTag]?: unknown } } = file ?? {};
  const isNamed = typeof name === "string";
  // By its tag: another window's arrays are none of this one's.
  if (isNamed && bytes?.[Symbol.toStringTag] === "Uint8Array") return;
  const field = isNamed ? "bytes" : "name";
  throw new TexelcastError("bad-argument", `The file's ${field} is not what it must be.`, {
    ...(isNamed && { subject: name }),
    field,
    value: Object.prototype.toString.call(isNamed ? bytes : name),
    hint: "A file is { name: string, bytes: Uint8Array }.",
  });
}

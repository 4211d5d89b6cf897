/** JSON that people write and keep, read one way for designs, zones files and the shop's list of products. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { designError } from "./design-problem.ts";
import { repeatedKeys } from "./repeated-keys.ts";

/**
 * @param name The file's name as the user knows it; errors name it.
 * @param what it is, as errors say it: "the design"
 * @param code of these errors
 */
export function parseJson(source: string, name: string, what: string, code: string): unknown {
  // Editors on Windows may put a byte order mark first, which JSON does not allow.
  const text = source.startsWith("\ufeff") ? source.slice(1) : source;
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new TexelcastError(code, `${what} is not valid JSON: ${reason}`, {
      subject: name,
      hint: "Open it in an editor that checks JSON; commas and quotes are the usual fault.",
      cause,
    });
  }
  const repeated = repeatedKeys(text);
  if (repeated.length === 0) return data;
  throw designError(
    name,
    repeated.map((path) => ({ path, message: "stands twice in one object" })),
    "Keep one of the two: programs do not agree which of them holds.",
    code,
  );
}

/**
 * Keys that stand twice in one object of a JSON text. JSON.parse takes the last of them without a word, other readers the first
 * (RFC 8259, 4): what a design says must not hang on who reads it.
 */
import type { DesignPath } from "./design-problem.ts";

/** More are not told anyway. */
const MOST = 50;

/** @param json a text that JSON.parse takes @returns where keys stand once more */
export function repeatedKeys(json: string): DesignPath[] {
  const found: DesignPath[] = [];
  /** Of each object and list that is open: its keys so far (a list has none), and where in it the reading is. */
  const open: { readonly keys: Set<string> | null; at: string | number }[] = [];
  const token = /["{}[\],]/g;
  let before = "";
  for (let match = token.exec(json); match && found.length < MOST; match = token.exec(json)) {
    const inner = open.at(-1);
    const [sign] = match;
    if (sign === "{" || sign === "[") open.push(sign === "{" ? { keys: new Set(), at: "" } : { keys: null, at: 0 });
    else if (sign === "}" || sign === "]") open.pop();
    else if (sign === '"') {
      const end = stringEnd(json, match.index);
      token.lastIndex = end;
      // A string that stands behind neither is a value.
      if (inner?.keys && (before === "{" || before === ",")) {
        inner.at = JSON.parse(json.slice(match.index, end)) as string;
        if (inner.keys.has(inner.at)) found.push(open.map(({ at }) => at));
        inner.keys.add(inner.at);
      }
    } else if (typeof inner?.at === "number") inner.at += 1;
    before = sign;
  }
  return found;
}

/** Just behind the string that begins at `start`. Pictures are long strings: nothing is looked at character by character. */
function stringEnd(json: string, start: number): number {
  for (let end = json.indexOf('"', start + 1); ; end = json.indexOf('"', end + 1)) {
    let escapes = end;
    while (json[escapes - 1] === "\\") escapes -= 1;
    if ((end - escapes) % 2 === 0) return end + 1;
  }
}

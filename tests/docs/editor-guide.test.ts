import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { stringsIn } from "../../web/editor/strings.ts";

/** All texts of the page that stand as they are. */
function textsOf(words: unknown): string[] {
  if (typeof words === "string") return [words];
  return typeof words === "object" && words !== null ? Object.values(words).flatMap(textsOf) : [];
}

test("every word that the guide to the page prints in bold is one of the page's own, but for what begins a point", async () => {
  const guide = await readFile(fileURLToPath(new URL("../../docs/editor.md", import.meta.url)), "utf8");
  const own = new Set(textsOf(stringsIn("en")));
  // "- **Size.** …" says what the point is about.
  const bold = [...guide.matchAll(/\*\*([^*]+)\*\*/g)]
    .map((match) => match[1] as string)
    .filter((text) => !text.endsWith("."));
  expect(bold.length).toBeGreaterThan(50);
  expect(bold.filter((text) => !own.has(text))).toEqual([]);
});

/** What the package leaves out of three-mesh-bvh (scripts/package/left-out.mjs). */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { LEFT_OUT } from "../../scripts/package/left-out.mjs";
import { CHECKOUT } from "./support/installed.ts";

const textsIn = (folder: string, ending: string): string[] =>
  readdirSync(join(CHECKOUT, folder), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(ending))
    .map((name) => readFileSync(join(CHECKOUT, folder, name), "utf8"));

test("is asked by nobody here", () => {
  const asked = new RegExp(`\\.(${LEFT_OUT.join("|")})\\(`);
  expect(textsIn("web", ".ts").filter((text) => asked.test(text))).toEqual([]);
});

test("is in no script of a page, by the names that the library's files have now", () => {
  const scripts = textsIn("build/package/dist", ".js").filter((text) => /\braycastFirst\b/.test(text));
  expect(scripts.length).toBeGreaterThan(0);
  for (const script of scripts) expect(script.match(/Error\("left out"\)/g)).toHaveLength(5);
});

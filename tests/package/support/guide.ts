/** The lines of docs/package.md that say that a test runs them. */
import { readFileSync } from "node:fs";
import { CHECKOUT } from "./installed.ts";

const BLOCK = /<!-- A test runs these lines\. -->\n```(\w+)\n(.*?)```/gs;

/** The block of a language that holds some words. */
export function guideLines(language: string, words = ""): string {
  const guide = readFileSync(`${CHECKOUT}docs/package.md`, "utf8");
  const found = [...guide.matchAll(BLOCK)].find(([, own, lines]) => own === language && lines?.includes(words));
  if (found?.[2] === undefined) throw new Error(`docs/package.md has no ${language} block with “${words}”`);
  return found[2];
}

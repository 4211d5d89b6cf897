/** The code of docs/guides: files in fences, each under a line that names it. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { CHECKOUT } from "./installed.ts";

const FOLDER = join(CHECKOUT, "docs/guides");
const FILE = /<!-- A test runs this as (\S+) -->\n```\w+\n(.*?)```/gs;
const FENCE = /^(.*)\n```(\w+)$/gm;

const GUIDES = readdirSync(FOLDER).map((name) => ({ name, text: readFileSync(join(FOLDER, name), "utf8") }));

/** All files of the guides, by the path that they have in a shop's folder. */
export function guideFiles(): Record<string, string> {
  const files: Record<string, string> = {};
  for (const { name, text } of GUIDES) {
    for (const [, path = "", lines = ""] of text.matchAll(FILE)) {
      if (path in files) throw new Error(`two guides have a ${path}, one is docs/guides/${name}`);
      files[path] = lines;
    }
  }
  return files;
}

export function guideFile(path: string): string {
  const lines = guideFiles()[path];
  if (lines === undefined) throw new Error(`no guide in docs/guides has a ${path}`);
  return lines;
}

/** Fences that no test takes for a file. */
export const looseFences = (): string[] =>
  GUIDES.flatMap(({ name, text }) =>
    [...text.matchAll(FENCE)]
      .filter(([, before = ""]) => !before.startsWith("<!-- A test runs this as "))
      .map(([, , language]) => `${name}: ${language}`),
  );

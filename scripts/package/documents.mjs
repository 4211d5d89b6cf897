/**
 * The documents that go along: the README, the changes, and what `docs` says in words. Errors name files of `docs`, and the
 * README leads to them. Pictures stay behind, and so does what only a checkout has: a link to it becomes its words.
 */
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";

const PICTURE = /^!\[[^\]]*\]\((?!https?:)[^)]*\)\n+/gm;
const LINK = /\[([^\]]*)\]\((?!https?:|#)([^)#]*)(#[^)]*)?\)/g;

/** @param {string} folder of the package; its other files are there already */
export function writeDocuments(folder) {
  const pages = ["docs", "docs/guides"].flatMap((under) =>
    readdirSync(inRoot(under))
      .filter((name) => name.endsWith(".md"))
      .map((name) => `${under}/${name}`),
  );
  const names = ["README.md", "CHANGELOG.md", ...pages];
  for (const name of names) {
    const isThere = (/** @type {string} */ target) => {
      const path = normalize(join(dirname(name), target)).replaceAll("\\", "/");
      return names.includes(path) || existsSync(join(folder, path));
    };
    const text = readFileSync(inRoot(name), "utf8")
      .replace(PICTURE, "")
      .replace(LINK, (link, words, target) => (isThere(target) ? link : words));
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
}

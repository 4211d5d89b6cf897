/**
 * Style sheets and markup in scripts without their comments and the space that only reads well: no minifier of scripts looks into
 * templates, and they are half a kilobyte of what a shop's page loads first.
 */
import { readFile } from "node:fs/promises";

// An expression inside of a sheet holds no sheet of its own here.
const SHEET = /(\bcss|\/\* css \*\/ )`([^`]*)`/g;
const SHADER = /\/\* glsl \*\/ `[^`]*`/g;
// As biome writes them, and no statement: an opened template, one tag before another, what goes on with a tag or ends it on a
// line of its own, a value, a tag after one, a template's end.
const OPENED = /\bhtml`\s+/g;
const BETWEEN_TAGS = />\s*\n\s*</g;
const WITHIN_TAG = /\n\s+(?=[@?.]?[a-zA-Z-]+=["$]|\/?>|<\/|\$\{|`[;,)}]?$)/gm;
const AFTER_VALUE = /(?<=\})\n\s+(?=<[a-z])/g;

/** @param {string} sheet What stands between the backticks. */
function tightSheet(sheet) {
  return (
    sheet
      .replace(/\/\*.*?\*\//gs, "")
      .replace(/\s+/g, " ")
      .replace(/ ?([{};]) ?/g, "$1")
      // Before a colon a space means "any element within"; after one, and after a comma, it means nothing.
      .replace(/([:,]) /g, "$1")
      .replaceAll(";}", "}")
      .trim()
  );
}

/** @param {string} source */
function tight(source) {
  const styled = source
    .replace(SHEET, (_, mark, sheet) => `${mark}\`${tightSheet(sheet)}\``)
    // A line each: its directives end with theirs.
    .replace(SHADER, (shader) => shader.replace(/\n\s+/g, "\n"));
  if (!styled.includes("html`")) return styled;
  return styled
    .replace(OPENED, "html`")
    .replace(BETWEEN_TAGS, "> <")
    .replace(WITHIN_TAG, " ")
    .replace(AFTER_VALUE, " ");
}

/**
 * @returns {import("esbuild").Plugin}
 */
export function tightStyles() {
  return {
    name: "tight-styles",
    setup(build) {
      build.onLoad({ filter: /\/web\/.*\.ts$/ }, async ({ path }) => {
        const source = await readFile(path, "utf8");
        return { contents: tight(source), loader: "ts" };
      });
    },
  };
}

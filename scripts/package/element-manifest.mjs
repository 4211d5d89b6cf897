/** The Custom Elements Manifest: what editors and documentation tools read of `<texelcast-editor>`. */
import { readFileSync } from "node:fs";
import * as analyzer from "@custom-elements-manifest/analyzer";
import { inRoot } from "../bootstrap/paths.mjs";

// Its own types are of another file than the one that is loaded.
const { create, ts } = /** @type {any} */ (analyzer);

const SOURCE = "web/element/texelcast-editor.ts";

/**
 * The manifest (schema 1.0.0 and newer), without what is private or the browser's and Lit's own.
 * @param {string} module path of the script that registers the element, from the package's folder
 * @returns {Record<string, any>}
 */
export function elementManifest(module) {
  const text = readFileSync(inRoot(SOURCE), "utf8");
  const source = ts.createSourceFile(module, text, ts.ScriptTarget.ES2022, true);
  const manifest = create({ modules: [source] });
  for (const each of manifest.modules) {
    each.declarations = each.declarations.filter(/** @param {any} one */ ({ customElement }) => customElement);
    for (const element of each.declarations) {
      // What is sent under a name of the moment is written down by its names.
      element.events = element.events.filter(/** @param {any} event */ ({ description }) => description);
      element.members = element.members.filter(/** @param {any} member */ (member) => isOwn(member));
    }
    each.exports = [
      { kind: "custom-element-definition", name: "texelcast-editor", declaration: { name: "TexelcastEditor", module } },
    ];
  }
  return manifest;
}

const LIFECYCLE = new Set(["connectedCallback", "disconnectedCallback", "render", "updated", "properties", "styles"]);

/** @param {{name: string, privacy?: string}} member */
function isOwn({ name, privacy }) {
  return privacy !== "private" && privacy !== "protected" && !name.startsWith("#") && !LIFECYCLE.has(name);
}

/**
 * The rooms of the project, top to bottom: a file may import from its own room and from those that its room may use.
 * An import upward is a fault. docs: CONTRIBUTING.md, "Rooms".
 */
import { readdirSync, readFileSync } from "node:fs";
import { join, posix, relative, sep } from "node:path";

/**
 * From the most particular folder to the least: a file belongs to the first whose path it begins with. Rooms marked
 * `bare` run in bare Node, so they may not use packages that want a page.
 * @type {readonly {folder: string, uses: readonly string[], bare?: boolean}[]}
 */
const ROOMS = [
  { folder: "web/editor/document", uses: ["web/engine", "web/core"], bare: true },
  { folder: "web/app", uses: ["web/element", "web/editor", "web/viewer", "web/engine", "web/core"] },
  { folder: "web/storefront", uses: ["web/element"] },
  { folder: "web/element", uses: ["web/editor", "web/viewer", "web/engine", "web/core"] },
  { folder: "web/editor", uses: ["web/editor/document", "web/viewer", "web/engine", "web/core"] },
  { folder: "web/viewer", uses: ["web/engine", "web/core"] },
  { folder: "web/engine", uses: ["web/core"], bare: true },
  { folder: "web/core", uses: [], bare: true },
  { folder: "node", uses: ["web/editor/document", "web/engine", "web/core"], bare: true },
];
const PAGE_PACKAGES = ["three", "three-mesh-bvh", "camera-controls", "lit", "lucide"];
const IMPORTS = /(?:\bfrom\s*|\bimport\s*\(?\s*|\bnew\s+URL\(\s*)(["'])([^"'\n]+)\1/g;

/**
 * Every import that goes where its room may not, one sentence each.
 * @param {string} root the checkout
 * @returns {string[]}
 */
export function layerFaults(root) {
  return ["web", "node"].flatMap((folder) =>
    sourcesIn(join(root, folder)).flatMap((file) => {
      const path = relative(root, file).split(sep).join("/");
      return faultsOf(path, readFileSync(file, "utf8"));
    }),
  );
}

/**
 * @param {string} path of the file, relative to the checkout, with forward slashes
 * @param {string} source
 */
export function faultsOf(path, source) {
  const room = roomOf(path);
  if (!room) return [`${path} is in no room: name its folder in scripts/lint/layers.mjs`];
  return [...source.matchAll(IMPORTS)].flatMap(([, , specifier]) => {
    if (!specifier.startsWith(".")) {
      const used = room.bare && PAGE_PACKAGES.find((name) => specifier === name || specifier.startsWith(`${name}/`));
      return used ? [`${path} imports ${used}, but ${room.folder} must run in bare Node`] : [];
    }
    const target = posix.normalize(posix.join(posix.dirname(path), specifier));
    const other = roomOf(target);
    if (!other || other === room || room.uses.includes(other.folder)) return [];
    return [`${path} imports ${target}: ${room.folder} may not use ${other.folder}`];
  });
}

/** @param {string} path */
function roomOf(path) {
  // A page beside the rooms (index.html's script) would be web/*.ts; only folders are rooms.
  return ROOMS.find(({ folder }) => path.startsWith(`${folder}/`));
}

/**
 * @param {string} folder
 * @returns {string[]}
 */
function sourcesIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return sourcesIn(path);
    return /\.(ts|mts|js|mjs)$/.test(entry.name) ? [path] : [];
  });
}

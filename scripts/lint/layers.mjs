/**
 * The rooms of the project, top to bottom: a file may import from its own room and from those that its room may use.
 * An import upward is a fault. docs: CONTRIBUTING.md, "Rooms".
 */
import { readdirSync, readFileSync } from "node:fs";
import { join, posix, relative, sep } from "node:path";

/**
 * From the most particular folder to the least: a file belongs to the first whose path it begins with. `runs` says where:
 * a page has no Node modules, bare Node has no packages that want a page.
 * @type {readonly {folder: string, uses: readonly string[], runs: "page" | "node" | "anywhere"}[]}
 */
const ROOMS = [
  { folder: "web/editor/document", uses: ["web/engine", "web/core"], runs: "anywhere" },
  { folder: "web/storefront/api", uses: [], runs: "anywhere" },
  {
    folder: "node/storefront",
    uses: ["node", "web/storefront/api", "web/editor/document", "web/engine", "web/core"],
    runs: "node",
  },
  { folder: "web/app", uses: ["web/embed", "web/element", ...below("web/element")], runs: "page" },
  { folder: "web/package", uses: ["web/embed", "web/element", ...below("web/element")], runs: "page" },
  { folder: "web/embed", uses: ["web/element", "web/core"], runs: "page" },
  { folder: "web/storefront", uses: ["web/storefront/api", "web/embed", "web/element"], runs: "page" },
  { folder: "web/element", uses: below("web/element"), runs: "page" },
  { folder: "web/editor", uses: below("web/editor"), runs: "page" },
  { folder: "web/viewer", uses: below("web/viewer"), runs: "page" },
  { folder: "web/engine", uses: below("web/engine"), runs: "node" },
  { folder: "web/core", uses: [], runs: "node" },
  { folder: "node", uses: ["web/editor/document", "web/engine", "web/core"], runs: "node" },
];
const PAGE_PACKAGES = ["three", "three-mesh-bvh", "camera-controls", "lit", "lucide"];
/** What is no room and may be imported from everywhere: what is built, what is installed, the version. */
const OUTSIDE = /^(build\/|node_modules\/|package\.json$)/;
/** Where a call takes an address, it may be a template's. */
const IMPORTS =
  /(?:\bfrom\s*|\bimport\s*)(["'])([^"'\n]+)\1|(?:\bimport\s*\(\s*|\bnew\s+URL\(\s*)(["'`])([^"'`\n]+)\3/g;

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
  return [...source.matchAll(IMPORTS)].flatMap(([, , named, , called]) => {
    const specifier = named ?? called ?? "";
    if (!specifier.startsWith(".")) {
      const { folder, runs } = room;
      // WebAssembly wants no page, whatever package it lies in.
      const isScript = !specifier.endsWith(".wasm");
      const fromPage = PAGE_PACKAGES.find(
        (name) => specifier === name || (isScript && specifier.startsWith(`${name}/`)),
      );
      if (runs !== "page" && fromPage) return [`${path} imports ${fromPage}, but ${folder} must run in bare Node`];
      if (runs !== "node" && specifier.startsWith("node:")) {
        return [`${path} imports ${specifier}, but ${folder} must run in a page`];
      }
      return [];
    }
    const target = posix.normalize(posix.join(posix.dirname(path), specifier));
    const other = roomOf(target);
    if (!other) return OUTSIDE.test(target) ? [] : [`${path} imports ${target}, which lies in no room`];
    if (other === room || room.uses.includes(other.folder)) return [];
    return [`${path} imports ${target}: ${room.folder} may not use ${other.folder}`];
  });
}

/** @param {string} folder */
function below(folder) {
  const order = ["web/element", "web/editor", "web/editor/document", "web/viewer", "web/engine", "web/core"];
  return order.slice(order.indexOf(folder) + 1);
}

/** @param {string} path */
function roomOf(path) {
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

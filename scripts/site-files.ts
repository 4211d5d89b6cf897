/**
 * Which modules of the static site stand in one file. Left to itself the bundler makes a file of whatever a set of dynamic imports
 * shares: 59 of them before the editor's first line, some of 70 bytes, and an engine that its worker asks for in four turns.
 */
import { fileURLToPath } from "node:url";
import { normalizePath, type Plugin } from "vite";

/** What a page, or a part that follows at once, begins with: its modules' paths, with slashes. */
export interface SiteStart {
  readonly name: string;
  readonly modules: readonly string[];
}

/** Starts by their names, of modules as they stand below web/, without their endings. */
export const startsIn = (starts: Readonly<Record<string, readonly string[]>>): SiteStart[] =>
  Object.entries(starts).map(([name, modules]) => ({
    name,
    modules: modules.map((path) => normalizePath(fileURLToPath(new URL(`../web/${path}.ts`, import.meta.url)))),
  }));

/** What the bundler tells of its modules. */
export interface ModuleGraph {
  getModuleInfo(
    id: string,
  ): { readonly importedIds: readonly string[]; readonly dynamicallyImportedIds: readonly string[] } | null;
}

/** Whatever is asked for later, as a start of its own. */
const LATER = "later";

/** For a bundle of pages: modules that the same starts need stand in one file. */
export const filesByStarts = (starts: readonly SiteStart[]): Plugin => ({
  name: "texelcast-files-by-starts",
  apply: "build",
  outputOptions: (options) => ({ ...options, codeSplitting: inGroups(fileByStarts(starts)) }),
});

/** Each module by its own name: what it imports may be in another file than it. */
const inGroups = (name: (id: string, graph: ModuleGraph) => string | null) => ({
  includeDependenciesRecursively: false,
  groups: [{ name, debugName: "starts" }],
});

/**
 * Names a module's file by the starts that need it at once: what the same ones need stands together, and no page loads (or
 * runs: a page's own script does something) what only another needs. What parts that are asked for later need too stands apart from what
 * they do not, for the same reason. Files then import each other one way only, as whoever needs a module needs what it imports.
 * Null for what a start begins with, which is a file of its own, and where no start needs it: what is asked for later stands where the
 * bundler puts it.
 *
 * For one bundle, whose modules are looked at when it first asks.
 */
export function fileByStarts(starts: readonly SiteStart[]): (id: string, graph: ModuleGraph) => string | null {
  let needs: readonly (readonly [name: string, needed: ReadonlySet<string>])[] | null = null;
  // Of a page of which nothing is left but imports each file becomes a script tag, and the browser does other things between them.
  const begun = new Set(starts.map(({ modules }) => modules[0]));
  return (id, graph) => {
    if (begun.has(id)) return null;
    needs ??= [
      ...starts,
      { name: LATER, modules: askedForLater(starts, graph).filter((later) => !begun.has(later)) },
    ].map(({ name, modules }) => [name, allImported(modules, graph)] as const);
    const names = needs.filter(([, needed]) => needed.has(id)).map(([name]) => name);
    return names[0] === undefined || names[0] === LATER ? null : names.join("-");
  };
}

/** What modules import when they need it. */
function askedForLater(starts: readonly SiteStart[], graph: ModuleGraph): readonly string[] {
  const found = new Set(starts.flatMap(({ modules }) => modules));
  const later = new Set<string>();
  for (const id of found) {
    const info = graph.getModuleInfo(id);
    for (const imported of info?.importedIds ?? []) found.add(imported);
    for (const imported of info?.dynamicallyImportedIds ?? []) {
      found.add(imported);
      later.add(imported);
    }
  }
  return [...later];
}

/** Modules and all that they import at once. */
function allImported(modules: readonly string[], graph: ModuleGraph): ReadonlySet<string> {
  const found = new Set(modules);
  for (const id of found) {
    for (const imported of graph.getModuleInfo(id)?.importedIds ?? []) found.add(imported);
  }
  return found;
}

/**
 * For a worker's bundle, which is that of the start whose first module it has: all of the start's modules, with what they need at once,
 * stand in one file, which the entry imports. (With the entry as that file an answer from afar is spared, and WebKit runs it twice:
 * what a worker's later parts import from its own address is another module there, and a second engine answered.)
 */
export const workerInOneFile = (starts: readonly SiteStart[]): Plugin => ({
  name: "texelcast-worker-in-one-file",
  apply: "build",
  outputOptions: (options) => ({ ...options, codeSplitting: inGroups(fileOfWorker(starts)) }),
});

/** Names a module's file in such a bundle; null for what is asked for later. */
export function fileOfWorker(starts: readonly SiteStart[]): (id: string, graph: ModuleGraph) => string | null {
  let needed: ReadonlySet<string> | null = null;
  return (id, graph) => {
    const start = starts.find(({ modules: [entry = ""] }) => graph.getModuleInfo(entry) !== null);
    if (start === undefined) return null;
    needed ??= allImported(start.modules, graph);
    return needed.has(id) ? start.name : null;
  };
}

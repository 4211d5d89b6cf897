/**
 * Which modules of the static site stand in one file. Left to itself the bundler makes a file of whatever a set of dynamic imports
 * shares: 59 of them before the editor's first line, some of 70 bytes, and an engine that its worker asks for in four turns.
 */
import type { Plugin } from "vite";

/** What a page, a worker, or a part that follows at once begins with: its modules' paths, with slashes. */
export interface SiteStart {
  readonly name: string;
  readonly modules: readonly string[];
}

/** What the bundler tells of its modules. */
export interface ModuleGraph {
  getModuleInfo(id: string): { readonly importedIds: readonly string[] } | null;
}

/** For one bundle: modules that the same starts need stand in one file. */
export const filesByStarts = (starts: readonly SiteStart[]): Plugin => ({
  name: "texelcast-files-by-starts",
  apply: "build",
  outputOptions: (options) => ({
    ...options,
    // What a module imports has its own starts: the same, or more.
    codeSplitting: { includeDependenciesRecursively: false, groups: [{ name: fileByStarts(starts) }] },
  }),
});

/**
 * Names a module's file by the starts that need it at once: what the same ones need stands together, and no page loads what
 * only another needs. Files then import each other one way only, as whoever needs a module needs what it imports. Null where no
 * start needs it: what is asked for later stands where the bundler puts it.
 *
 * For one bundle, whose modules are looked at when it first asks. Starts that it has not are passed over: each worker is a bundle
 * of its own.
 */
export function fileByStarts(starts: readonly SiteStart[]): (id: string, graph: ModuleGraph) => string | null {
  let needs: readonly ReadonlySet<string>[] | null = null;
  return (id, graph) => {
    needs ??= starts.map(({ modules }) => allImported(modules, graph));
    const names = starts.filter((_, at) => needs?.[at]?.has(id)).map(({ name }) => name);
    return names.length > 0 ? names.join("-") : null;
  };
}

/** Modules and all that they import at once. */
function allImported(modules: readonly string[], graph: ModuleGraph): ReadonlySet<string> {
  const found = new Set(modules);
  for (const id of found) {
    for (const imported of graph.getModuleInfo(id)?.importedIds ?? []) found.add(imported);
  }
  return found;
}

/** Of a bundle's files, what is looked at here. */
interface BundledFile {
  readonly type: "chunk" | "asset";
  readonly isEntry?: boolean;
  code?: string;
}

/** An entry of which nothing is left but the import of the file where its modules were put. */
const ENTRY_ELSEWHERE = /^import\s*"\.\/([^"]+)";\s*$/;

/**
 * For a worker's bundle: the file that its entry only imports becomes the entry, which spares an answer from afar. (No page can ask
 * for it beforehand: what a page preloads is no worker's.)
 */
export const entryInOneFile = (): Plugin => ({
  name: "texelcast-entry-in-one-file",
  apply: "build",
  generateBundle: (_, bundle) => joinEntry(bundle),
});

export function joinEntry(bundle: Record<string, BundledFile>): void {
  for (const [name, entry] of Object.entries(bundle)) {
    const elsewhere = entry.isEntry ? ENTRY_ELSEWHERE.exec(entry.code ?? "")?.[1] : undefined;
    const code = elsewhere === undefined ? undefined : bundle[`assets/${elsewhere}`]?.code;
    if (elsewhere === undefined || code === undefined) continue;
    delete bundle[`assets/${elsewhere}`];
    entry.code = code;
    for (const file of Object.values(bundle)) {
      file.code = file.code?.replaceAll(`"./${elsewhere}"`, `"./${name.slice("assets/".length)}"`);
    }
  }
}

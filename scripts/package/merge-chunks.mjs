/**
 * Fewer and larger files: a bundler that splits makes a file of every set of modules that the same places share, and twenty
 * small ones compress worse than one. What is always loaded together becomes one file.
 */
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { build } from "esbuild";

/** @typedef {import("esbuild").Metafile["outputs"][string]} Output */

/** What a file takes from another: `import{a as b}from"./x.js"`, and the same with `export`. */
const NAMED = /(?:import|export)\s*\{([^}]*)\}\s*from\s*"\.\/([\w-]+\.js)"/g;

/** The same of a package that stays outside. */
const OF_PACKAGE = /(?:import|export)\s*\{([^}]*)\}\s*from\s*"(?!\.)([^"]+)"/g;

/** A script that is loaded together with the one that names it. */
const AT_ONCE = /(?:\bfrom|\bimport)\s*"\.\/([\w-]+\.js)"/g;

/**
 * Merges the scripts of one build in place.
 *
 * @param {object} parts
 * @param {string} parts.dist where the build was written
 * @param {import("esbuild").Metafile} parts.metafile
 * @param {readonly (readonly string[])[]} parts.moments sources of the scripts that are loaded with all they import, by the moment at
 *   which they are: what the same roots need, and no moment before, is merged. A root that a page or a worker begins with is
 *   merged into a file of its own, `…-shared.js`, which its own file only imports. Nothing else imports that file: the same script under a second address (Vite's development server
 *   begins a worker as `engine-worker.js?worker_file&type=module`) would run a second time.
 * @param {import("esbuild").BuildOptions} parts.options of the build
 */
export async function mergeChunks({ dist, metafile, moments, options }) {
  const graph = new Graph(metafile);
  const namesAt = moments.map((roots) => roots.map((source) => graph.named(source)));
  const rootNames = namesAt.flat();
  /** Roots that keep a file of their own name. @type {readonly string[]} */
  const begun = rootNames.filter((name) => graph.entries.includes(name));
  const groups = groupsOf(graph, namesAt).filter((members) => members.length > 1 || begun.includes(members[0] ?? ""));
  /** Merged script to the one it is now part of. @type {Map<string, string>} */
  const partOf = new Map();
  /** Of each merged file the script that it is made from first. @type {Map<string, string>} */
  const firstOf = new Map();
  for (const members of groups) {
    const first = members.find((member) => rootNames.includes(member)) ?? members[0] ?? "";
    const name = begun.includes(first) ? `${basename(first, ".js")}-shared.js` : first;
    firstOf.set(name, first);
    for (const member of members) partOf.set(member, name);
  }
  // How a merged script's export is called in the file that it is part of. By the script's number: its hash would stand at every
  // name, and no compression makes less of it (360 bytes of what shops load at first, and 250 of the first touch).
  const numbers = new Map([...partOf.keys()].map((member, at) => [member, at.toString(36)]));
  const alias = (/** @type {string} */ member, /** @type {string} */ name) => `m${numbers.get(member)}${name}`;
  const read = (/** @type {string} */ name) => readFileSync(join(dist, name), "utf8");
  const wanted = wantedNames(graph.names, partOf, read);
  /** @type {import("esbuild").OutputFile[]} */
  const written = [];
  for (const first of graph.names) {
    const name = partOf.get(first) ?? first;
    // Of a group the first stands for all; what takes nothing from a merged script, and of no package twice, stays as it is.
    if ((firstOf.get(name) ?? first) !== first) continue;
    const merged = [...partOf].filter(([, group]) => group === name).map(([member]) => member);
    const members = merged.length > 0 ? merged : [first];
    const packages = packageNames(members.map(read));
    const takesMerged = graph.importsOf(first).some((each) => partOf.has(each));
    if (!partOf.has(first) && !takesMerged && packages.size === 0) continue;
    const lines = members.flatMap((member) => {
      const names = [...(wanted.get(member) ?? [])].map((each) => `${each} as ${alias(member, each)}`);
      return names.length === 0 ? [] : [`export { ${names.join(", ")} } from "./${member}";`];
    });
    // `export *` leaves it out.
    const hasDefault = name === first && graph.exportsOf(first).includes("default");
    if (hasDefault) lines.push(`export { default } from "./${first}";`);
    const { outputFiles } = await build({
      ...options,
      splitting: false,
      metafile: false,
      write: false,
      outdir: dist,
      entryPoints: undefined,
      stdin: {
        contents: [`${name === first ? "export * from" : "import"} "./${first}";`, ...lines].join("\n"),
        resolveDir: dist,
        sourcefile: "merged",
      },
      plugins: [chunkPlugin({ dist, partOf, members: new Set(members), wanted, packages, alias })],
    });
    for (const file of outputFiles) {
      const isMap = file.path.endsWith(".map");
      const text = isMap ? file.text : file.text.replace(/(\/\/# sourceMappingURL=)\S+\s*$/, `$1${name}.map\n`);
      written.push({ ...file, path: join(dist, isMap ? `${name}.map` : name), text });
    }
  }
  for (const [member, name] of partOf) {
    if (member === name) continue;
    rmSync(join(dist, member));
    rmSync(join(dist, `${member}.map`), { force: true });
    // Whoever asks for it by `import()`, or begins with it, finds it where it was.
    if (!graph.isAskedFor(member) && !begun.includes(member)) continue;
    const names = [...(wanted.get(member) ?? [])].map((each) => `${alias(member, each)} as ${each}`);
    const lines = [names.length > 0 ? `export{${names.join(",")}}from"./${name}";` : `import"./${name}";`];
    if (begun.includes(member)) {
      // What the merged file will import is named here too, so that a page asks for it in the same moment.
      const text = written.find(({ path }) => path === join(dist, name))?.text ?? "";
      lines.push(...[...new Set([...text.matchAll(AT_ONCE)].map(([, each]) => `import"./${each}";`))]);
    }
    writeFileSync(join(dist, member), `${lines.join("")}\n`);
  }
  for (const { path, text } of written) writeFileSync(path, text);

  /** What is taken of merged scripts, from outside of their group. @param {readonly string[]} names */
  function wantedNames(names, /** @type {Map<string, string>} */ merged, /** @type {(name: string) => string} */ text) {
    /** @type {Map<string, Set<string>>} */
    const found = new Map();
    const add = (/** @type {string} */ from, /** @type {string} */ each) => {
      found.set(from, (found.get(from) ?? new Set()).add(each));
    };
    for (const name of names) {
      for (const [, list = "", from = ""] of text(name).matchAll(NAMED)) {
        if (!merged.has(from) || merged.get(from) === (merged.get(name) ?? name)) continue;
        for (const each of list.split(",")) add(from, each.trim().split(/\s+as\s+/)[0] ?? "");
      }
    }
    for (const member of merged.keys()) {
      if ((graph.isAskedFor(member) || begun.includes(member)) && merged.get(member) !== member)
        for (const each of graph.exportsOf(member)) add(member, each);
    }
    return found;
  }
}

/** Before the address of a script that is merged already. */
const WHOLE = "whole:";

/**
 * What is taken of packages that are named more than once, as each source names them by itself. One statement for all is half a
 * kilobyte less in what shops load at first.
 *
 * @param {readonly string[]} texts @returns {Map<string, Set<string>>}
 */
function packageNames(texts) {
  /** @type {Map<string, { times: number, names: Set<string> }>} */
  const found = new Map();
  for (const [, list = "", from = ""] of texts.flatMap((text) => [...text.matchAll(OF_PACKAGE)])) {
    const { times, names } = found.get(from) ?? { times: 0, names: new Set() };
    for (const each of list.split(",")) names.add(each.trim().split(/\s+as\s+/)[0] ?? "");
    found.set(from, { times: times + 1, names });
  }
  return new Map([...found].filter(([, { times }]) => times > 1).map(([from, { names }]) => [from, names]));
}

/**
 * @param {object} parts
 * @param {string} parts.dist
 * @param {Map<string, string>} parts.partOf
 * @param {Set<string>} parts.members of the file that is made
 * @param {Map<string, Set<string>>} parts.wanted
 * @param {Map<string, Set<string>>} parts.packages
 * @param {(member: string, name: string) => string} parts.alias
 * @returns {import("esbuild").Plugin}
 */
function chunkPlugin({ dist, partOf, members, wanted, packages, alias }) {
  return {
    name: "chunks",
    setup(plugged) {
      plugged.onResolve({ filter: /./ }, ({ path, kind }) => {
        if (path.startsWith(WHOLE)) return { path: path.slice(WHOLE.length), external: true };
        const name = path.replace(/^\.\//, "");
        if (kind === "dynamic-import" || kind === "entry-point") return { path, external: kind === "dynamic-import" };
        if (members.has(name)) return { path: join(dist, name) };
        if (path.startsWith("./") && partOf.has(name)) return { path: name, namespace: "merged" };
        if (packages.has(path)) return { path, namespace: "package" };
        return { path, external: true };
      });
      plugged.onLoad({ filter: /./, namespace: "merged" }, ({ path }) => ({
        contents: `export { ${[...(wanted.get(path) ?? [])].map((each) => `${alias(path, each)} as ${each}`).join(", ")} } from "${WHOLE}./${partOf.get(path)}";`,
        resolveDir: dist,
      }));
      plugged.onLoad({ filter: /./, namespace: "package" }, ({ path }) => ({
        contents: `export { ${[...(packages.get(path) ?? [])].join(", ")} } from "${WHOLE}${path}";`,
        resolveDir: dist,
      }));
    },
  };
}

/** Which script imports which. */
class Graph {
  /** @type {Map<string, Output>} */
  #outputs = new Map();

  /** @param {import("esbuild").Metafile} metafile */
  constructor({ outputs }) {
    for (const [path, output] of Object.entries(outputs)) {
      if (path.endsWith(".js")) this.#outputs.set(basename(path), output);
    }
  }

  get names() {
    return [...this.#outputs.keys()];
  }

  /** The script made of a source. @param {string} source */
  named(source) {
    const found = [...this.#outputs].find(([, { entryPoint }]) => entryPoint === source);
    if (!found) throw new Error(`No script is made of ${source}.`);
    return found[0];
  }

  /** @param {string} name */
  exportsOf(name) {
    return this.#outputs.get(name)?.exports ?? [];
  }

  /** Whether some script asks for it by `import()`. @param {string} name */
  isAskedFor(name) {
    return this.names.some((each) => this.importsOf(each, ["dynamic-import"]).includes(name));
  }

  /** @param {string} name @param {readonly string[]} kinds @returns {string[]} */
  importsOf(name, kinds = ["import-statement"]) {
    const imports = this.#outputs.get(name)?.imports ?? [];
    return imports.filter(({ kind, external }) => kinds.includes(kind) && !external).map(({ path }) => basename(path));
  }

  /** A script and all that it needs. @param {string} name @param {readonly string[]} [kinds] */
  reach(name, kinds, seen = new Set()) {
    if (seen.has(name)) return seen;
    seen.add(name);
    for (const each of this.importsOf(name, kinds)) this.reach(each, kinds, seen);
    return seen;
  }

  /** Scripts that pages name themselves. @returns {string[]} */
  get entries() {
    return this.names.filter((name) => this.#outputs.get(name)?.entryPoint && !this.isAskedFor(name));
  }
}

/**
 * Scripts that the same roots of a moment need at once, and the same entries at some time: an entry must not come to load another
 * one's file for a part of it. What needs a script is needed by no more than what the script is needed by, and at no earlier
 * moment, so no two files need each other.
 *
 * @param {Graph} graph @param {readonly (readonly string[])[]} moments roots @returns {string[][]}
 */
function groupsOf(graph, moments) {
  const others = graph.entries.filter((entry) => !moments.flat().includes(entry));
  const sometime = others.map((entry) => graph.reach(entry, ["import-statement", "dynamic-import"]));
  /** Scripts by the first moment that loads them. @type {Set<string>} */
  const loaded = new Set();
  return moments.flatMap((roots) => {
    const atOnce = roots.map((root) => graph.reach(root));
    /** @type {Map<string, string[]>} */
    const groups = new Map();
    for (const name of new Set(atOnce.flatMap((names) => [...names]))) {
      if (loaded.has(name)) continue;
      loaded.add(name);
      const key = [...atOnce, ...sometime].map((names) => Number(names.has(name))).join("");
      groups.set(key, [...(groups.get(key) ?? []), name]);
    }
    return [...groups.values()];
  });
}

/** The npm package, packed and installed into an empty folder; `npm run package` makes it. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { runInNewContext } from "node:vm";
import { checkPackage, createPackageFromTarballData } from "@arethetypeswrong/core";
import { build } from "esbuild";
import { publint } from "publint";
import { afterAll, beforeAll, expect, test } from "vitest";
import { EDGES, ENTRIES } from "../../scripts/package/manifest.mjs";
import { CHECKOUT, type InstalledPackage, installPackage, runInNode } from "./support/installed.ts";

let installed: InstalledPackage;
beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
});
afterAll(() => installed.remove());

test("publint finds nothing to say of it", async () => {
  const { messages } = await publint({ pkgDir: join(CHECKOUT, "build/package"), strict: true, level: "suggestion" });
  expect(messages).toEqual([]);
});

test("its types are right for every import of an ES module", async () => {
  const types = createPackageFromTarballData(readFileSync(installed.tarball));
  const result = await checkPackage(types, { entrypoints: Object.keys(ENTRIES) });
  if (!result.types) throw new Error("the package has no types");
  // There is no CommonJS in it, and Node 10 knew no exports.
  const problems = result.problems.filter(
    (problem) => !("resolutionKind" in problem && ["node10", "node16-cjs"].includes(problem.resolutionKind)),
  );
  expect(problems).toEqual([]);
});

test("it brings no other package along", () => {
  const lock = JSON.parse(readFileSync(join(installed.folder, "package-lock.json"), "utf8")) as {
    packages: Record<string, unknown>;
  };
  expect(Object.keys(lock.packages)).toEqual(["", "node_modules/texelcast"]);
});

test("its documents are with it, and lead to no file that is not", () => {
  const folder = join(installed.folder, "node_modules/texelcast");
  const pages = ["", "docs", "docs/guides"].flatMap((under) =>
    readdirSync(join(folder, under))
      .filter((name) => name.endsWith(".md"))
      .map((name) => join(under, name)),
  );
  // Errors name these two.
  expect(pages).toEqual(
    expect.arrayContaining(["docs/design-document.md", "docs/print-truth.md", "docs/guides/webpack.md"]),
  );
  const lost = pages.flatMap((page) =>
    [...readFileSync(join(folder, page), "utf8").matchAll(/\]\((?!https?:|#)([^)#]*)/g)]
      .filter(([, target = ""]) => !existsSync(join(folder, page, "..", target)))
      .map(([, target]) => `${page}: ${target}`),
  );
  expect(lost).toEqual([]);
});

/** They tell a framework's compiler of the element, and run nothing. */
const TYPES_ALONE = ["./react", "./vue"];

test.each(Object.keys(ENTRIES))("the import %s works in bare Node and starts nothing there", async (path) => {
  const specifier = `texelcast${path.slice(1)}`;
  const script = `
    const before = new Set(Object.getOwnPropertyNames(globalThis));
    const names = Object.keys(await import(${JSON.stringify(specifier)}));
    const added = Object.getOwnPropertyNames(globalThis).filter((name) => !before.has(name));
    console.log(JSON.stringify({ names: names.length > 0, added }));`;
  // The picture codecs hand their pixels over as ImageData, which Node lacks. That Node ends by itself says that nothing runs.
  const added = path === "./node" ? ["ImageData"] : [];
  expect(JSON.parse(await runInNode(installed.folder, script))).toEqual({ names: !TYPES_ALONE.includes(path), added });
});

test("a server's scripts name their files in statements, where what gathers a server's files looks for them", () => {
  // Nitro's and Next.js's own gatherer is not among the checkout's packages: it passes over an address that an arrow gives at once.
  const dist = join(installed.folder, "node_modules/texelcast/dist");
  const scripts = readdirSync(dist).filter((name) => /^(node|cli).*\.js$/.test(name));
  const addresses = scripts.flatMap((name) => [
    ...readFileSync(join(dist, name), "utf8").matchAll(/(=>\s*)?new URL\("([^"]+)", import\.meta\.url\)/g),
  ]);
  expect(addresses.map(([, , address]) => address)).toContain("./assets/Inter_700Bold.ttf");
  expect(addresses.flatMap(([, arrow, address]) => (arrow ? [address] : []))).toEqual([]);
});

/** What a script says that the package is bundled into as this edge does it, run where there is neither Node nor a page. */
async function sayAtEdge(runtime: string, contents: string): Promise<unknown> {
  const { outputFiles } = await build({
    stdin: { contents, resolveDir: installed.folder },
    bundle: true,
    write: false,
    format: "iife",
    logLevel: "error",
    platform: "neutral",
    conditions: [runtime],
    target: "es2022",
  });
  const globals: { said?: unknown } = {};
  runInNewContext(outputFiles[0]?.text ?? "", globals);
  return await globals.said;
}

test.each(EDGES)("%s, a server that is no Node, imports the element's name and registers nothing", async (runtime) => {
  const script = `
    import { EDITOR_TAG, TexelcastEditor } from "texelcast/define";
    import { TexelcastError } from "texelcast";
    said = [EDITOR_TAG, typeof TexelcastEditor, typeof TexelcastError];`;
  expect(await sayAtEdge(runtime, script)).toEqual(["texelcast-editor", "function", "function"]);
});

test.each(EDGES)("on %s, what is thrown is of the class that the root import names", async (runtime) => {
  const script = `
    import { TexelcastEditor } from "texelcast/define";
    import { TexelcastError } from "texelcast";
    try { new TexelcastEditor(); } catch (error) { said = error instanceof TexelcastError; }`;
  expect(await sayAtEdge(runtime, script)).toBe(true);
});

test.each(EDGES)("on %s, a server's entry reads designs, and says where they can be printed", async (runtime) => {
  const script = `
    import { TexelcastError } from "texelcast";
    import { checkPrint, createEngine, parseDesign, renderPrint } from "texelcast/node";
    const calls = [renderPrint, checkPrint, async () => createEngine()];
    said = Promise.all(calls.map((call) => call({}).catch((error) => [error instanceof TexelcastError, error.code, error.hint])))
      .then((refusals) => [parseDesign('{ "format": "texelcast-design", "version": 1 }').layers.length, ...refusals]);`;
  const refusal = [true, "unsupported", "Print on a server with one of them, and ask it from here."];
  expect(await sayAtEdge(runtime, script)).toEqual([0, refusal, refusal, refusal]);
});

test("the words in other languages lie beside the scripts, to be imported or served", async () => {
  const script = `
    import { createRequire } from "node:module";
    const require = createRequire(import.meta.url);
    const words = ["fr", "es", "it", "nl"].map((language) => require("texelcast/wording/" + language + ".json").lang);
    console.log(words.join());`;
  expect(await runInNode(installed.folder, script)).toBe("fr,es,it,nl");
});

test("at an edge, a server's entry offers all that it offers in Node", async () => {
  const script = `
    const names = async (file) => Object.keys(await import("./node_modules/texelcast/dist/" + file)).sort();
    console.log(JSON.stringify([await names("node.js"), await names("node-edge.js")]));`;
  const [inNode, atEdge] = JSON.parse(await runInNode(installed.folder, script)) as string[][];
  expect(atEdge).toEqual(inNode);
});

test("a page's engine says on a server that it needs a page, and what there is instead", async () => {
  const script = `
    import { createEngine, TexelcastError } from "texelcast/core";
    try { createEngine(); } catch (error) { console.log(error instanceof TexelcastError, error.code, error.hint); }`;
  expect(await runInNode(installed.folder, script)).toBe("true unsupported On a server, create it by texelcast/node.");
});

test("what a server's entry throws is of the class that the root import names, and is logged by that name", async () => {
  const script = `
    import { inspect } from "node:util";
    import { TexelcastError } from "texelcast";
    import { renderPrint } from "texelcast/node";
    const error = await renderPrint({}).catch((thrown) => thrown);
    console.log(error instanceof TexelcastError, inspect(error).split(":")[0]);`;
  expect(await runInNode(installed.folder, script)).toBe("true TexelcastError");
});

test("the installed command line tells its version", async () => {
  const { version } = JSON.parse(readFileSync(join(CHECKOUT, "package.json"), "utf8")) as { version: string };
  const cli = join(installed.folder, "node_modules/texelcast/dist/cli.js");
  const script = `process.argv[2] = "--version"; await import(${JSON.stringify(cli)});`;
  expect(await runInNode(installed.folder, `process.argv.push("cli"); ${script}`)).toBe(version);
});

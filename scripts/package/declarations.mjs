/**
 * Types of the package's entries: TypeScript's own declarations, those that the entries reach and no others. Without what is marked
 * `@internal`: it is in terms of packages that lie inside of the scripts, and that a shop has not installed.
 */
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { inRoot } from "../bootstrap/paths.mjs";
import { run } from "../bootstrap/run.mjs";

/** Packages that a shop has installed itself where it asks for the entry, and our own. */
const KNOWN_PACKAGES = new Set(["three", "react", "vue", "texelcast"]);

const PACKAGE_IMPORT = /\b(?:from\s*|import\s*\(?\s*)"([a-z@][^"\n]*)"/g;
const RELATIVE_IMPORT = /(\b(?:from|import)\s*\(?\s*)(["'])(\.{1,2}\/[^"'\n]+?)\.ts\2/g;

/** @param {readonly string[]} entries sources, relative to the checkout @param {string} folder to write to */
export async function declarations(entries, folder) {
  const emitted = inRoot("build/.declarations");
  rmSync(emitted, { recursive: true, force: true });
  const config = inRoot("build/.declarations.json");
  writeFileSync(
    config,
    JSON.stringify({
      extends: "../tsconfig.json",
      compilerOptions: {
        noEmit: false,
        declaration: true,
        emitDeclarationOnly: true,
        stripInternal: true,
        rootDir: "..",
        outDir: ".declarations",
        allowJs: false,
        checkJs: false,
      },
      include: [],
      files: [...entries, "web/engine/draco3dgltf.d.ts"].map((entry) => `../${entry}`),
    }),
  );
  await run(process.execPath, [inRoot("node_modules/typescript/bin/tsc"), "--project", config]);
  const written = new Set();
  /** @param {string} file */
  const write = (file) => {
    if (written.has(file)) return;
    written.add(file);
    const text = withoutLit(readFileSync(file, "utf8"));
    for (const [, name = ""] of text.matchAll(PACKAGE_IMPORT)) {
      if (!KNOWN_PACKAGES.has(name.split("/")[0] ?? ""))
        throw new Error(`${relative(emitted, file)} would ask a shop for the types of ${name}.`);
    }
    const target = join(folder, relative(emitted, file));
    mkdirSync(dirname(target), { recursive: true });
    writeFileSync(target, text.replace(RELATIVE_IMPORT, "$1$2$3.js$2"));
    for (const [, , , specifier] of text.matchAll(RELATIVE_IMPORT)) {
      const imported = resolve(dirname(file), `${specifier}.d.ts`);
      if (existsSync(imported)) write(imported);
    }
  };
  for (const entry of entries) write(join(emitted, entry.replace(/\.ts$/, ".d.ts")));
}

/** The element is to a page what every element is: what it has of Lit's, and of its own base, is its own affair. @param {string} text */
function withoutLit(text) {
  return text
    .replace(/^import \{ RemElement \} from ".*";\n/m, "")
    .replace(/\bextends RemElement\b/, "extends HTMLElement");
}

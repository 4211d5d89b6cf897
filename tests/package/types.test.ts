/** The package's types, read by the real compiler in a project of its own, as strictly as it can. */
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { afterAll, beforeAll, expect, test } from "vitest";
import { guideFiles } from "./support/guide.ts";
import { addShopFiles, CHECKOUT, type InstalledPackage, installPackage } from "./support/installed.ts";

const TSC = join(CHECKOUT, "node_modules/typescript/bin/tsc");

const PAGE_FILES = {
  "define.ts": `
    import { TexelcastEditor } from "texelcast/define";
    const editor = new TexelcastEditor();
    editor.src = "mug.glb";
    editor.style.height = "30rem";
    editor.addEventListener("submit", ({ detail }) => console.log(detail.texture.sha256.length));
    document.body.append(editor);
    document.querySelector("texelcast-editor")?.classList.add("shown");
    // @ts-expect-error There is no such property.
    editor.colour = "red";`,
  "wording.ts": `
    import type { EditorWording, TexelcastEditor } from "texelcast/define";
    import french from "texelcast/wording/fr.json" with { type: "json" };
    export function speakFrench(editor: TexelcastEditor): void {
      editor.wording = { ...french, submit: "Ajouter au panier" };
    }
    export const polish: EditorWording = { lang: "pl", printIssues: { one: "{count} uwaga", other: "{count} uwagi" } };
    // @ts-expect-error There is no such word.
    export const wrong: EditorWording = { sumbit: "x" };`,
  "sends.ts": `
    import { createEngine } from "texelcast/core";
    import { mountTexelcast } from "texelcast/embed";
    import type { PaintedMesh } from "texelcast/three";
    import type { TexelcastEditor } from "texelcast/define";
    export async function send(editor: TexelcastEditor, mesh: PaintedMesh): Promise<Blob> {
      editor.beforeAccept = ({ bytes, type }) => new Blob([bytes], { type }).size > 0;
      editor.addEventListener("submit", ({ detail: { assets, texture } }) => {
        void fetch("/print", { method: "POST", body: texture.bytes });
        return new Blob(assets.map(({ bytes }) => bytes));
      });
      const framed = await mountTexelcast(document.body, { page: "https://editor.example/" });
      const { exportPng, exportGlb, readTexels } = createEngine();
      const picture = new ImageData(new Uint8ClampedArray(await readTexels(0, 0, 0, 1, 1)), 1);
      const files = [await exportPng(0), await exportGlb(), await mesh.exportPng(), await framed.exportModel()];
      const { bytes } = await editor.exportTexture();
      return new Blob([...files, bytes, await editor.exportModel(), picture.data]);
    }`,
  "react.tsx": `
    import type {} from "texelcast/react";
    import type { TexelcastEditor } from "texelcast/define";
    import { useRef } from "react";
    export function Designer() {
      const editor = useRef<TexelcastEditor>(null);
      return <texelcast-editor ref={editor} src="/mug.glb" maxDecals={5} onchange={({ detail }) => console.log(detail.counts.decals)} />;
    }`,
  "vue.ts": `
    import type {} from "texelcast/vue";
    import type { GlobalComponents } from "vue";
    export const tag: keyof GlobalComponents = "texelcast-editor";`,
  "core.ts": `
    import { EDITOR_TAG, TexelcastError } from "texelcast";
    import { createEngine, parseDesign, parseZones } from "texelcast/core";
    import type { LayerPrint, PrintFile, PrintFileOptions, PrintMapKind, PrintReport, PrintZone, PrintZones } from "texelcast/core";
    import { mountTexelcast } from "texelcast/embed";
    import { hostEditor } from "texelcast/host";
    const { hash, setZones } = createEngine({ wasm: "/texelcast.wasm" });
    export const set: Promise<void> = setZones(parseZones("{}"));
    export type PrintWork = [LayerPrint, PrintFile, PrintFileOptions, PrintMapKind, PrintReport, PrintZone, PrintZones];
    export const all = [EDITOR_TAG, TexelcastError, parseDesign, mountTexelcast, hostEditor, hash];`,
  "three.ts": `
    import { Mesh, WebGLRenderer } from "three";
    import { PaintedMesh } from "texelcast/three";
    export const painted = await PaintedMesh.create(new WebGLRenderer(), new Mesh(), { size: 512 });`,
};

const NODE_FILES = {
  "print.ts": `
    import { parseZones, renderPrint, type PrintMapKind, type PrintZones } from "texelcast/node";
    const { sha256 } = await renderPrint({ model: "mug.glb", design: "{}", size: 512 });
    export const read: PrintZones = parseZones("{}");
    export const map: PrintMapKind = "dpi";
    export const zones: number = parseZones("{}").zones.length + sha256.length;
    export const sent = new Blob([(await renderPrint({ model: "mug.glb", design: "{}" })).bytes]);
    // @ts-expect-error A zones file's content is no number.
    export const wrong: number = parseZones("{}");`,
};

let installed: InstalledPackage;
beforeAll(async () => {
  installed = await installPackage();
  for (const name of ["react", "vue", "three", "@types/react", "@types/three", "@types/node"]) installed.provide(name);
});
afterAll(() => installed?.remove());

/** What the compiler says of these files. */
function complaints(files: Readonly<Record<string, string>>, options: object): string {
  const project = {
    compilerOptions: {
      strict: true,
      exactOptionalPropertyTypes: true,
      verbatimModuleSyntax: true,
      skipLibCheck: false,
      noEmit: true,
      target: "es2022",
      jsx: "react-jsx",
      resolveJsonModule: true,
      types: [],
      ...options,
    },
    files: Object.keys(files),
  };
  addShopFiles(installed.folder, { ...files, "tsconfig.json": JSON.stringify(project) });
  const { stdout } = spawnSync(process.execPath, [TSC, "--project", installed.folder], { encoding: "utf8" });
  return stdout;
}

const DOM = ["es2022", "dom", "dom.iterable"];

test.each([
  ["a bundler", { module: "esnext", moduleResolution: "bundler", lib: DOM }],
  ["Node", { module: "nodenext", moduleResolution: "nodenext", lib: DOM }],
])("a strict project of pages finds all types, resolved as %s does", (_, options) => {
  expect(complaints(PAGE_FILES, options)).toBe("");
});

test("a strict project of a server's finds all types, without those of a page", () => {
  const options = { module: "nodenext", moduleResolution: "nodenext", lib: ["es2022"], types: ["node"] };
  expect(complaints(NODE_FILES, options)).toBe("");
});

test("the code of Next.js's guide compiles strictly, with what Next.js sets", () => {
  const files = Object.entries(guideFiles()).filter(([path]) => /^(next\/.*|save-design\.js)$/.test(path));
  const project = Object.fromEntries(files.map(([path, code]) => [path.replace("next/", ""), code]));
  const lib = ["esnext", "dom", "dom.iterable"];
  const options = {
    module: "esnext",
    moduleResolution: "bundler",
    lib,
    types: ["node"],
    allowJs: true,
    isolatedModules: true,
  };
  expect(Object.keys(project)).toContain("app/designs/route.ts");
  expect(complaints(project, options)).toBe("");
});

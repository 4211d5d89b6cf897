import { describe, expect, test } from "vitest";
import { faultsOf } from "../../scripts/lint/layers.mjs";

describe("the arrows between rooms", () => {
  test("an import upward is a fault that names both rooms", () => {
    expect(faultsOf("web/engine/host.ts", 'import { View } from "../viewer/view.ts";')).toEqual([
      "web/engine/host.ts imports web/viewer/view.ts: web/engine may not use web/viewer",
    ]);
  });

  test.each([
    'import "../editor/panel.ts";',
    'export { a } from "../editor/panel.ts";',
    'const later = await import("../editor/panel.ts");',
    "const later = await import(`../editor/panel.ts`);",
    // biome-ignore lint/suspicious/noTemplateCurlyInString: it is the source's own.
    "const later = await import(`../editor/${name}.ts`);",
    // biome-ignore lint/suspicious/noTemplateCurlyInString: it is the source's own.
    "const later = await import(`../${folder}/panel.ts`);",
    'new Worker(new URL("../editor/panel.ts", import.meta.url));',
    'import {\n  a,\n  type B,\n} from "../editor/panel.ts";',
  ])("no kind of import escapes: %s", (source) => {
    expect(faultsOf("web/core/session.ts", source)).toHaveLength(1);
  });

  test.each(["../../tests/support/psnr.ts", "../../scripts/demo/main.ts", "../../bench/models.ts", "../attic.ts"])(
    "what lies in no room is not imported from one: %s",
    (specifier) => {
      expect(faultsOf("web/core/session.ts", `import { a } from "${specifier}";`)).toEqual([
        expect.stringMatching(/, which lies in no room$/),
      ]);
    },
  );

  test("what a comment says of an import is none", () => {
    expect(faultsOf("web/core/session.ts", "/** Rows from `../editor` to `../viewer`. */")).toEqual([]);
  });

  test("an import downward, within a room, of build products, of a package or of the version is free", () => {
    const source = `
      import { Engine } from "../engine/engine-api.ts";
      import { parse } from "./document/parse-design.ts";
      import { thing } from "./panels/thing.ts";
      import licence from "../../node_modules/lucide/LICENSE?raw";
      import { version } from "../../package.json";
      new URL("../../build/wasm/texelcast.wasm", import.meta.url);`;
    expect(faultsOf("web/editor/store.ts", source)).toEqual([]);
  });

  test("the command line may use the document but not the rest of the editor", () => {
    expect(faultsOf("node/render.ts", 'import { parse } from "../web/editor/document/parse.ts";')).toEqual([]);
    expect(faultsOf("node/render.ts", 'import { store } from "../web/editor/store.ts";')).toHaveLength(1);
  });

  test("the document knows nothing of the editor around it", () => {
    expect(faultsOf("web/editor/document/parse.ts", 'import { store } from "../store.ts";')).toHaveLength(1);
  });

  test("rooms that run in bare Node may not use packages that want a page", () => {
    expect(faultsOf("web/engine/host.ts", 'import { Mesh } from "three";')).toEqual([
      "web/engine/host.ts imports three, but web/engine must run in bare Node",
    ]);
    expect(faultsOf("web/viewer/view.ts", 'import { Mesh } from "three";')).toEqual([]);
    expect(faultsOf("web/engine/codec.ts", 'const url = new URL("three/libs/a.wasm", import.meta.url);')).toEqual([]);
  });

  test("rooms that run in a page may not use Node's modules; the engine, which runs in both, may", () => {
    const source = 'const { readFile } = await import("node:fs/promises");';
    expect(faultsOf("web/viewer/view.ts", source)).toEqual([
      "web/viewer/view.ts imports node:fs/promises, but web/viewer must run in a page",
    ]);
    expect(faultsOf("web/editor/document/parse.ts", source)).toHaveLength(1);
    expect(faultsOf("web/engine/host.ts", source)).toEqual([]);
  });

  test("a folder that is no room is a fault, so that a new one gets its arrows", () => {
    expect(faultsOf("web/attic/old.ts", "")).toHaveLength(1);
  });
});

/** Which modules of the site stand in one file. */
import { expect, test } from "vitest";
import { fileByStarts, fileOfWorker, type ModuleGraph } from "../../scripts/site-files.ts";

const graphOf = (
  imports: Readonly<Record<string, readonly string[]>>,
  later: Readonly<Record<string, readonly string[]>> = {},
): ModuleGraph => ({
  getModuleInfo: (id) => (imports[id] ? { importedIds: imports[id], dynamicallyImportedIds: later[id] ?? [] } : null),
});

const GRAPH = graphOf({
  "/editor.ts": ["/canvas.ts", "/panels.ts"],
  "/shop.ts": ["/canvas.ts"],
  "/canvas.ts": ["/words.ts"],
  "/panels.ts": ["/words.ts", "/editor.ts"],
  "/words.ts": [],
  "/help.ts": ["/words.ts"],
});

test("modules that the same starts need stand in one file, and others in others", () => {
  const file = fileByStarts([
    { name: "editor", modules: ["/editor.ts"] },
    { name: "shop", modules: ["/shop.ts"] },
  ]);
  expect(file("/panels.ts", GRAPH)).toBe("editor");
  expect(["/canvas.ts", "/words.ts"].map((id) => file(id, GRAPH))).toEqual(["editor-shop", "editor-shop"]);
  // What a page begins with is its own script.
  expect(["/editor.ts", "/shop.ts"].map((id) => file(id, GRAPH))).toEqual([null, null]);
});

test("what no start needs at once is left to the bundler, unless it is named as following at once", () => {
  expect(fileByStarts([{ name: "editor", modules: ["/editor.ts"] }])("/help.ts", GRAPH)).toBeNull();
  expect(fileByStarts([{ name: "editor", modules: ["/editor.ts", "/help.ts"] }])("/help.ts", GRAPH)).toBe("editor");
});

test("a page's own script stands apart from what a part of another page asks for later, which would run it", () => {
  const graph = graphOf(
    {
      "/page.ts": ["/panels.ts", "/canvas.ts"],
      "/panels.ts": [],
      "/canvas.ts": [],
      "/shop.ts": [],
      "/desk.ts": ["/panels.ts"],
    },
    { "/shop.ts": ["/desk.ts"] },
  );
  const file = fileByStarts([
    { name: "editor", modules: ["/page.ts"] },
    { name: "shop", modules: ["/shop.ts"] },
  ]);
  expect(file("/canvas.ts", graph)).toBe("editor");
  expect(file("/panels.ts", graph)).toBe("editor-later");
  expect(file("/desk.ts", graph)).toBeNull();
});

test("a part that follows at once and is asked for by a start's name is no later one", () => {
  const graph = graphOf({ "/page.ts": [], "/shop.ts": ["/words.ts"], "/words.ts": [] }, { "/page.ts": ["/shop.ts"] });
  const file = fileByStarts([
    { name: "page", modules: ["/page.ts"] },
    { name: "shop", modules: ["/shop.ts"] },
  ]);
  expect(file("/words.ts", graph)).toBe("shop");
});

test("a start that a bundle does not have takes nothing into its file", () => {
  const file = fileByStarts([{ name: "worker", modules: ["/worker.ts"] }]);
  expect(file("/words.ts", GRAPH)).toBeNull();
});
test("a worker's parts stand in one file by its own start, and another worker's in another", () => {
  const graph = graphOf({ "/worker.ts": ["/words.ts"], "/words.ts": [], "/upright.ts": [], "/help.ts": [] });
  const starts = [
    { name: "other", modules: ["/other.ts", "/help.ts"] },
    { name: "engine", modules: ["/worker.ts", "/upright.ts"] },
  ];
  const file = fileOfWorker(starts);
  expect(["/worker.ts", "/words.ts", "/upright.ts", "/help.ts"].map((id) => file(id, graph))).toEqual([
    ...["engine", "engine", "engine"],
    null,
  ]);
  expect(fileOfWorker([{ name: "other", modules: ["/other.ts", "/help.ts"] }])("/help.ts", graph)).toBeNull();
});

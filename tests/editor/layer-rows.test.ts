import { describe, expect, it } from "vitest";
import { type DesignLayer, makeFillLayer, makeGroupLayer } from "../../web/editor/document/index.ts";
import { dropAt, layerRows, rowsBetween } from "../../web/editor/state/layer-rows.ts";

const fill = (id: string): DesignLayer => makeFillLayer({ id, name: id, color: "#ff0000" });
const group = (id: string, layers: DesignLayer[], fields: Partial<DesignLayer> = {}): DesignLayer =>
  ({ ...makeGroupLayer({ id, name: id, layers }), ...fields }) as DesignLayer;

/** Rows, topmost first: d, g, c, b, a. */
const DESIGN = { layers: [fill("a"), group("g", [fill("b"), fill("c")]), fill("d")] };
const NONE: ReadonlySet<string> = new Set();
const ids = (rows: ReturnType<typeof layerRows>): string[] => rows.map(({ layer }) => layer.id);

describe("rows of the layer list", () => {
  it("are the tree from its top, with depth and place among their own", () => {
    const rows = layerRows(DESIGN, NONE);
    expect(rows.map(({ layer, depth, place, count }) => [layer.id, depth, place, count])).toEqual([
      ["d", 1, 1, 3],
      ["g", 1, 2, 3],
      ["c", 2, 1, 2],
      ["b", 2, 2, 2],
      ["a", 1, 3, 3],
    ]);
    expect(ids(layerRows(DESIGN, new Set(["g"])))).toEqual(["d", "g", "a"]);
  });

  it("know what they take over from the groups above them", () => {
    const rows = layerRows(
      { layers: [group("g", [group("h", [fill("a")], { visible: false })], { locked: true })] },
      NONE,
    );
    const row = rows.find(({ layer }) => layer.id === "a");
    expect(row).toMatchObject({ hiddenAbove: true, lockedAbove: true, parentId: "h" });
  });

  it("are chosen from one to another in either direction", () => {
    const rows = layerRows(DESIGN, NONE);
    expect(rowsBetween(rows, "b", "g")).toEqual(["g", "c", "b"]);
    expect(rowsBetween(rows, "g", "b")).toEqual(["g", "c", "b"]);
    expect(rowsBetween(rows, "gone", "b")).toEqual(["b"]);
  });
});

describe("a drop between rows", () => {
  const rows = layerRows(DESIGN, NONE);

  it("above the first is the top of the list, and below the last its bottom", () => {
    expect(dropAt(rows, 0, 0.1, 1)).toMatchObject({ parentId: null, index: 3, gap: 0 });
    expect(dropAt(rows, 5, 0, 1)).toMatchObject({ parentId: null, index: 0, gap: 5 });
  });

  it("on the middle of a group goes into it, on top", () => {
    expect(dropAt(rows, 1, 0.5, 1)).toMatchObject({ parentId: "g", index: 2, gap: null });
  });

  it("right below an open group's row goes into it", () => {
    expect(dropAt(rows, 1, 0.9, 1)).toMatchObject({ parentId: "g", index: 2, gap: 2, depth: 2 });
  });

  it("between two in a group stays in it, wherever the pointer is across", () => {
    expect(dropAt(rows, 2, 0.9, 1)).toMatchObject({ parentId: "g", index: 1, gap: 3, depth: 2 });
  });

  it("at the end of a group lies in it or below it, by how far in the pointer is", () => {
    expect(dropAt(rows, 3, 0.9, 2)).toMatchObject({ parentId: "g", index: 0, gap: 4, depth: 2 });
    expect(dropAt(rows, 3, 0.9, 1)).toMatchObject({ parentId: null, index: 1, gap: 4, depth: 1 });
  });
});

/** The tree of layers as rows of a list, the topmost first, and what a place between two rows means in the tree. */
import type { Design, DesignLayer } from "../document/index.ts";

export interface LayerRow {
  readonly layer: DesignLayer;
  /** Id of the group that it lies in; null in none. */
  readonly parentId: string | null;
  /** Among the layers that it lies with, from the bottom, as the design counts. */
  readonly index: number;
  /** 1 in no group. */
  readonly depth: number;
  /** Place among the layers that it lies with, from the top, 1 to `count`. */
  readonly place: number;
  readonly count: number;
  /** Of a group: whether rows for its layers follow. */
  readonly expanded: boolean;
  /** It lies in a hidden group. */
  readonly hiddenAbove: boolean;
  /** It lies in a locked group. */
  readonly lockedAbove: boolean;
}

export function layerRows({ layers }: Pick<Design, "layers">, collapsed: ReadonlySet<string>): LayerRow[] {
  const rows: LayerRow[] = [];
  const add = (
    within: readonly DesignLayer[],
    above: Pick<LayerRow, "parentId" | "depth" | "hiddenAbove" | "lockedAbove">,
  ): void => {
    for (let index = within.length - 1; index >= 0; index -= 1) {
      const layer = within[index] as DesignLayer;
      const expanded = layer.type === "group" && !collapsed.has(layer.id);
      rows.push({ layer, index, place: within.length - index, count: within.length, expanded, ...above });
      if (layer.type !== "group" || !expanded) continue;
      add(layer.layers, {
        parentId: layer.id,
        depth: above.depth + 1,
        hiddenAbove: above.hiddenAbove || !layer.visible,
        lockedAbove: above.lockedAbove || layer.locked,
      });
    }
  };
  add(layers, { parentId: null, depth: 1, hiddenAbove: false, lockedAbove: false });
  return rows;
}

/** Where layers that are dragged would go, and how the list shows it. */
export interface LayerDrop {
  readonly parentId: string | null;
  /** From the bottom of the parent's layers, those that are dragged counted too where they lie there. */
  readonly index: number;
  /** A line above the row of this number (the number of rows: below the last); null: into the group itself. */
  readonly gap: number | null;
  /** The line's, or the group's. */
  readonly depth: number;
}

/** Of a group's row, this much at either end means the gap there, and the middle means the group. */
const GAP_SHARE = 0.28;

/**
 * The place under a pointer.
 *
 * @param row The row under the pointer; the number of rows below the last.
 * @param share How far down that row the pointer is, 0 to 1.
 * @param depth Which depth the pointer means by how far in it is: a gap at the end of a group may lie in it or below it.
 */
export function dropAt(rows: readonly LayerRow[], row: number, share: number, depth: number): LayerDrop {
  const under = rows[row];
  if (under?.layer.type === "group" && share > GAP_SHARE && share < 1 - GAP_SHARE) {
    return { parentId: under.layer.id, index: under.layer.layers.length, gap: null, depth: under.depth };
  }
  const gap = Math.min(rows.length, row + (share < 0.5 ? 0 : 1));
  return dropInGap(rows, gap, depth);
}

function dropInGap(rows: readonly LayerRow[], gap: number, wanted: number): LayerDrop {
  const [above, below] = [rows[gap - 1], rows[gap]];
  if (!above) return { parentId: null, index: below ? below.index + 1 : 0, gap, depth: 1 };
  const deepest = above.depth + (above.expanded ? 1 : 0);
  const depth = Math.max(below?.depth ?? 1, Math.min(deepest, wanted));
  if (depth > above.depth) {
    const { layer } = above;
    return { parentId: layer.id, index: layer.type === "group" ? layer.layers.length : 0, gap, depth };
  }
  // The gap is right below the layer of that depth which the row above belongs to.
  let end = gap - 1;
  while ((rows[end]?.depth ?? 0) > depth) end -= 1;
  const { parentId, index } = rows[end] as LayerRow;
  return { parentId, index, gap, depth };
}

/** The rows from one layer to another, both included, whichever is higher. */
export function rowsBetween(rows: readonly LayerRow[], from: string, to: string): string[] {
  const places = [from, to].map((id) => rows.findIndex(({ layer }) => layer.id === id));
  const [first, last] = [Math.min(...places), Math.max(...places)];
  return first < 0 ? [to] : rows.slice(first, last + 1).map(({ layer }) => layer.id);
}

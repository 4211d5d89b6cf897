/** Tells the layer list whether its rows look as they did: a drag changes a layer in each frame, and mostly not its row. */
import { sameItems } from "../../engine/same-items.ts";
import type { DesignLayer } from "../document/index.ts";
import type { LayerRow } from "../state/layer-rows.ts";

export class ShownRows {
  #rows: readonly LayerRow[] = [];
  /** The oldest list that looks as the newest does. */
  #looks: readonly LayerRow[] = [];

  /** The very list of the call before where the rows look the same. */
  of(rows: readonly LayerRow[]): readonly LayerRow[] {
    const before = this.#rows;
    this.#rows = rows;
    const same = rows.length === before.length && rows.every((row, at) => looksSame(row, before[at] as LayerRow));
    if (!same) this.#looks = rows;
    return this.#looks;
  }
}

/** Mostly it is the same layer, which never changes. */
function looksSame(a: LayerRow, b: LayerRow): boolean {
  const isPlaced =
    a.depth === b.depth &&
    a.place === b.place &&
    a.count === b.count &&
    a.hiddenAbove === b.hiddenAbove &&
    a.lockedAbove === b.lockedAbove;
  return isPlaced && (a.layer === b.layer || sameItems(shownOf(a.layer), shownOf(b.layer)));
}

/** What a row reads of its layer: of a decal all but its place, which changes in each frame of a drag. */
function shownOf(layer: DesignLayer): readonly unknown[] {
  const { id, name, visible, locked, opacity, blend, lockAlpha, mask } = layer;
  const own = [id, name, visible, locked, opacity, blend, lockAlpha, mask];
  switch (layer.type) {
    case "decal":
      return [...own, layer.asset];
    case "text":
      return [...own, layer.text, layer.color];
    case "stroke":
      return [...own, layer.brush];
    case "fill":
      return [...own, layer.color, layer.gradient];
    case "paint":
      return [...own, layer.strokes];
    case "group":
      return own;
  }
}

/** Groups that are moved as a whole: their masks go along with the pictures and words in them. */

import { type Design, type DesignLayer, type GroupLayer, isPlaced, type PlacedLayer } from "../document/index.ts";

/** A group, and all pictures and words in it and in its groups. */
export interface WholeGroup {
  readonly group: GroupLayer;
  readonly pictures: readonly PlacedLayer[];
}

interface Held {
  readonly pictures: readonly PlacedLayer[];
  /** All of them are chosen, and none is locked. */
  readonly whole: boolean;
  readonly groups: readonly WholeGroup[];
  /** Around a picture that is chosen by itself: whoever moves that in its group's mask chooses another part of it. */
  readonly frames: readonly WholeGroup[];
}

/**
 * The groups of which all pictures and words are chosen and none is locked: by the group itself or one that it is in, or, where
 * there are several, one by one. They have masks.
 */
export function wholeGroups({ layers }: Pick<Design, "layers">, selection: readonly string[]): readonly WholeGroup[] {
  const chosen = new Set(selection);
  const heldBy = (within: readonly DesignLayer[], isChosen: boolean, isLocked: boolean): Held => {
    const all = within.map((layer): Held => {
      const [held, locked] = [isChosen || chosen.has(layer.id), isLocked || layer.locked];
      if (isPlaced(layer)) {
        return { pictures: [layer], whole: held && !locked, groups: [], frames: [] };
      }
      if (layer.type !== "group") return NONE;
      const { pictures, whole, groups, frames } = heldBy(layer.layers, held, locked);
      const own = layer.mask !== null && whole && pictures.length > 0 ? [{ group: layer, pictures }] : [];
      return held || pictures.length > 1
        ? { pictures, whole, groups: whole ? [...groups, ...frames, ...own] : groups, frames: whole ? [] : frames }
        : { pictures, whole, groups, frames: [...frames, ...own] };
    });
    return {
      pictures: all.flatMap(({ pictures }) => pictures),
      whole: all.every(({ whole }) => whole),
      groups: all.flatMap(({ groups }) => groups),
      frames: all.flatMap(({ frames }) => frames),
    };
  };
  return heldBy(layers, false, false).groups;
}

const NONE: Held = { pictures: [], whole: true, groups: [], frames: [] };

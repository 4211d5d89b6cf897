/** Parts of masks that cannot go where their layers go, which is said: what they hide would else be seen without a word. */

import {
  type DesignLayer,
  flattenLayers,
  isPlaced,
  type Mask,
  type MaskLayer,
  type PlacedLayer,
} from "../document/index.ts";
import { leftBehind } from "./carried-mask.ts";
import type { NoticeBoard } from "./notice-board.ts";

/** The pictures and words that a layer is, or a group holds. */
export const picturesIn = (layer: DesignLayer): readonly PlacedLayer[] =>
  flattenLayers({ layers: [layer] }, { masks: false, strokes: false }).filter(isPlaced);

/** What stays of a layer's mask though that is linked to it. */
export const staysOf = (
  { mask }: { readonly mask: Mask | null },
  pictures: readonly PlacedLayer[],
): readonly MaskLayer[] => (mask?.linked ? leftBehind(mask, pictures) : []);

export class LeftMasks {
  /** What has been told, once for each as it is: whoever goes on moving the layer knows. */
  readonly #told = new WeakSet<MaskLayer>();

  /** Some layers were moved, turned or sized. */
  tell(moved: readonly (readonly [layer: DesignLayer, pictures: readonly PlacedLayer[]])[], board: NoticeBoard): void {
    for (const [layer, pictures] of moved) {
      const stays = staysOf(layer, pictures);
      if (stays.every((each) => this.#told.has(each))) continue;
      for (const each of stays) this.#told.add(each);
      const { maskLeft, maskLeftWhy } = board.strings.notices;
      board.info({ title: maskLeft(layer.name), message: maskLeftWhy });
    }
  }
}

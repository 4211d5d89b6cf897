/** What a picture that is dragged comes into line with: the middles of the model, and the pictures that stay where they are. */
import type { ModelInfo, UvProjector } from "../../engine/engine-api.ts";
import type { Surroundings } from "../../viewer/viewer-api.ts";
import { type Design, isPlaced, type PlacedLayer } from "../document/index.ts";
import { walkLayers } from "../document/layer-tree.ts";
import { middlesOf } from "../tools/model-middles.ts";
import { stampsIn } from "./stamps-together.ts";

/** A design in the midst of a drag, and the layers that go with it. */
export interface Dragged {
  readonly design: Design;
  readonly moved: ReadonlySet<string>;
}

export function surroundingsOf(dragged: Dragged, info: Pick<ModelInfo, "boundsMin" | "boundsMax">): Surroundings {
  const boxes = stayingOf(dragged).flatMap(({ projector }) => (projector.kind === "planar" ? [projector] : []));
  return { middles: middlesOf(info), boxes };
}

/** @param material in whose texture they lie */
export function stampsBeside(dragged: Dragged, material: number | null): readonly UvProjector[] {
  return stampsIn(stayingOf(dragged), material).map(({ projector }) => projector);
}

/** What is seen of the others, locked or not. */
function stayingOf({ design, moved }: Dragged): PlacedLayer[] {
  return [...walkLayers(design, { masks: false, strokes: false })].flatMap(({ layer, shown }) =>
    shown && isPlaced(layer) && !moved.has(layer.id) ? [layer] : [],
  );
}

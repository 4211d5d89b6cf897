/** What a picture that is dragged comes into line with: the middles of the model, and the pictures that stay where they are. */
import type { ModelInfo, UvProjector, Vec3 } from "../../engine/engine-api.ts";
import type { ModelMiddle, Surroundings } from "../../viewer/viewer-api.ts";
import { type Design, isPlaced, type PlacedLayer } from "../document/index.ts";
import { walkLayers } from "../document/layer-tree.ts";
import { mirrorOf } from "../tools/mirror-setting.ts";
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

/** The model's own planes of symmetry: where a mirror would stand. */
export function middlesOf(info: Pick<ModelInfo, "boundsMin" | "boundsMax">): ModelMiddle[] {
  return (["x", "y", "z"] as const).flatMap((axis) => {
    const mirror = mirrorOf(axis, info);
    const along = (length: number): Vec3 => [
      axis === "x" ? length : 0,
      axis === "y" ? length : 0,
      axis === "z" ? length : 0,
    ];
    return mirror ? [{ point: along(mirror.offset), normal: along(1) }] : [];
  });
}

/** What is seen of the others, locked or not. */
function stayingOf({ design, moved }: Dragged): PlacedLayer[] {
  return [...walkLayers(design, { masks: false, strokes: false })].flatMap(({ layer, shown }) =>
    shown && isPlaced(layer) && !moved.has(layer.id) ? [layer] : [],
  );
}

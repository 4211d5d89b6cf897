/** Drags of any projector as the gizmo handles them, and a box's. */
import type { Projector } from "../engine/engine-api.ts";
import { type DecalPose, poseOf, projectorOf, type SurfacePoint } from "./decal-pose.ts";
import type { DragPointer, GizmoDrag } from "./gizmo-drag.ts";

export interface ProjectorDrag {
  readonly kind: GizmoDrag["kind"];
  /** The projector at this place of the pointer; null where it says nothing. */
  move(pointer: DragPointer): Projector | null;
  /** glTF material of the surface that the decal was dragged onto; null while that is unknown. */
  readonly material: number | null;
  readout(projector: Projector): string | null;
}

/** What was grabbed: a place on the surface, with its texture coordinates where it has any. */
export type PictureGrab = SurfacePoint & { readonly uv?: readonly [number, number] };

export function boxDrag(drag: GizmoDrag): ProjectorDrag {
  const posed = (pose: DecalPose | null): Projector | null => pose && projectorOf(pose);
  return {
    kind: drag.kind,
    get material() {
      return drag.material;
    },
    move: (pointer) => posed(drag.move(pointer)),
    readout: (projector) => (projector.kind === "planar" ? drag.readout(poseOf(projector)) : null),
  };
}

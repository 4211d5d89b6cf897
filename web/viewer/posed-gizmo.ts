/** The gizmo of a decal on a posed model: drawn where the pose has brought it, dragged as at rest. */
import { type Matrix4, Quaternion, Vector3 } from "three";
import type { Projector, UvProjector } from "../engine/engine-api.ts";
import type { ProjectorDrag } from "./box-drag.ts";
import { tupleOf } from "./decal-pose.ts";
import type { DragPointer } from "./gizmo-drag.ts";

/** A projector where a rigid motion of model space has brought it. */
export function carried<P extends Exclude<Projector, UvProjector>>(projector: P, motion: Matrix4): P {
  const turn = new Quaternion().setFromRotationMatrix(motion);
  const { x, y, z, w } = turn.multiply(new Quaternion(...projector.rotation)).normalize();
  const position = new Vector3(...projector.position).applyMatrix4(motion);
  return { ...projector, position: tupleOf(position), rotation: [x, y, z, w] };
}

/** The pointer as it passes by the resting model. `motion`: from rest to the pose. */
export function pointerAtRest<P extends DragPointer>(pointer: P, motion: Matrix4): P {
  return { ...pointer, ray: pointer.ray.clone().applyMatrix4(motion.clone().invert()) };
}

/** A drag of the resting projector by a pointer over the posed one. The motion is that of the drag's beginning. */
export function dragAtRest(drag: ProjectorDrag, motion: Matrix4): ProjectorDrag {
  return {
    kind: drag.kind,
    get material() {
      return drag.material;
    },
    move: (pointer) => drag.move(pointerAtRest(pointer, motion)),
    readout: (projector) => drag.readout(projector),
  };
}

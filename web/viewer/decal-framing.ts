/** Where the camera goes to see one decal. */
import { axisOf, type DecalPose } from "./decal-pose.ts";
import type { Stage } from "./stage.ts";

/** How much farther than a tight fit the camera stands. */
const DECAL_ROOM = 2.2;

/** Looks straight at a decal. */
export function frameDecal(stage: Stage, pose: DecalPose): void {
  const half = Math.max(pose.size.x, pose.size.y) / 2;
  const eye = pose.position.clone().addScaledVector(axisOf(pose, 2), distanceFor(stage, half * DECAL_ROOM));
  stage.rig.lookAt(eye, pose.position, stage.animates);
  stage.requestFrame();
}

/** How far away a sphere of this radius fills the view's shorter side. */
function distanceFor(stage: Stage, radius: number): number {
  const vertical = (stage.camera.fov * Math.PI) / 360;
  const horizontal = Math.atan(Math.tan(vertical) * Math.max(stage.camera.aspect, 0.2));
  return radius / Math.sin(Math.min(vertical, horizontal));
}

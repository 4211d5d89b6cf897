/** Where the camera goes to see the whole model. */
import { Box3, type PerspectiveCamera, Vector3 } from "three";
import type { Stage } from "./stage.ts";

/** From the front, a little from the side and above: shapes read better than straight on. */
export const MODEL_AZIMUTH = 0.42;
export const MODEL_POLAR = 1.25;
/** How much farther than a tight fit the camera stands. */
const MODEL_ROOM = 1.24;

/** Shows all of a model of these vertices; `eased` false puts the camera there at once. */
export function frameModel(stage: Stage, positions: Float32Array, eased: boolean): void {
  const { eye, target } = framedEye(stage.camera, positions, MODEL_AZIMUTH, MODEL_POLAR);
  stage.rig.lookAt(eye, target, eased && stage.animates);
  stage.requestFrame();
}

/** Where a camera stands that sees all of a model from a direction (radians: about the vertical, down from it), and looks at. */
export function framedEye(
  camera: PerspectiveCamera,
  positions: Float32Array,
  azimuth: number,
  polar: number,
): { readonly eye: Vector3; readonly target: Vector3; readonly distance: number } {
  const towardsEye = new Vector3().setFromSphericalCoords(1, polar, azimuth);
  const bounds = boundsOf(positions);
  const target = bounds.getCenter(new Vector3());
  const least = bounds.getSize(new Vector3()).length() * 0.05;
  const distance = MODEL_ROOM * Math.max(least, distanceForVertices(camera, positions, target, towardsEye));
  return { eye: target.clone().addScaledVector(towardsEye, distance), target, distance };
}

/** Bounds of a resting surface's vertices, metres. */
export function boundsOf(positions: Float32Array): Box3 {
  return new Box3().setFromArray(positions as unknown as number[]);
}

/** How far from `target` all vertices are in view. */
function distanceForVertices(
  camera: PerspectiveCamera,
  positions: Float32Array,
  target: Vector3,
  towardsEye: Vector3,
): number {
  const vertical = Math.tan((camera.fov * Math.PI) / 360);
  const horizontal = vertical * Math.max(camera.aspect, 0.2);
  const right = new Vector3(0, 1, 0).cross(towardsEye).normalize();
  const up = towardsEye.clone().cross(right);
  let distance = 0;
  // All of them: a board's four corners may stand among very many vertices. A million take 25 ms, in plain numbers.
  for (let at = 0; at < positions.length; at += 3) {
    const x = (positions[at] as number) - target.x;
    const y = (positions[at + 1] as number) - target.y;
    const z = (positions[at + 2] as number) - target.z;
    const across = Math.abs(x * right.x + y * right.y + z * right.z) / horizontal;
    const upwards = Math.abs(x * up.x + y * up.y + z * up.z) / vertical;
    distance = Math.max(distance, Math.max(across, upwards) + x * towardsEye.x + y * towardsEye.y + z * towardsEye.z);
  }
  return distance;
}

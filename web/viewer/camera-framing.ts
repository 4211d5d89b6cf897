/** Where the camera goes: the whole model, one decal, and steps of the keyboard. */
import { Box3, type PerspectiveCamera, Vector3 } from "three";
import { axisOf, type DecalPose } from "./decal-pose.ts";
import type { Stage } from "./stage.ts";

/** From the front, a little from the side and above: shapes read better than straight on. */
export const MODEL_AZIMUTH = 0.42;
export const MODEL_POLAR = 1.25;
/** How much farther than a tight fit the camera stands. */
const MODEL_ROOM = 1.24;
const DECAL_ROOM = 2.2;
/** Of larger models some vertices are left out. */
const MOST_FRAMED_VERTICES = 20_000;

/** Shows all of a model of these vertices; `eased` false puts the camera there at once. */
export function frameModel(stage: Stage, positions: Float32Array, eased: boolean): void {
  const { controls } = stage;
  const { eye, target } = framedEye(stage.camera, positions, MODEL_AZIMUTH, MODEL_POLAR);
  controls.normalizeRotations();
  controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, eased && stage.animates);
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

/** Looks straight at a decal. */
export function frameDecal(stage: Stage, pose: DecalPose): void {
  const half = Math.max(pose.size.x, pose.size.y) / 2;
  const eye = pose.position.clone().addScaledVector(axisOf(pose, 2), distanceFor(stage, half * DECAL_ROOM));
  stage.controls.normalizeRotations();
  stage.controls.setLookAt(eye.x, eye.y, eye.z, ...pose.position.toArray(), stage.animates);
  stage.requestFrame();
}

/** Arrow keys turn, plus and minus dolly. Returns whether the key meant something. */
export function stepCamera(stage: Stage, key: string): boolean {
  const { controls } = stage;
  const turn = Math.PI / 24;
  const steps: Record<string, () => void> = {
    ArrowLeft: () => controls.rotate(-turn, 0, stage.animates),
    ArrowRight: () => controls.rotate(turn, 0, stage.animates),
    ArrowUp: () => controls.rotate(0, -turn, stage.animates),
    ArrowDown: () => controls.rotate(0, turn, stage.animates),
    "+": () => controls.dolly(controls.distance * 0.15, stage.animates),
    "=": () => controls.dolly(controls.distance * 0.15, stage.animates),
    "-": () => controls.dolly(-controls.distance * 0.15, stage.animates),
  };
  const step = steps[key];
  step?.();
  stage.requestFrame();
  return step !== undefined;
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
  const stride = 3 * Math.ceil(positions.length / 3 / MOST_FRAMED_VERTICES);
  const vertex = new Vector3();
  let distance = 0;
  for (let at = 0; at < positions.length; at += stride) {
    vertex.fromArray(positions, at).sub(target);
    const away = Math.max(Math.abs(vertex.dot(right)) / horizontal, Math.abs(vertex.dot(up)) / vertical);
    distance = Math.max(distance, away + vertex.dot(towardsEye));
  }
  return distance;
}

/** How far away a sphere of this radius fills the view's shorter side. */
function distanceFor(stage: Stage, radius: number): number {
  const vertical = (stage.camera.fov * Math.PI) / 360;
  const horizontal = Math.atan(Math.tan(vertical) * Math.max(stage.camera.aspect, 0.2));
  return radius / Math.sin(Math.min(vertical, horizontal));
}

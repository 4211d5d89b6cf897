/**
 * Sliding a decal along a surface: the grabbed point stays under the pointer, the box turns with the surface.
 *
 * The box is carried by a frame that stands on the surface. The frame is moved by parallel transport (the shortest
 * turn from one normal to the next, so it never spins by itself) and drawn towards upright wherever the surface is
 * steep enough for that word to have a meaning. Transport alone would leave a decal askew after a round trip over a
 * curved body; an upright frame alone flips at the poles.
 */
import { Quaternion, Vector3 } from "three";
import {
  type DecalPose,
  minimalRotation,
  type SurfacePoint,
  toLocal,
  uprightFrame,
  uprightness,
  wrapAngle,
} from "./decal-pose.ts";

/** Below the first slope (sine of the angle to vertical) the frame is free, above the second it stands upright. */
const FREE_BELOW = 0.2;
const UPRIGHT_ABOVE = 0.55;

/** One drag of one decal. `step` may be called with any surface points, in the order in which the pointer meets them. */
export class DecalSlide {
  readonly #start: DecalPose;
  readonly #grabLocal: Vector3;
  readonly #relative: Quaternion;
  #frame: Quaternion;
  #normal: Vector3;
  /** Turn of the frame against upright that the drag keeps; null until the surface has an upright. */
  #roll: number | null;

  /** @param grab where the pointer took hold of the decal, with the (smoothed) normal there. */
  constructor(pose: DecalPose, grab: SurfacePoint) {
    this.#start = pose;
    this.#grabLocal = toLocal(pose, grab.position);
    this.#normal = grab.normal.clone();
    const upright = uprightness(grab.normal) > FREE_BELOW ? uprightFrame(grab.normal) : null;
    this.#frame = upright ?? minimalRotation(new Vector3(0, 0, 1), grab.normal);
    this.#roll = upright === null ? null : 0;
    this.#relative = this.#frame.clone().invert().multiply(pose.rotation);
  }

  /** The pose that puts the grabbed point onto `target`. */
  step(target: SurfacePoint): DecalPose {
    this.#frame = minimalRotation(this.#normal, target.normal).multiply(this.#frame).normalize();
    this.#normal = target.normal.clone();
    this.#standUpright();
    const rotation = this.#frame.clone().multiply(this.#relative).normalize();
    const position = target.position.clone().sub(this.#grabLocal.clone().applyQuaternion(rotation));
    return { position, rotation, size: this.#start.size.clone() };
  }

  #standUpright(): void {
    const pull = smoothstep(FREE_BELOW, UPRIGHT_ABOVE, uprightness(this.#normal));
    const upright = pull > 0 ? uprightFrame(this.#normal) : null;
    if (upright === null) {
      return;
    }
    const relative = upright.invert().multiply(this.#frame);
    const roll = 2 * Math.atan2(relative.z, relative.w);
    this.#roll ??= roll;
    const correction = pull * wrapAngle(this.#roll - roll);
    this.#frame.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), correction)).normalize();
  }
}

function smoothstep(low: number, high: number, value: number): number {
  const t = Math.min(1, Math.max(0, (value - low) / (high - low)));
  return t * t * (3 - 2 * t);
}

/** What a page says about the camera: where it begins, how far it may go, and pictures from places of the page's choice. */
import { MathUtils, PerspectiveCamera, Vector3 } from "three";
import { framedEye, MODEL_AZIMUTH, MODEL_POLAR } from "./camera-framing.ts";
import { ANY_ORBIT, type Orbit } from "./camera-orbit.ts";
import type { CameraStand } from "./camera-rig.ts";
import { lensFor } from "./capture.ts";
import type { Stage } from "./stage.ts";

/** Straight from above has no upright. */
const LEAST_POLAR = 0.01;

export interface CameraLimits {
  readonly min: Orbit;
  readonly max: Orbit;
}

export class ModelCamera {
  readonly #stage: Stage;
  #positions: Float32Array | null = null;

  constructor(stage: Stage) {
    this.#stage = stage;
  }

  /** The resting surface's vertices, by which distances are measured. A new model has no limits yet. */
  setModel(positions: Float32Array | null): void {
    this.#positions = positions;
    if (positions !== null) this.setLimits({ min: ANY_ORBIT, max: ANY_ORBIT });
  }

  setLimits({ min, max }: CameraLimits): void {
    const angle = (degrees: number | null, otherwise: number): number =>
      degrees === null ? otherwise : MathUtils.degToRad(degrees);
    const { radius } = this.#stage.bounds;
    this.#stage.rig.limit({
      minAzimuthAngle: angle(min.theta, Number.NEGATIVE_INFINITY),
      maxAzimuthAngle: angle(max.theta, Number.POSITIVE_INFINITY),
      minPolarAngle: clampPolar(angle(min.phi, 0)),
      maxPolarAngle: clampPolar(angle(max.phi, Math.PI)),
      minDistance: this.#metres(min) ?? radius * 0.05,
      maxDistance: this.#metres(max) ?? radius * 12,
    });
    this.#stage.requestFrame();
  }

  /** Goes there at once; what an orbit does not say is as in the usual first look. */
  moveTo(place: Orbit | CameraStand): void {
    if (this.#positions === null) return;
    const { eye, target } = "eye" in place ? place : this.#eyeAt(this.#stage.camera, place, this.#positions);
    this.#stage.rig.lookAt(eye, target, false);
    this.#stage.requestFrame();
  }

  /** A picture from an orbit, or (null) as the view is now. PNG on a clear ground; null without a model. */
  async capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null> {
    if (this.#positions === null) return null;
    const camera = new PerspectiveCamera();
    const aspect = width / height;
    let side = 0;
    if (orbit === null) {
      camera.copy(this.#stage.camera);
      side = sideSeen(camera, this.#positions);
    }
    // A view that is taller than wide shows more above and below, and one that is wider more of the product at its sides: so does
    // its picture.
    camera.fov = lensFor(Math.min(camera.aspect, aspect / Math.max(1, side * camera.aspect)));
    camera.aspect = aspect;
    if (orbit !== null) {
      const { eye, target } = this.#eyeAt(camera, orbit, this.#positions);
      camera.position.copy(eye);
      camera.lookAt(target);
      camera.layers.mask = this.#stage.camera.layers.mask;
    }
    return await this.#stage.capture(camera, width, height);
  }

  #eyeAt(camera: PerspectiveCamera, { theta, phi, distance }: Orbit, positions: Float32Array) {
    const azimuth = theta === null ? MODEL_AZIMUTH : MathUtils.degToRad(theta);
    const polar = phi === null ? MODEL_POLAR : clampPolar(MathUtils.degToRad(phi));
    const framed = framedEye(camera, positions, azimuth, polar);
    const asked = distance === null ? 1 : distance.unit === "m" ? distance.value / framed.distance : distance.value;
    return { eye: framed.target.clone().lerp(framed.eye, asked), target: framed.target };
  }

  #metres({ distance }: Orbit): number | null {
    if (distance === null || this.#positions === null) return null;
    if (distance.unit === "m") return distance.value;
    return distance.value * framedEye(this.#stage.camera, this.#positions, MODEL_AZIMUTH, MODEL_POLAR).distance;
  }
}

/** How far from its middle a view shows the points, of half its width. */
function sideSeen(view: PerspectiveCamera, positions: Float32Array): number {
  const point = new Vector3();
  let side = 0;
  for (let at = 0; at < positions.length; at += 3) {
    // Of one beside the very eye it is no number.
    side = Math.max(side, Math.abs(point.fromArray(positions, at).project(view).x) || 0);
  }
  return Math.min(side, 1);
}

const clampPolar = (angle: number): number => Math.min(Math.PI - LEAST_POLAR, Math.max(LEAST_POLAR, angle));

/** What holds the view's camera: nothing but a place at first, and the controls once a hand may come. */
import { type Box3, type PerspectiveCamera, Vector3 } from "three";

/** How far the camera may go: radians about the vertical and down from it, and metres. */
export interface CameraReach {
  readonly minAzimuthAngle: number;
  readonly maxAzimuthAngle: number;
  readonly minPolarAngle: number;
  readonly maxPolarAngle: number;
  readonly minDistance: number;
  readonly maxDistance: number;
}

/** A camera's place, metres. */
export interface CameraStand {
  readonly eye: Vector3;
  /** What it looks at and turns about. */
  readonly target: Vector3;
}

export interface CameraRig {
  /** Where it is or goes to. */
  readonly stand: CameraStand;
  /** Limits what hands do from now on; what is not given stays. */
  limit(reach: Partial<CameraReach>): void;
  /** Keeps what is looked at inside a box. */
  enclose(box: Box3): void;
  /** Goes there, at once or `eased`. */
  lookAt(eye: Vector3, target: Vector3, eased: boolean): void;
  /** Whether movements may be animated. */
  setEased(eased: boolean): void;
  /** Brings the camera to its place after `delta` seconds. Returns whether it moved. */
  update(delta: number): boolean;
  dispose(): void;
}

/** What is about to bring the model nearer or farther. */
export interface ZoomStep {
  /** Metres: what is seen under the pointer, or in the middle of the view where nothing is; null: the model in neither. */
  readonly surface: Vector3 | null;
  /** What is under the pointer stays there; else the middle of the view does. */
  readonly toPointer: boolean;
  /** Or it may, as fingers that have not moved yet. */
  readonly nearer: boolean;
}

/** A rig that hands can reach. */
export interface HeldRig extends CameraRig {
  /** Whether the left button pans instead of turning, from its next press on. */
  setPanning(pans: boolean): void;
  /** A wheel is about to turn, or two fingers to pinch. */
  beforeZoom(step: ZoomStep): void;
  /** Arrow keys turn, plus and minus dolly. Returns whether the key meant something. */
  step(key: string, eased: boolean): boolean;
}

/** Holds the camera still, and keeps what it was told for the rig that comes after it. */
export class StillRig implements CameraRig {
  readonly #camera: PerspectiveCamera;
  #moved = false;
  reach: Partial<CameraReach> = {};
  box: Box3 | null = null;
  readonly stand = { eye: new Vector3(0, 0, 1), target: new Vector3() };

  constructor(camera: PerspectiveCamera) {
    this.#camera = camera;
  }

  limit(reach: Partial<CameraReach>): void {
    this.reach = { ...this.reach, ...reach };
  }

  enclose(box: Box3): void {
    this.box = box;
  }

  lookAt(eye: Vector3, target: Vector3): void {
    this.stand.eye.copy(eye);
    this.stand.target.copy(target);
    this.#moved = true;
  }

  setEased(): void {}

  update(): boolean {
    const moved = this.#moved;
    this.#moved = false;
    if (moved) {
      this.#camera.position.copy(this.stand.eye);
      this.#camera.lookAt(this.stand.target);
    }
    return moved;
  }

  dispose(): void {}
}

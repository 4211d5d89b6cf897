/** camera-controls that follow each move, and whose orbit can have its middle nearer or farther along the view, without the picture moving. */
import CameraControls from "camera-controls";
import { Vector3 } from "three";

export class DepthControls extends CameraControls {
  constructor(...args: ConstructorParameters<typeof CameraControls>) {
    super(...args);
    // Theirs take one move a frame, and give up those after it when the finger is lifted. A slow GPU has a swipe begin and end between
    // two frames.
    const takeNext = (): void => {
      this._dragNeedsUpdate = true;
    };
    this.addEventListener("controlstart", takeNext);
    this.addEventListener("control", takeNext);
  }

  /** Metres from the camera as it is seen now, which may still be on its way, to the middle of its orbit. */
  get depth(): number {
    return this._spherical.radius;
  }

  /** Metres along the view from the camera as it is seen now. */
  depthOf(point: Vector3): number {
    return this.depth - point.clone().sub(this._target).dot(this.#back());
  }

  /** Unit vector from what is looked at to the camera. */
  #back(): Vector3 {
    return new Vector3().setFromSpherical(this._spherical).normalize();
  }

  /**
   * Lays the middle of the orbit `depth` metres before the camera. What it is on its way to is then as far from the old middle as it
   * was, but not beyond the new one: the camera comes to rest at `minDistance` before it.
   */
  setDepth(depth: number): void {
    const nearer = this._spherical.radius - depth;
    this._target.addScaledVector(this.#back(), nearer);
    const end = new Vector3().setFromSpherical(this._sphericalEnd).normalize();
    this._targetEnd.addScaledVector(end, nearer);
    const rest = Math.max(this._sphericalEnd.radius - nearer, this.minDistance);
    this._changedDolly += rest - (this._sphericalEnd.radius - nearer);
    this._spherical.radius = depth;
    this._sphericalEnd.radius = rest;
    this._lastDistance -= nearer;
    this._needsUpdate = true;
  }
}

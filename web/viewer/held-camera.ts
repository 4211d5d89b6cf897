/** The camera in the user's hands: orbit, pan and zoom by camera-controls, from where the camera stands. */
import CameraControls from "camera-controls";
import {
  Box3,
  Matrix4,
  type PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import type { CameraReach, CameraStand, HeldRig, StillRig, ZoomStep } from "./camera-rig.ts";
import { DepthControls } from "./depth-controls.ts";

CameraControls.install({
  THREE: { Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster },
});

/**
 * Dolly speeds of camera-controls: its own, and the one by which a trackpad's pinch, a wheel with Ctrl, brings the model nearer by as
 * much as the fingers part: 100 of the wheel are an e-fold pinch, and by that the distance is to become 0.95 ^ (100 / a step's units * speed).
 */
const OWN_SPEED = 1;
const PINCH_SPEED = (/Mac/.test(navigator.platform) ? 1 : 3) / (-100 * Math.log(0.95));

/** Of the way to the model's middle: who is that far from what was looked at closely sees the model again, and turns it about its middle. */
const FAR = 0.7;
const SAME = 1 - 1e-6;

export class HeldCamera implements HeldRig {
  readonly controls: DepthControls;
  readonly #abort = new AbortController();
  /** Of what is shown. */
  readonly #middle = new Vector3();

  /** @param before what it takes over from @param requestFrame asks for `update` */
  constructor(camera: PerspectiveCamera, root: HTMLElement, before: StillRig, requestFrame: () => void) {
    const { ACTION } = CameraControls;
    // Before the controls listen.
    const early = { capture: true, passive: true, signal: this.#abort.signal };
    root.addEventListener("wheel", ({ ctrlKey }) => this.#setSpeed(ctrlKey ? PINCH_SPEED : OWN_SPEED), early);
    const press = (): void => {
      this.#setSpeed(OWN_SPEED);
      this.#lookToMiddle();
    };
    root.addEventListener("pointerdown", press, early);
    const controls = new DepthControls(camera, root);
    this.controls = controls;
    controls.mouseButtons.left = ACTION.ROTATE;
    controls.mouseButtons.middle = ACTION.ROTATE;
    controls.mouseButtons.right = ACTION.TRUCK;
    controls.mouseButtons.wheel = ACTION.DOLLY;
    controls.touches.one = ACTION.TOUCH_ROTATE;
    controls.touches.two = ACTION.TOUCH_DOLLY_TRUCK;
    // Three fingers undo and redo.
    controls.touches.three = ACTION.NONE;
    controls.dollyToCursor = true;
    this.limit({ minPolarAngle: 0.01, maxPolarAngle: Math.PI - 0.01, ...before.reach });
    this.lookAt(before.stand.eye, before.stand.target, false);
    if (before.box !== null) this.enclose(before.box);
    for (const type of ["controlstart", "control", "transitionstart"] as const) {
      controls.addEventListener(type, requestFrame);
    }
  }

  get stand(): CameraStand {
    return { eye: this.controls.getPosition(new Vector3()), target: this.controls.getTarget(new Vector3()) };
  }

  limit(reach: Partial<CameraReach>): void {
    Object.assign(this.controls, reach);
  }

  enclose(box: Box3): void {
    box.getCenter(this.#middle);
    this.controls.setBoundary(box);
  }

  lookAt(eye: Vector3, target: Vector3, eased: boolean): void {
    this.controls.normalizeRotations();
    this.controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, eased);
  }

  /** What brings it back to where it goes now. */
  keep(): () => void {
    const { eye, target } = this.stand;
    return () => this.lookAt(eye, target, false);
  }

  /** Goes round by itself, radians, unless a hand is on the view. */
  turn(angle: number): void {
    if (this.controls.currentAction === CameraControls.ACTION.NONE) this.controls.azimuthAngle += angle;
  }

  setEased(eased: boolean): void {
    this.controls.smoothTime = eased ? 0.16 : 0;
    this.controls.draggingSmoothTime = eased ? 0.06 : 0;
  }

  setPanning(pans: boolean): void {
    this.controls.mouseButtons.left = pans ? CameraControls.ACTION.TRUCK : CameraControls.ACTION.ROTATE;
  }

  beforeZoom({ surface, toPointer, nearer }: ZoomStep): void {
    const { controls } = this;
    controls.dollyToCursor = toPointer;
    if (!nearer) this.#lookToMiddle();
    else if (surface !== null) {
      // Steps are shares of the way to the middle of the orbit: to that of a mug they would lead through its wall.
      const depth = controls.depthOf(surface);
      if (depth > 0 && depth < controls.depth) controls.setDepth(depth);
    }
  }

  /** What is as far away again turns about its own middle. */
  #lookToMiddle(): void {
    const { controls } = this;
    const middle = controls.depthOf(this.#middle);
    // Where it does so already, nothing is to move by a last bit.
    if (controls.depth < SAME * middle && controls.depth > FAR * middle) controls.setDepth(middle);
  }

  /** Whether two fingers orbit and zoom, since one is a tool's; else they pan and zoom, and one orbits. */
  setTwoFingersOrbit(orbit: boolean): void {
    const { ACTION } = CameraControls;
    this.controls.touches.two = orbit ? ACTION.TOUCH_DOLLY_ROTATE : ACTION.TOUCH_DOLLY_TRUCK;
  }

  step(key: string, eased: boolean): boolean {
    const { controls } = this;
    const turn = Math.PI / 24;
    const steps: Record<string, () => void> = {
      ArrowLeft: () => controls.rotate(-turn, 0, eased),
      ArrowRight: () => controls.rotate(turn, 0, eased),
      ArrowUp: () => controls.rotate(0, -turn, eased),
      ArrowDown: () => controls.rotate(0, turn, eased),
      "+": () => controls.dolly(controls.distance * 0.15, eased),
      "=": () => controls.dolly(controls.distance * 0.15, eased),
      "-": () => controls.dolly(-controls.distance * 0.15, eased),
    };
    const step = steps[key];
    step?.();
    return step !== undefined;
  }

  update(delta: number): boolean {
    return this.controls.update(delta);
  }

  dispose(): void {
    this.#abort.abort();
    this.controls.dispose();
  }

  #setSpeed(speed: number): void {
    this.controls.dollySpeed = speed;
  }
}

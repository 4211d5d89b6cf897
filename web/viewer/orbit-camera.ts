/**
 * The camera in a customer's hands, by three's own OrbitControls, from where it stands. They move a camera that nobody sees, the
 * goal; the view's follows it with a little inertia, and goes by itself in the same way. The editor's, with more ways to move,
 * is `HeldCamera`.
 */
import { type Box3, MathUtils, MOUSE, type PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { CameraReach, CameraStand, HeldRig, StillRig, ZoomStep } from "./camera-rig.ts";

/** How fast the view follows, of the way in a second: after a hand, and where it goes by itself. */
const HAND_PACE = 30;
const OWN_PACE = 10;
const KEY_TURN = Math.PI / 24;
const KEY_ZOOM = 0.15;
/** Of a trackpad's pinch, 100 a wheel with Ctrl where it is e-fold: the distance becomes 0.95 ^ (10 * speed), and that is to be 1 / e. */
const PINCH_SPEED = -0.1 / Math.log(0.95);
/** Straight from above has no upright. */
const LEAST_POLAR = 0.01;
/** Of the way to the model's middle: who is that far from what was looked at closely sees the model again, and turns it about its middle. */
const FAR = 0.7;
const SAME = 1 - 1e-6;
/** Of the box's diagonal: how near the camera comes to what is seen. A twentieth of the model's radius, which the box has about it. */
const CLOSE = 0.01;

/** Tells of each movement, however small: the controls' own "change" leaves out what is below a millimetre. */
class TellingControls extends OrbitControls {
  told?: () => void;

  override update(delta?: number | null): boolean {
    const changed = super.update(delta);
    this.told?.();
    return changed;
  }
}

/** Where a camera is about what it looks at: radians and metres; `theta` counts whole turns. */
interface Place {
  readonly about: Spherical;
  readonly target: Vector3;
}

export class OrbitCamera implements HeldRig {
  readonly #camera: PerspectiveCamera;
  readonly #goalCamera: PerspectiveCamera;
  readonly #controls: TellingControls;
  readonly #requestFrame: () => void;
  readonly #abort = new AbortController();
  readonly #shown: Place = { about: new Spherical(), target: new Vector3() };
  readonly #goal: Place = { about: new Spherical(), target: new Vector3() };
  #box: Box3 | null = null;
  /** From the model's middle, metres; what the controls are told is from what is looked at. */
  #least = 0;
  #eased = true;
  #pace = HAND_PACE;
  #jumped = true;
  /** Nothing has moved since it took over: the camera stands as it stood, to the last bit. Angles would round that. */
  #isUntouched = false;
  #zoomToPointer = true;
  /** A pointer is down on the view. */
  #held = false;

  /** @param before what it takes over from @param requestFrame asks for `update` */
  constructor(camera: PerspectiveCamera, root: HTMLElement, before: StillRig, requestFrame: () => void) {
    this.#camera = camera;
    this.#goalCamera = camera.clone();
    this.#requestFrame = requestFrame;
    const { signal } = this.#abort;
    // Before the controls listen: a wheel's step is larger than they think, and of fingers on a page that was scrolled they
    // mistake the place.
    const wheelSpeed = /Mac/.test(navigator.platform) ? 10 : 10 / 3;
    root.addEventListener(
      "wheel",
      ({ ctrlKey }) => {
        const zoomSpeed = ctrlKey ? PINCH_SPEED : wheelSpeed;
        Object.assign(this.#controls, { zoomSpeed, zoomToCursor: this.#zoomToPointer });
      },
      { signal, passive: true },
    );
    root.addEventListener(
      "pointerdown",
      () => {
        Object.assign(this.#controls, { zoomSpeed: 1, zoomToCursor: false });
        this.#held = true;
      },
      { signal },
    );
    // And before a second finger, which looks to what is under it.
    root.addEventListener("pointerdown", () => this.#lookToMiddle(), { signal, capture: true });
    const controls = new TellingControls(this.#goalCamera, root);
    this.#controls = controls;
    Object.assign(controls.mouseButtons, { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.ROTATE, RIGHT: MOUSE.PAN });
    controls.addEventListener("start", () => this.#start());
    controls.addEventListener("end", () => {
      this.#held = false;
    });
    this.#box = before.box;
    this.limit({ minPolarAngle: LEAST_POLAR, maxPolarAngle: Math.PI - LEAST_POLAR, ...before.reach });
    this.lookAt(before.stand.eye, before.stand.target, false);
    before.update();
    this.#isUntouched = true;
    controls.told = () => this.#follow();
  }

  get stand(): CameraStand {
    return { eye: this.#goalCamera.position, target: this.#goal.target };
  }

  limit(reach: Partial<CameraReach>): void {
    Object.assign(this.#controls, reach);
    this.#least = reach.minDistance ?? this.#least;
    this.#limitDepth();
  }

  enclose(box: Box3): void {
    this.#box = box;
  }

  lookAt(eye: Vector3, target: Vector3, eased: boolean): void {
    const { about } = this.#goal;
    about.setFromVector3(eye.clone().sub(target));
    this.#goal.target.copy(target);
    // Round the shorter way.
    this.#shown.about.theta += wholeTurns(about.theta - this.#shown.about.theta);
    this.#limitDepth();
    this.#placeGoal();
    this.#go(OWN_PACE, eased);
  }

  setEased(eased: boolean): void {
    this.#eased = eased;
  }

  /** The controls themselves pan with the shift key, and turn with it where they pan. */
  setPanning(): void {}

  beforeZoom({ surface, toPointer, nearer }: ZoomStep): void {
    this.#zoomToPointer = toPointer;
    if (!nearer) this.#lookToMiddle();
    else if (surface !== null) {
      // Steps are shares of the way to the middle of the orbit: to that of a mug they would lead through its wall.
      const depth = depthOf(surface, this.#shown);
      if (depth > 0 && depth < this.#shown.about.radius) this.#setDepth(depth);
    }
  }

  step(key: string, eased: boolean): boolean {
    const { about } = this.#goal;
    const steps: Record<string, () => void> = {
      ArrowLeft: () => (about.theta -= KEY_TURN),
      ArrowRight: () => (about.theta += KEY_TURN),
      ArrowUp: () => (about.phi -= KEY_TURN),
      ArrowDown: () => (about.phi += KEY_TURN),
      "+": () => (about.radius *= 1 - KEY_ZOOM),
      "=": () => (about.radius *= 1 - KEY_ZOOM),
      "-": () => (about.radius *= 1 + KEY_ZOOM),
    };
    const step = steps[key];
    if (step === undefined) return false;
    step();
    about.makeSafe();
    this.#placeGoal();
    // They hold it to its limits.
    this.#controls.update();
    this.#go(OWN_PACE, eased);
    return true;
  }

  update(delta: number): boolean {
    const { about, target } = this.#shown;
    const goal = this.#goal;
    const before = [about.theta, about.phi, about.radius, ...target.toArray()];
    const share = this.#eased ? 1 - Math.exp(-this.#pace * delta) : 1;
    about.theta = MathUtils.lerp(about.theta, goal.about.theta, share);
    about.phi = MathUtils.lerp(about.phi, goal.about.phi, share);
    about.radius = MathUtils.lerp(about.radius, goal.about.radius, share);
    target.lerp(goal.target, share);
    if (this.#isThere()) this.#arrive();
    const after = [about.theta, about.phi, about.radius, ...target.toArray()];
    const moved = this.#jumped || after.some((value, part) => value !== before[part]);
    this.#jumped = false;
    if (!this.#isUntouched) {
      this.#camera.position.setFromSpherical(about).add(target);
      this.#camera.lookAt(target);
    }
    return moved;
  }

  dispose(): void {
    this.#abort.abort();
    this.#controls.dispose();
  }

  /** The goal's camera sees as the view's does; and what still moved by itself stops in a hand, while a wheel's steps add up. */
  #start(): void {
    this.#goalCamera.copy(this.#camera, false);
    if (this.#held) {
      this.#goal.about.copy(this.#shown.about);
      this.#goal.target.copy(this.#shown.target);
    }
    this.#placeGoal();
  }

  /** Takes up where the controls have brought the goal, and holds it to what they do not: a box, and a limit on one side. */
  #follow(): void {
    const { position } = this.#goalCamera;
    const { target } = this.#controls;
    if (this.#box !== null) {
      const inside = this.#box.clampPoint(target, new Vector3());
      position.add(inside).sub(target);
      target.copy(inside);
    }
    const { about } = this.#goal;
    const { theta } = about;
    about.setFromVector3(position.clone().sub(target));
    this.#goal.target.copy(target);
    about.theta += wholeTurns(theta - about.theta);
    const { minAzimuthAngle: least, maxAzimuthAngle: most } = this.#controls;
    if (!Number.isFinite(most - least)) about.theta = MathUtils.clamp(about.theta, least, most);
    this.#placeGoal();
    this.#go(HAND_PACE, true);
  }

  get #middle(): Vector3 | undefined {
    return this.#box?.getCenter(new Vector3());
  }

  /** What is as far away again turns about its own middle. */
  #lookToMiddle(): void {
    const { radius } = this.#shown.about;
    const middle = this.#middle ? depthOf(this.#middle, this.#shown) : 0;
    if (radius < SAME * middle && radius > FAR * middle) this.#setDepth(middle);
  }

  /**
   * Lays the middle of the orbit `depth` metres before the camera, without the picture moving. What it is on its way to is then as far
   * from the old middle as it was, but not beyond the new one.
   */
  #setDepth(depth: number): void {
    const [shown, goal] = [this.#shown, this.#goal];
    const nearer = shown.about.radius - depth;
    for (const place of [shown, goal]) {
      place.target.addScaledVector(backOf(place), nearer);
      place.about.radius -= nearer;
    }
    this.#limitDepth();
    goal.about.radius = Math.max(goal.about.radius, this.#controls.minDistance);
    this.#placeGoal();
  }

  /** Holds it from the model's middle, whatever it turns about, and a little from that. */
  #limitDepth(): void {
    const goal = this.#goal;
    const beyond = this.#middle ? depthOf(this.#middle, goal) - goal.about.radius : 0;
    const close = CLOSE * (this.#box?.getSize(new Vector3()).length() ?? 0);
    this.#controls.minDistance = Math.max(this.#least - Math.max(0, beyond), Math.min(this.#least, close));
  }

  /** Puts the controls and their camera where the goal is. */
  #placeGoal(): void {
    const { about, target } = this.#goal;
    const camera = this.#goalCamera;
    this.#controls.target.copy(target);
    camera.position.setFromSpherical(about).add(target);
    camera.lookAt(target);
    camera.updateMatrixWorld();
  }

  #go(pace: number, eased: boolean): void {
    this.#isUntouched = false;
    this.#pace = pace;
    if (!eased) this.#arrive();
    this.#jumped ||= !eased;
    this.#requestFrame();
  }

  #arrive(): void {
    this.#shown.about.copy(this.#goal.about);
    this.#shown.target.copy(this.#goal.target);
  }

  #isThere(): boolean {
    const [shown, goal] = [this.#shown, this.#goal];
    const least = 1e-5;
    return (
      Math.abs(shown.about.theta - goal.about.theta) < least &&
      Math.abs(shown.about.phi - goal.about.phi) < least &&
      Math.abs(shown.about.radius - goal.about.radius) < least * goal.about.radius &&
      shown.target.distanceTo(goal.target) < least * goal.about.radius
    );
  }
}

/** Unit vector from what is looked at to the camera. */
const backOf = ({ about: { phi, theta } }: Place): Vector3 => new Vector3().setFromSphericalCoords(1, phi, theta);

/** Metres along the view from the camera. */
const depthOf = (point: Vector3, place: Place): number =>
  place.about.radius - point.clone().sub(place.target).dot(backOf(place));

/** The whole turns in an angle, radians. */
const wholeTurns = (angle: number): number => 2 * Math.PI * Math.round(angle / (2 * Math.PI));

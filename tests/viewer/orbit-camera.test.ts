/** The customer's camera, by events of a pointer over a view of 400 by 200 pixels. */
import { Box3, MathUtils, PerspectiveCamera, Spherical, Vector3 } from "three";
import { afterAll, beforeAll, beforeEach, describe, expect, test, vi } from "vitest";
import { StillRig } from "../../web/viewer/camera-rig.ts";
import { OrbitCamera } from "../../web/viewer/orbit-camera.ts";

/** What a view's element is to the controls. */
class Root extends EventTarget {
  readonly clientWidth = 400;
  readonly clientHeight = 200;
  readonly style = {};
  readonly ownerDocument = new EventTarget();
  getRootNode(): EventTarget {
    return this.ownerDocument;
  }
  setPointerCapture(): void {}
  releasePointerCapture(): void {}
  getBoundingClientRect(): { left: number; top: number; width: number; height: number } {
    return { left: 0, top: 0, width: 400, height: 200 };
  }
}

const BEGIN = new Vector3(0, 0, 10);

let root: Root;
let camera: PerspectiveCamera;
let rig: OrbitCamera;
let asked: number;

beforeAll(() => void vi.stubGlobal("navigator", { platform: "Linux" }));
afterAll(() => void vi.unstubAllGlobals());

beforeEach(() => {
  root = new Root();
  camera = new PerspectiveCamera(30, 2, 0.1, 100);
  const still = new StillRig(camera);
  still.limit({ minDistance: 1, maxDistance: 20 });
  still.enclose(new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)));
  still.lookAt(new Vector3(0, 0, 10), new Vector3());
  asked = 0;
  rig = new OrbitCamera(camera, root as unknown as HTMLElement, still, () => {
    asked += 1;
  });
  rest();
});

/** Lets it come to rest, as frames would. */
function rest(): void {
  for (let frame = 0; frame < 200; frame++) {
    rig.update(1 / 60);
    camera.updateMatrixWorld();
  }
}

const target = (): Vector3 => {
  const { radius } = place();
  return camera.position.clone().addScaledVector(camera.getWorldDirection(new Vector3()), radius);
};

/** About the middle that it looks at, while it does not pan. */
const place = (): Spherical => new Spherical().setFromVector3(camera.position);

type Numbers = "pointerId" | "clientX" | "clientY" | "button" | "deltaY" | "deltaMode";
type Init = Partial<Record<Numbers, number>> & {
  pointerType?: "mouse" | "touch" | "pen";
  shiftKey?: boolean;
};

function tell(to: EventTarget, type: string, init: Init): Event {
  const event = Object.assign(new Event(type, { cancelable: true }), {
    pointerId: 1,
    pointerType: "mouse",
    button: 0,
    deltaMode: 0,
    ctrlKey: false,
    pageX: init.clientX,
    pageY: init.clientY,
    ...init,
  });
  to.dispatchEvent(event);
  return event;
}
const down = (clientX: number, clientY: number, init: Init = {}): Event =>
  tell(root, "pointerdown", { clientX, clientY, ...init });
const move = (clientX: number, clientY: number, init: Init = {}): Event =>
  tell(root.ownerDocument, "pointermove", { clientX, clientY, ...init });
const up = (init: Init = {}): Event => tell(root.ownerDocument, "pointerup", init);
const wheel = (deltaY: number, init: Init = {}): Event =>
  tell(root, "wheel", { deltaY, clientX: 200, clientY: 100, ...init });

test("what it takes over stays where it is to the last bit, so that what is placed by it does not hang on when hands came", () => {
  const still = new StillRig(camera);
  still.lookAt(new Vector3(0.31, 0.27, 0.83), new Vector3(0.011, 0.057, 0.003));
  still.update();
  camera.updateMatrixWorld();
  const before = camera.matrixWorld.toArray();
  rig.dispose();
  rig = new OrbitCamera(camera, root as unknown as HTMLElement, still, () => {});
  rest();
  expect(camera.matrixWorld.toArray()).toEqual(before);
});

describe("orbit", () => {
  test("it begins where the still camera stood, and looks where that looked", () => {
    expect(camera.position.distanceTo(BEGIN)).toBeLessThan(1e-9);
    expect(target().length()).toBeLessThan(1e-9);
  });

  test("a drag by the view's height is a whole turn, against the pointer", () => {
    down(100, 100);
    move(150, 100);
    rest();
    expect(MathUtils.radToDeg(place().theta)).toBeCloseTo(-90, 3);
    move(150, 75);
    rest();
    expect(MathUtils.radToDeg(place().phi)).toBeCloseTo(135, 3);
    expect(place().radius).toBeCloseTo(10, 9);
  });

  test("a drag comes after the pointer with a little inertia, and at once where nothing may move by itself", () => {
    down(100, 100);
    move(150, 100);
    rig.update(1 / 60);
    expect(place().theta).toBeLessThan(0);
    expect(place().theta).toBeGreaterThan(-Math.PI / 2);
    rig.setEased(false);
    expect(rig.update(1 / 60)).toBe(true);
    expect(place().theta).toBeCloseTo(-Math.PI / 2, 9);
    expect(rig.update(1 / 60)).toBe(false);
  });

  test("it asks for a frame while it moves, and no longer when it rests", () => {
    const before = asked;
    down(100, 100);
    move(110, 100);
    expect(asked).toBeGreaterThan(before);
    expect(rig.update(1 / 60)).toBe(true);
    rest();
    expect(rig.update(1 / 60)).toBe(false);
  });

  test("what was let go is not followed any more, wherever it is let go", () => {
    for (const type of ["pointerup", "pointercancel"]) {
      down(100, 100);
      tell(root.ownerDocument, type, {});
      move(300, 100);
      rest();
      expect(camera.position.distanceTo(BEGIN)).toBeLessThan(1e-9);
    }
  });

  test("it goes neither over the top nor beyond its limits", () => {
    rig.limit({ minAzimuthAngle: -0.5, maxAzimuthAngle: 0.25, minPolarAngle: 1, maxPolarAngle: 2 });
    down(100, 100);
    move(-900, 900);
    rest();
    expect(place().theta).toBeCloseTo(0.25, 9);
    expect(place().phi).toBeCloseTo(1, 9);
    move(2000, -2000);
    rest();
    expect(place().theta).toBeCloseTo(-0.5, 9);
    expect(place().phi).toBeCloseTo(2, 9);
  });

  test("limits across the back hold on both sides of it", () => {
    rig.limit({ minAzimuthAngle: MathUtils.degToRad(150), maxAzimuthAngle: MathUtils.degToRad(210) });
    const behind = new Vector3().setFromSphericalCoords(10, Math.PI / 2, MathUtils.degToRad(-170));
    rig.lookAt(behind, new Vector3(), false);
    down(100, 100);
    move(101, 100);
    rest();
    expect(MathUtils.radToDeg(place().theta)).toBeCloseTo(-171.8, 3);
    move(60, 100);
    rest();
    expect(MathUtils.radToDeg(place().theta)).toBeCloseTo(-150, 3);
  });

  test("a limit on one side holds, and the other side is free", () => {
    rig.limit({ minAzimuthAngle: -0.5 });
    for (let turn = 0; turn < 3; turn++) {
      down(100, 100);
      move(40, 100);
      up();
      rest();
    }
    expect(place().theta).toBeCloseTo(Math.PI * 1.8 - 2 * Math.PI, 4);
    for (let turn = 0; turn < 30; turn++) {
      down(100, 100);
      move(120, 100);
      up();
      rest();
    }
    expect(place().theta).toBeCloseTo(-0.5, 4);
  });

  test("it goes to another place by the shorter way", () => {
    rig.lookAt(new Vector3().setFromSphericalCoords(10, 1.5, 3), new Vector3(), false);
    rest();
    rig.lookAt(new Vector3().setFromSphericalCoords(10, 1.5, -3), new Vector3(), true);
    rig.update(1 / 60);
    expect(Math.abs(place().theta)).toBeGreaterThan(3 - 1e-6);
    rest();
    expect(place().theta).toBeCloseTo(-3, 4);
  });
});

describe("zoom", () => {
  test("a wheel comes nearer and goes away, within the limits", () => {
    expect(wheel(-100).defaultPrevented).toBe(true);
    rest();
    expect(place().radius).toBeCloseTo(10 * 0.95 ** (10 / 3), 3);
    for (let turn = 0; turn < 50; turn++) wheel(-100);
    rest();
    expect(place().radius).toBeCloseTo(1, 3);
    for (let turn = 0; turn < 50; turn++) wheel(100);
    rest();
    expect(place().radius).toBeCloseTo(20, 3);
  });

  test("what is under the wheel stays under it", () => {
    const point = target().set(0.9, 0.4, 0);
    const before = point.clone().project(camera);
    wheel(-200, { clientX: ((before.x + 1) / 2) * 400, clientY: ((1 - before.y) / 2) * 200 });
    rest();
    const after = point.clone().project(camera);
    expect(after.x).toBeCloseTo(before.x, 3);
    expect(after.y).toBeCloseTo(before.y, 3);
    expect(camera.position.z).toBeLessThan(9);
  });

  test("two fingers pinch and pan, and turn nothing", () => {
    const touch = (pointerId: number): Init => ({ pointerType: "touch", pointerId });
    down(150, 100, touch(1));
    down(250, 100, touch(2));
    move(100, 100, touch(1));
    move(300, 100, touch(2));
    rest();
    expect(camera.position.z).toBeCloseTo(5, 3);
    const { x } = camera.position;
    move(120, 100, touch(1));
    move(320, 100, touch(2));
    rest();
    expect(camera.position.x).toBeLessThan(x - 0.1);
    expect(camera.getWorldDirection(new Vector3()).z).toBeCloseTo(-1, 9);
  });

  test("one finger turns, also the one that is left of two", () => {
    const touch = (pointerId: number): Init => ({ pointerType: "touch", pointerId });
    down(150, 100, touch(1));
    down(250, 100, touch(2));
    up(touch(2));
    move(160, 100, touch(1));
    rest();
    expect(place().theta).toBeCloseTo(-Math.PI / 10, 3);
  });
});

describe("zoom to a ball of a metre about the origin", () => {
  const RADIUS = 1;
  const LEAST = 0.05;

  beforeEach(() => {
    rig.limit({ minDistance: LEAST });
  });

  /** Where the ball's outside is seen there, pixels; null: beside it, or from within. */
  function seenAt(x: number, y: number): Vector3 | null {
    camera.updateMatrixWorld();
    const towards = new Vector3((2 * x) / 400 - 1, 1 - (2 * y) / 200, 0.5).unproject(camera);
    const direction = towards.sub(camera.position).normalize();
    const along = -camera.position.dot(direction);
    const missed = camera.position.lengthSq() - along * along;
    if (missed > RADIUS * RADIUS || camera.position.length() < RADIUS) return null;
    return camera.position.clone().addScaledVector(direction, along - Math.sqrt(RADIUS * RADIUS - missed));
  }

  /** As the view tells it, by what is seen at that moment. */
  function turn(deltaY: number, x = 200, y = 100): void {
    const under = seenAt(x, y);
    rig.beforeZoom({ surface: under ?? seenAt(200, 100), toPointer: under !== null, nearer: deltaY < 0 });
    wheel(deltaY, { clientX: x, clientY: y });
  }

  function frames(count: number): void {
    for (let frame = 0; frame < count; frame++) rig.update(1 / 60);
  }

  test("a wheel comes to rest before what is seen, however far and fast it is turned", () => {
    for (const between of [0, 1, 5, 60]) {
      for (let step = 0; step < 80; step++) {
        turn(-300);
        frames(between);
        expect(camera.position.length(), `${step} turns with ${between} frames between`).toBeGreaterThan(RADIUS);
      }
      rest();
      expect(camera.position.length()).toBeGreaterThan(RADIUS);
    }
    expect(camera.position.length(), "and comes as near as the reach lets it").toBeLessThan(RADIUS + 1.1 * LEAST);
  });

  test("so it does at the side, where what is under the pointer stays under it", () => {
    const [x, y] = [225, 90];
    const point = seenAt(x, y) as Vector3;
    for (let step = 0; step < 10; step++) {
      turn(-100, x, y);
      frames(100);
    }
    camera.updateMatrixWorld();
    const { x: right, y: up } = point.clone().project(camera);
    expect(((right + 1) / 2) * 400).toBeCloseTo(x, 0);
    expect(((1 - up) / 2) * 200).toBeCloseTo(y, 0);
    for (let step = 0; step < 60; step++) {
      turn(-300, x, y);
      frames(3);
    }
    expect(camera.position.length()).toBeGreaterThan(RADIUS);
  });

  test("what the wheel finds nearer than the middle moves nothing by itself", () => {
    turn(-100);
    frames(2);
    camera.updateMatrixWorld();
    const before = camera.matrixWorld.toArray();
    rig.beforeZoom({ surface: seenAt(200, 100), toPointer: true, nearer: true });
    rig.update(0);
    camera.updateMatrixWorld();
    for (const [i, value] of camera.matrixWorld.toArray().entries()) expect(value).toBeCloseTo(before[i] as number, 9);
  });

  test("near, it turns about what is seen, and far away again about the model's middle", () => {
    for (let step = 0; step < 20; step++) {
      turn(-200);
      frames(100);
    }
    expect(rig.stand.target.length()).toBeCloseTo(RADIUS, 2);
    for (let step = 0; step < 60 && camera.position.length() < 10; step++) {
      turn(120);
      frames(100);
    }
    expect(rig.stand.target.length()).toBeLessThan(1e-6);
  });

  test("a least distance that a page gives is one to the middle, as before", () => {
    rig.limit({ minDistance: 4 });
    for (let step = 0; step < 20; step++) {
      turn(-300);
      frames(5);
    }
    rest();
    expect(camera.position.length()).toBeCloseTo(4, 3);
    rig.limit({ minDistance: 4 });
    turn(-300);
    rest();
    expect(camera.position.length()).toBeCloseTo(4, 3);
  });
});

describe("pan", () => {
  test("the right button pans, and the left one with the shift key, with what is under it", () => {
    const perPixel = (2 * 10 * Math.tan(MathUtils.degToRad(15))) / 200;
    down(100, 100, { button: 2 });
    move(110, 95, { button: 2 });
    rest();
    expect(camera.position.x).toBeCloseTo(-10 * perPixel, 4);
    expect(camera.position.y).toBeCloseTo(-5 * perPixel, 4);
    up();
    down(100, 100, { shiftKey: true });
    move(90, 105);
    rest();
    expect(camera.position.x).toBeCloseTo(0, 4);
    expect(camera.position.y).toBeCloseTo(0, 4);
  });

  test("what is looked at stays inside the box", () => {
    down(100, 100, { button: 2 });
    move(-900, 100, { button: 2 });
    rest();
    expect(camera.position.x).toBeCloseTo(1, 4);
  });
});

describe("keys", () => {
  test("arrows turn by an even step, plus and minus come nearer and go away, others mean nothing", () => {
    expect(rig.step("ArrowRight", false)).toBe(true);
    rest();
    expect(place().theta).toBeCloseTo(Math.PI / 24, 9);
    expect(rig.step("ArrowUp", true)).toBe(true);
    rest();
    expect(place().phi).toBeCloseTo(Math.PI / 2 - Math.PI / 24, 4);
    rig.step("+", true);
    rest();
    expect(place().radius).toBeCloseTo(8.5, 3);
    rig.step("-", true);
    rest();
    expect(place().radius).toBeCloseTo(8.5 * 1.15, 3);
    expect(rig.step("a", true)).toBe(false);
  });
});

test("it lets go of the view", () => {
  rig.dispose();
  down(100, 100);
  move(150, 100);
  expect(wheel(100).defaultPrevented).toBe(false);
  rest();
  expect(camera.position.distanceTo(BEGIN)).toBeLessThan(1e-9);
});

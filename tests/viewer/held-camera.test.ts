/** The editor's camera and a wheel, before a ball of a metre about the origin, in a view of 400 by 200 pixels. */
import { Box3, PerspectiveCamera, Sphere, Vector2, Vector3 } from "three";
import { afterAll, beforeAll, beforeEach, expect, test, vi } from "vitest";
import { StillRig } from "../../web/viewer/camera-rig.ts";
import type { HeldCamera } from "../../web/viewer/held-camera.ts";

const WIDTH = 400;
const HEIGHT = 200;
const RADIUS = 1;
const LEAST = 0.05;

/** What a view's element is to the controls. */
class Root extends EventTarget {
  readonly clientWidth = WIDTH;
  readonly clientHeight = HEIGHT;
  readonly style = {};
  readonly ownerDocument = new EventTarget();
  setAttribute(): void {}
  getBoundingClientRect(): object {
    return { left: 0, top: 0, x: 0, y: 0, width: WIDTH, height: HEIGHT };
  }
}

let root: Root;
let camera: PerspectiveCamera;
let rig: HeldCamera;

/** What the controls take of a browser. */
class Rect {
  left = 0;
  top = 0;
  width = WIDTH;
  height = HEIGHT;
}

beforeAll(() => {
  vi.stubGlobal("navigator", { platform: "Linux" });
  vi.stubGlobal("DOMRect", Rect);
});
afterAll(() => void vi.unstubAllGlobals());

beforeEach(async () => {
  const { HeldCamera } = await import("../../web/viewer/held-camera.ts");
  root = new Root();
  camera = new PerspectiveCamera(30, WIDTH / HEIGHT, 0.001, 100);
  const still = new StillRig(camera);
  still.limit({ minDistance: LEAST, maxDistance: 20 });
  still.enclose(new Box3(new Vector3(-2, -2, -2), new Vector3(2, 2, 2)));
  still.lookAt(new Vector3(3, 1, 7), new Vector3());
  rig = new HeldCamera(camera, root as unknown as HTMLElement, still, () => {});
  rig.setEased(true);
  frames(200);
});

function frames(count: number): void {
  for (let frame = 0; frame < count; frame++) {
    rig.update(1 / 60);
    camera.updateMatrixWorld();
  }
}

/** Where the ball's outside is seen there, pixels; null: beside it, or from within. */
function seenAt(x: number, y: number): Vector3 | null {
  const towards = new Vector3((2 * x) / WIDTH - 1, 1 - (2 * y) / HEIGHT, 0.5).unproject(camera);
  const direction = towards.sub(camera.position).normalize();
  const along = -camera.position.dot(direction);
  const missed = camera.position.lengthSq() - along * along;
  if (missed > RADIUS * RADIUS || camera.position.length() < RADIUS) return null;
  return camera.position.clone().addScaledVector(direction, along - Math.sqrt(RADIUS * RADIUS - missed));
}

/** As the view tells it, by what is seen at that moment. */
function wheel(deltaY: number, clientX = WIDTH / 2, clientY = HEIGHT / 2): void {
  const under = seenAt(clientX, clientY);
  rig.beforeZoom({ surface: under ?? seenAt(WIDTH / 2, HEIGHT / 2), toPointer: under !== null, nearer: deltaY < 0 });
  const event = Object.assign(new Event("wheel", { cancelable: true }), { deltaY, deltaMode: 0, clientX, clientY });
  root.dispatchEvent(Object.assign(event, { ctrlKey: false, pageX: clientX, pageY: clientY }));
}

test("a wheel comes to rest before what is seen, however far and fast it is turned", () => {
  for (const between of [0, 1, 5, 60]) {
    for (let turn = 0; turn < 80; turn++) {
      wheel(-300);
      frames(between);
      expect(camera.position.length(), `${turn} turns with ${between} frames between`).toBeGreaterThan(RADIUS);
    }
    frames(200);
    expect(camera.position.length()).toBeGreaterThan(RADIUS);
  }
  expect(camera.position.length(), "and comes as near as the reach lets it").toBeLessThan(RADIUS + 1.1 * LEAST);
});

test("so it does at the side, where what is under the pointer stays under it", () => {
  const [x, y] = [WIDTH / 2 + 25, HEIGHT / 2 - 10];
  const point = seenAt(x, y) as Vector3;
  for (let turn = 0; turn < 10; turn++) {
    wheel(-100, x, y);
    frames(100);
  }
  const { x: right, y: up } = point.clone().project(camera);
  expect(((right + 1) / 2) * WIDTH).toBeCloseTo(x, 0);
  expect(((1 - up) / 2) * HEIGHT).toBeCloseTo(y, 0);
  for (let turn = 0; turn < 60; turn++) {
    wheel(-300, x, y);
    frames(3);
  }
  expect(camera.position.length()).toBeGreaterThan(RADIUS);
});

test("what the wheel finds nearer than the middle moves nothing by itself", () => {
  wheel(-100);
  frames(2);
  const before = camera.matrixWorld.toArray();
  rig.beforeZoom({ surface: seenAt(200, 100), toPointer: true, nearer: true });
  rig.update(0);
  camera.updateMatrixWorld();
  for (const [i, value] of camera.matrixWorld.toArray().entries()) expect(value).toBeCloseTo(before[i] as number, 9);
});

test("far away again, the view turns about the model's middle as before", () => {
  const before = new Sphere(rig.controls.getTarget(new Vector3()), rig.controls.distance);
  for (let turn = 0; turn < 20; turn++) {
    wheel(-200);
    frames(100);
  }
  expect(rig.controls.getTarget(new Vector3()).length(), "near, about what is seen").toBeCloseTo(RADIUS, 2);
  for (let turn = 0; turn < 60; turn++) {
    wheel(120);
    frames(100);
    if (rig.controls.distance > before.radius) break;
  }
  expect(rig.controls.getTarget(new Vector3()).distanceTo(before.center)).toBeLessThan(1e-6);
  expect(new Vector2(camera.position.x, camera.position.z).angle()).toBeCloseTo(Math.atan2(7, 3), 6);
});

/** What a mouse does there, with the left button down unless it goes up. */
function mouse(type: "pointerdown" | "pointermove" | "pointerup", clientX: number, clientY = HEIGHT / 2): void {
  const at = { clientX, clientY, pageX: clientX, pageY: clientY, movementX: 0, movementY: 0 };
  const held = { pointerId: 1, pointerType: "mouse", button: 0, buttons: type === "pointerup" ? 0 : 1 };
  const event = Object.assign(new Event(type, { cancelable: true }), at, held);
  (type === "pointerdown" ? root : root.ownerDocument).dispatchEvent(event);
}

test("a drag turns the view by all of its way, though the GPU leaves time for no frame between its moves", () => {
  const drag = (between: number): void => {
    mouse("pointerdown", 100);
    for (const x of [110, 130, 160, 200]) {
      mouse("pointermove", x);
      frames(between);
    }
    mouse("pointerup", 200);
  };
  const turned = (...between: number[]): number => {
    const before = rig.controls.azimuthAngle;
    between.forEach(drag);
    frames(200);
    return before - rig.controls.azimuthAngle;
  };
  const way = turned(1);
  expect(way).toBeCloseTo(Math.PI, 5);
  expect(turned(0)).toBeCloseTo(way, 9);
  // A press stops the view where it is seen.
  expect(turned(0, 0), "also where the one before has just ended").toBeCloseTo(way, 9);
});

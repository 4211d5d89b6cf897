import { PerspectiveCamera, Vector3 } from "three";
import { expect, test } from "vitest";
import { lensFor } from "../../web/viewer/capture.ts";
import { ModelCamera } from "../../web/viewer/model-camera.ts";
import type { Stage } from "../../web/viewer/stage.ts";

/** A stage of that aspect, at the origin, and the camera of the picture that is taken of it. */
async function cameraOfPicture(
  aspect: number,
  width: number,
  height: number,
  pointsOf: (view: PerspectiveCamera) => readonly Vector3[] = () => [new Vector3(0, 0, -5)],
): Promise<[PerspectiveCamera, Stage]> {
  let taken = new PerspectiveCamera();
  const stage = {
    camera: new PerspectiveCamera(lensFor(aspect), aspect),
    bounds: { radius: 1 },
    rig: { limit: () => undefined },
    requestFrame: () => undefined,
    capture: async (camera: PerspectiveCamera) => {
      taken = camera;
      return null;
    },
  } as unknown as Stage;
  const camera = new ModelCamera(stage);
  stage.camera.updateProjectionMatrix();
  camera.setModel(new Float32Array(pointsOf(stage.camera).flatMap((point) => point.toArray())));
  await camera.capture(null, width, height);
  return [taken, stage];
}

const shown = (camera: PerspectiveCamera, point: Vector3): boolean => {
  camera.updateProjectionMatrix();
  const { x, y } = point.clone().project(camera);
  return Math.max(Math.abs(x), Math.abs(y)) <= 1;
};

test("a square picture of a view that is taller than wide cuts off neither its top nor its foot", async () => {
  const [camera, { camera: view }] = await cameraOfPicture(0.65, 480, 480);
  for (const y of [-0.99, 0.99]) {
    const point = new Vector3(0, y, 0.9).unproject(view);
    expect(shown(view, point)).toBe(true);
    expect(shown(camera, point)).toBe(true);
  }
});

test("a picture is taken through the view's own lens where both are of one shape", async () => {
  for (const [width, height] of [
    [300, 600],
    [400, 400],
    [600, 300],
  ] as const) {
    const [camera, { camera: view }] = await cameraOfPicture(width / height, width, height);
    expect(camera.fov).toBeCloseTo(view.fov, 9);
  }
});

test("a square picture of a view that is wider than high has all that is seen of the product at its sides", async () => {
  for (const x of [0.99, -0.8]) {
    const points = (view: PerspectiveCamera) => [new Vector3(x, 0.2, 0.9).unproject(view), new Vector3(0, 0, -5)];
    const [camera, { camera: view }] = await cameraOfPicture(1.7, 480, 480, points);
    for (const point of points(view)) expect(shown(camera, point)).toBe(true);
  }
});

test("what reaches beyond the view, or stands behind it, makes no picture smaller than the whole view", async () => {
  const outside = (view: PerspectiveCamera) => [new Vector3(9, 0, 0.9).unproject(view), new Vector3(3, 0, 5)];
  const [camera, { camera: view }] = await cameraOfPicture(1.7, 480, 480, outside);
  camera.updateProjectionMatrix();
  const corner = new Vector3(1, 0, 0.9).unproject(view).project(camera);
  expect(corner.x).toBeCloseTo(1, 6);
});

test("a product in the middle of a wide view is as large in a square picture as it is there", async () => {
  const middle = (view: PerspectiveCamera) => [new Vector3(0.4, 0.9, 0.9).unproject(view)];
  const [camera, { camera: view }] = await cameraOfPicture(1.7, 480, 480, middle);
  expect(camera.fov).toBeCloseTo(view.fov, 9);
});

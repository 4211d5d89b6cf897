import { PerspectiveCamera, Vector3 } from "three";
import { expect, test } from "vitest";
import { lensFor } from "../../web/viewer/capture.ts";
import { ModelCamera } from "../../web/viewer/model-camera.ts";
import type { Stage } from "../../web/viewer/stage.ts";

/** A stage of that aspect, at the origin, and the camera of the picture that is taken of it. */
async function cameraOfPicture(aspect: number, width: number, height: number): Promise<[PerspectiveCamera, Stage]> {
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
  camera.setModel(new Float32Array([0, 0, -5]));
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

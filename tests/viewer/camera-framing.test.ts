import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { framedEye, MODEL_AZIMUTH, MODEL_POLAR } from "../../web/viewer/camera-framing.ts";

/** How far from the middle of the view its farthest vertex stands, as a share of the way to the nearer edge. */
function farthest(positions: Float32Array, aspect: number): number {
  const camera = new PerspectiveCamera(30, aspect, 0.01, 100);
  const { eye, target } = framedEye(camera, positions, MODEL_AZIMUTH, MODEL_POLAR);
  camera.position.copy(eye);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  let most = 0;
  for (let at = 0; at < positions.length; at += 3) {
    const { x, y } = new Vector3().fromArray(positions, at).project(camera);
    most = Math.max(most, Math.abs(x), Math.abs(y));
  }
  return most;
}

/** A board of four corners, behind a part so fine that its vertices are nearly all that there are. */
function fineBeforeBoard(count: number): Float32Array {
  const fine = Array.from({ length: count * 3 }, (_, i) => ((i * 7919) % 1000) / 10_000);
  const corners = [-2, -2, -0.5, 2, -2, -0.5, 2, 2, -0.5, -2, 2, -0.5];
  return Float32Array.from([...fine.slice(0, 3), ...corners, ...fine.slice(3)]);
}

describe("a model that is framed", () => {
  it("is seen whole, also where a board's few corners are lost among very many vertices", () => {
    const alone = farthest(fineBeforeBoard(1), 1);
    expect(alone).toBeLessThan(0.9);
    for (const aspect of [0.5, 1, 1.8]) expect(farthest(fineBeforeBoard(70_000), aspect)).toBeLessThan(0.9);
    expect(farthest(fineBeforeBoard(70_000), 1)).toBeCloseTo(alone, 2);
  });
});

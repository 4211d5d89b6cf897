import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { CylindricalProjector, PerspectiveProjector, UvProjector } from "../../web/engine/engine-api.ts";
import { type PictureRay, pictureRay } from "../../web/viewer/picture-ray.ts";
import { reachesPoint } from "../../web/viewer/projector-sight.ts";
import { expectVector } from "./pose-helpers.ts";

const quarter = Math.SQRT1_2;
/** At (0, 0, 5), looking along -Z; 2 m high and 4 m wide where z is 0. */
const slide: PerspectiveProjector = {
  kind: "perspective",
  position: [0, 0, 5],
  rotation: [0, 0, 0, 1],
  fov: (2 * Math.atan(0.2) * 180) / Math.PI,
  aspect: 2,
  near: 1,
  far: 6,
};
const label: CylindricalProjector = {
  kind: "cylindrical",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  height: 1,
  arc: 180,
  depth: 0.25,
};
const stamp: UvProjector = { kind: "uv", center: [0.25, 0.5], size: [0.2, 0.1], angle: 90 };

const point = (x: number, y: number, z: number, normal = [0, 0, 1], uv: [number, number] = [0, 0]) => ({
  position: new Vector3(x, y, z),
  normal: new Vector3(...normal),
  uv,
});

describe("the points that a slide reaches", () => {
  it("lie in its pyramid, between near and far", () => {
    expect(reachesPoint(slide, point(1.99, 0.99, 0))).toBe(true);
    expect(reachesPoint(slide, point(2.01, 0, 0))).toBe(false);
    expect(reachesPoint(slide, point(0, 1.01, 0))).toBe(false);
    expect(reachesPoint(slide, point(0, 0, 4.5))).toBe(false);
    expect(reachesPoint(slide, point(0, 0, -1.5))).toBe(false);
    expect(reachesPoint(slide, point(0, 0, 7))).toBe(false);
  });

  it("look at its eye", () => {
    expect(reachesPoint(slide, point(0, 0, 0, [0, 0, -1]))).toBe(false);
    // A floor under the eye's height faces it, one above does not.
    expect(reachesPoint(slide, point(0, -0.5, 0, [0, 1, 0]))).toBe(true);
    expect(reachesPoint(slide, point(0, 0.5, 0, [0, 1, 0]))).toBe(false);
  });

  it("turn with it", () => {
    const turned: PerspectiveProjector = { ...slide, position: [5, 0, 0], rotation: [0, quarter, 0, quarter] };
    expect(reachesPoint(turned, point(0, 0, 1.9, [1, 0, 0]))).toBe(true);
    expect(reachesPoint(turned, point(0, 0, 2.1, [1, 0, 0]))).toBe(false);
  });
});

describe("the points that a label reaches", () => {
  it("lie in its shell, within its arc and height, and look outward", () => {
    expect(reachesPoint(label, point(0, 0.4, 1.2))).toBe(true);
    expect(reachesPoint(label, point(0.99, 0, 0.05, [1, 0, 0]))).toBe(true);
    expect(reachesPoint(label, point(0, 0, 1.3))).toBe(false);
    expect(reachesPoint(label, point(0, 0, 0.7))).toBe(false);
    expect(reachesPoint(label, point(0, 0.6, 1))).toBe(false);
    expect(reachesPoint(label, point(0, 0, -1, [0, 0, -1]))).toBe(false);
    expect(reachesPoint(label, point(0, 0, 1, [0, 0, -1]))).toBe(false);
    expect(reachesPoint({ ...label, depth: 2 }, point(0, 0, 0))).toBe(false);
  });
});

describe("the points that a stamp reaches", () => {
  it("are told by their texture coordinates alone, wrapped into the texture", () => {
    const at = (u: number, v: number) => reachesPoint(stamp, point(9, 9, 9, [0, -1, 0], [u, v]));
    // Turned by a quarter its width runs down.
    expect(at(0.25, 0.59)).toBe(true);
    expect(at(0.29, 0.5)).toBe(true);
    expect(at(0.31, 0.5)).toBe(false);
    expect(at(0.25, 0.61)).toBe(false);
    expect(at(3.25, -0.5)).toBe(true);
  });
});

describe("a picture's rays", () => {
  it("leave a slide's near rectangle and end at its far one", () => {
    const ray = pictureRay(slide, 0.5, -0.5);
    expectVector(ray?.origin as Vector3, new Vector3(0.4, -0.2, 4));
    const { origin, direction, length } = ray as PictureRay;
    const end = origin.clone().addScaledVector(direction, length);
    expectVector(end, new Vector3(2.4, -1.2, -1));
  });

  it("run from a label's outer wall straight to its inner one", () => {
    const ray = pictureRay(label, 0.5, 0.5);
    expectVector(ray?.origin as Vector3, new Vector3(1.25, 0.5, 0));
    expectVector(ray?.direction as Vector3, new Vector3(-1, 0, 0));
    expect(ray?.length).toBeCloseTo(0.5, 12);
    expect(pictureRay({ ...label, depth: 3 }, 0, 0)?.length).toBeCloseTo(4, 12);
  });

  it("are none of a stamp's", () => {
    expect(pictureRay(stamp, 0, 0)).toBeNull();
  });
});

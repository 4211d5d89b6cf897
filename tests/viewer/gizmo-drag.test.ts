import { Ray, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { axisOf, type DecalPose, toLocal } from "../../web/viewer/decal-pose.ts";
import { depthDrag, formatLengths, rotateDrag, scaleDrag, slideDrag } from "../../web/viewer/gizmo-drag.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import { expectVector, poseAt } from "./pose-helpers.ts";
import { cylinder, queryOf, sphere } from "./surface-helpers.ts";

const view = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
const limits = { least: 0.01, most: 10 };
const eye = new Vector3(0, 0, 6);

/** The pointer's ray from the eye through a point of the plane z = 1. */
function pointerAt(x: number, y: number, keys: { alt?: boolean; shift?: boolean } = {}) {
  const ray = new Ray(eye.clone(), new Vector3(x, y, 1).sub(eye).normalize());
  return { ray, alt: keys.alt ?? false, shift: keys.shift ?? false };
}

function placedInFront(query: SurfaceQuery): { pose: DecalPose; hit: SurfaceSample } {
  const { ray } = pointerAt(0, 0);
  const hit = query.raycast(ray.origin, ray.direction) as SurfaceSample;
  return { hit, pose: placeOnSurface(query, hit, 0.4, 1, view, null) };
}

describe("sliding by the pointer", () => {
  it("keeps the grabbed place of the picture on the pointer's ray", () => {
    const query = queryOf(cylinder());
    const { pose } = placedInFront(query);
    const { ray } = pointerAt(0.1, 0.08);
    const grab = query.raycast(ray.origin, ray.direction) as SurfaceSample;
    const held = toLocal(pose, grab.position);
    const drag = slideDrag(query, pose, grab);
    for (let step = 1; step <= 12; step++) {
      const pointer = pointerAt(0.1 + step * 0.05, 0.08 - step * 0.03);
      const moved = drag.move(pointer) as DecalPose;
      const surface = query.raycast(pointer.ray.origin, pointer.ray.direction) as SurfaceSample;
      const now = toLocal(moved, surface.position);
      // Along its own axis the box may settle; the picture under the pointer stays.
      expect(Math.hypot(now.x - held.x, now.y - held.y)).toBeLessThan(1e-6);
    }
  });

  it("keeps a decal that is held at its rim on the surface", () => {
    const query = queryOf(sphere());
    const { pose } = placedInFront(query);
    const { ray } = pointerAt(0.15, 0);
    const drag = slideDrag(query, pose, query.raycast(ray.origin, ray.direction) as SurfaceSample);
    for (let step = 1; step <= 12; step++) {
      const moved = drag.move(pointerAt(0.15 - step * 0.06, step * 0.03)) as DecalPose;
      expect(moved.position.length()).toBeCloseTo(pose.position.length(), 2);
    }
  });

  it("follows the silhouette when the pointer leaves the model", () => {
    const query = queryOf(sphere());
    const { pose, hit } = placedInFront(query);
    const drag = slideDrag(query, pose, hit);
    drag.move(pointerAt(0.7, 0));
    const beside = drag.move(pointerAt(3, 0)) as DecalPose;
    expect(beside.position.length()).toBeCloseTo(1, 1);
    expect(beside.position.x).toBeGreaterThan(0.8);
  });

  it("says on which material the pointer is", () => {
    const query = queryOf(sphere());
    const { pose, hit } = placedInFront(query);
    const drag = slideDrag(query, pose, hit);
    expect(drag.material).toBeNull();
    drag.move(pointerAt(0.1, 0));
    expect(drag.material).toBe(0);
  });
});

describe("handles under the pointer", () => {
  const pose = poseAt({ position: [0, 0, 1], size: [0.8, 0.4, 0.2] });

  it("keep the corner under the pointer along the diagonal", () => {
    const drag = scaleDrag(pose, "ne", 0, pointerAt(0.4, 0.2).ray, limits);
    const moved = drag.move(pointerAt(0.6, 0.3)) as DecalPose;
    expectVector(moved.size, new Vector3(1, 0.5, 0.25), 1e-9);
    expect(drag.readout(moved)).toBe("1.00 × 0.50 m");
  });

  it("scale about the centre with Alt", () => {
    const drag = scaleDrag(pose, "e", 0, pointerAt(0.4, 0).ray, limits);
    const moved = drag.move(pointerAt(0.5, 0, { alt: true })) as DecalPose;
    expectVector(moved.position, pose.position, 1e-9);
    expect(moved.size.x).toBeCloseTo(1, 9);
  });

  it("turn with the pointer about the box's axis, in steps of 15 degrees with Shift", () => {
    const drag = rotateDrag(pose, 0, pointerAt(0, 0.5).ray);
    const quarter = drag.move(pointerAt(-0.5, 0)) as DecalPose;
    expectVector(axisOf(quarter, 1), new Vector3(-1, 0, 0), 1e-9);
    expect(drag.readout(quarter)).toBe("90°");
    const snapped = drag.move(pointerAt(0.16, 0.5, { shift: true })) as DecalPose;
    expect(drag.readout(snapped)).toBe("−15°");
  });

  it("pull the near face along the arrow", () => {
    const side = poseAt({ turn: Math.PI / 2, axis: [0, 1, 0], position: [0, 0, 1], size: [0.4, 0.4, 0.2] });
    const drag = depthDrag(side, pointerAt(0.1, 0).ray, limits);
    const moved = drag.move(pointerAt(0.25, 0)) as DecalPose;
    expect(moved.size.z).toBeCloseTo(0.5, 9);
  });

  it("hold still where the box is seen edge on", () => {
    const edgeOn = poseAt({ turn: Math.PI / 2, axis: [0, 1, 0], size: [1, 1, 1] });
    const drag = scaleDrag(edgeOn, "e", 0, pointerAt(0, 0).ray, limits);
    expect(drag.move(pointerAt(0, 0.2))).toBeNull();
  });
});

describe("lengths for people", () => {
  it.each([
    [[0.0042], "4.20 mm"],
    [[0.082, 0.041], "8.20 × 4.10 cm"],
    [[0.52], "52.0 cm"],
    [[132.4, 20], "132 × 20.0 m"],
  ])("%j metres read %s", (metres, text) => {
    expect(formatLengths(metres)).toBe(text);
  });
});

import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { footOf, nudgeOnSurface, placeOnSurface, resized } from "../../web/viewer/decal-placement.ts";
import { axisOf, rollOf } from "../../web/viewer/decal-pose.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import { expectVector, poseAt, radians } from "./pose-helpers.ts";
import { cube, cylinder, queryOf, sheet } from "./surface-helpers.ts";

const view = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };

function hitFrom(query: SurfaceQuery, eye: Vector3): SurfaceSample {
  return query.raycast(eye, eye.clone().negate().normalize()) as SurfaceSample;
}

describe("a decal that is given another size", () => {
  const query = queryOf(cylinder());
  const placed = placeOnSurface(query, hitFrom(query, new Vector3(0, 0, 4)), 0.4, 4, view, null);
  const sized = (pose: typeof placed, width: number): typeof placed =>
    resized(query, pose, { ...pose, size: new Vector3(width, width / 4, pose.size.z) });

  it("reaches over the surface's curve as a new one of that size does, however it came to it", () => {
    const large = placeOnSurface(query, hitFrom(query, new Vector3(0, 0, 4)), 1.6, 4, view, null);
    // The new one leans as the normals under it do on the average.
    expect(sized(placed, 1.6).size.z / large.size.z).toBeCloseTo(1, 1);
    expect(sized(sized(placed, 0.9), 1.6).size.z).toBeCloseTo(sized(placed, 1.6).size.z, 9);
    expect(sized(sized(placed, 1.6), 0.4).size.z).toBeCloseTo(placed.size.z, 9);
  });

  it("stays as shallow for its size as it was made, and as deep where its size is the same", () => {
    const shallow = { ...placed, size: placed.size.clone().setZ(placed.size.z / 2) };
    expect(sized(shallow, 1.6).size.z).toBeCloseTo(sized(placed, 1.6).size.z / 2, 9);
    expect(sized(shallow, 0.4)).toEqual(shallow);
  });
});

describe("a new decal", () => {
  it("is centred on the surface, faces along its normal and stands upright", () => {
    const query = queryOf(cylinder());
    const hit = hitFrom(query, new Vector3(3, 0, 3));
    const pose = placeOnSurface(query, hit, 0.4, 2, view, null);
    expectVector(pose.position, hit.position);
    expect(axisOf(pose, 2).angleTo(new Vector3(1, 0, 1))).toBeLessThan(0.05);
    expectVector(axisOf(pose, 1), new Vector3(0, 1, 0), 0.02);
    expect([pose.size.x, pose.size.y]).toEqual([0.4, 0.2]);
  });

  it("is upright to the camera on a level surface", () => {
    const query = queryOf(cube());
    const hit = hitFrom(query, new Vector3(0, 4, 0.001));
    const slanted = { right: new Vector3(0, 0, -1), up: new Vector3(-0.6, 0.8, 0) };
    const pose = placeOnSurface(query, hit, 0.4, 1, slanted, null);
    expectVector(axisOf(pose, 2), new Vector3(0, 1, 0), 1e-6);
    expectVector(axisOf(pose, 1), new Vector3(-1, 0, 0), 1e-6);
  });

  it("is deep enough to reach over the surface's curve at its rims", () => {
    const query = queryOf(cylinder());
    const pose = placeOnSurface(query, hitFrom(query, new Vector3(0, 0, 4)), 1.6, 4, view, null);
    const dropAtRim = 1 - Math.sqrt(1 - 0.8 ** 2);
    expect(pose.size.z / 2).toBeGreaterThanOrEqual(dropAtRim * 0.99);
  });

  it("does not reach a second surface behind that faces the same way", () => {
    const behind = sheet();
    behind.translate(0, 0, -0.1);
    const pose = placeOnSurface(
      queryOf(sheet(), behind),
      hitFrom(queryOf(sheet()), new Vector3(0, 0, 4)),
      1,
      1,
      view,
      null,
    );
    expect(pose.size.z / 2).toBeLessThan(0.1);
    expect(pose.size.z).toBeGreaterThan(0);
  });

  it("takes over roll and depth of the one that it replaces", () => {
    const query = queryOf(cylinder());
    const keep = poseAt({ turn: radians(30), axis: [0, 0, 1], size: [1, 1, 0.37] });
    const pose = placeOnSurface(query, hitFrom(query, new Vector3(4, 0, 0)), 0.4, 1, view, keep);
    expect(rollOf(pose.rotation)).toBeCloseTo(radians(30), 2);
    expect(pose.size.z).toBe(0.37);
  });
});

describe("the foot of a box", () => {
  it("is the surface beneath its centre along its own axis", () => {
    const foot = footOf(queryOf(sheet()), poseAt({ position: [0.2, 0.1, 0.3], size: [1, 1, 1] }));
    expectVector(foot?.position as Vector3, new Vector3(0.2, 0.1, 0), 1e-6);
  });

  it("is the nearest point where the axis meets nothing", () => {
    const foot = footOf(queryOf(sheet()), poseAt({ position: [1.5, 0, 0], size: [1, 1, 1] }));
    expectVector(foot?.position as Vector3, new Vector3(1, 0, 0), 1e-6);
  });
});

describe("a nudge", () => {
  it("moves along a flat surface as the view sees it, by the given distance", () => {
    const query = queryOf(sheet());
    const moved = nudgeOnSurface(query, poseAt({ size: [0.2, 0.2, 0.2] }), view, 0.05, -0.02);
    expectVector(moved.position, new Vector3(0.05, -0.02, 0), 1e-6);
    expect(moved.rotation.angleTo(new Quaternion())).toBeLessThan(1e-6);
  });

  it("follows a cylinder round and stays upright and on the surface", () => {
    const query = queryOf(cylinder());
    let pose = placeOnSurface(query, hitFrom(query, new Vector3(0, 0, 4)), 0.3, 1, view, null);
    for (let step = 0; step < 30; step++) {
      pose = nudgeOnSurface(query, pose, view, 0.05, 0);
    }
    const radius = Math.hypot(pose.position.x, pose.position.z);
    expect(radius).toBeCloseTo(1, 2);
    expect(Math.atan2(pose.position.x, pose.position.z)).toBeGreaterThan(radians(60));
    expect(axisOf(pose, 1).y).toBeGreaterThan(0.999);
    expectVector(axisOf(pose, 2), pose.position.clone().setY(0).normalize(), 0.05);
  });

  it("goes right on the screen for a decal that is seen from behind the model", () => {
    const query = queryOf(cylinder());
    const fromBehind = { right: new Vector3(-1, 0, 0), up: new Vector3(0, 1, 0) };
    const pose = placeOnSurface(query, hitFrom(query, new Vector3(0, 0, -4)), 0.3, 1, fromBehind, null);
    const moved = nudgeOnSurface(query, pose, fromBehind, 0.1, 0);
    expect(moved.position.x).toBeLessThan(pose.position.x - 0.05);
  });

  it("stays at the edge of an open sheet", () => {
    const query = queryOf(sheet());
    let pose = poseAt({ position: [0.98, 0, 0], size: [0.2, 0.2, 0.2] });
    for (let step = 0; step < 5; step++) {
      pose = nudgeOnSurface(query, pose, view, 0.05, 0);
    }
    expect(pose.position.x).toBeLessThanOrEqual(1 + 1e-6);
    expect(pose.position.z).toBeCloseTo(0, 6);
  });
});

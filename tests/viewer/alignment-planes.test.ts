import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import {
  type AlignmentPlane,
  broughtOnto,
  centredOn,
  chosenPlanes,
  distanceFrom,
  planesOf,
  planesThrough,
  waysOnto,
} from "../../web/viewer/alignment-planes.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { axisOf, type DecalPose } from "../../web/viewer/decal-pose.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import { cube, cylinder, queryOf, sphere } from "./surface-helpers.ts";

const view = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
const MIDDLE: AlignmentPlane = { point: new Vector3(), normal: new Vector3(1, 0, 0), of: null };

/** A decal a third as high as it is wide, where a ray from outside through the axis at that height meets the shape. */
function placed(query: SurfaceQuery, eye: Vector3): DecalPose {
  const towards = new Vector3(0, eye.y, 0).sub(eye).normalize();
  const hit = query.raycast(eye, towards) as SurfaceSample;
  return placeOnSurface(query, hit, 0.3, 3, view, null);
}

/** How far a decal's middle is from the surface, metres. */
function liftOf(query: SurfaceQuery, pose: DecalPose): number {
  return (query.closest(pose.position) as SurfaceSample).position.distanceTo(pose.position);
}

describe("a decal that comes into line", () => {
  const shapes = [
    ["a cylinder", queryOf(cylinder())],
    ["a sphere", queryOf(sphere())],
    ["a cube", queryOf(cube())],
  ] as const;

  it.each(shapes)("lies in the middle of %s, on its surface and facing as that does", (_, query) => {
    for (const aside of [-0.3, -0.02, 0.001, 0.15]) {
      const pose = broughtOnto(query, placed(query, new Vector3(aside, 0.2, 4)), [MIDDLE]) as DecalPose;
      expect(Math.abs(pose.position.x)).toBeLessThan(1e-5);
      expect(liftOf(query, pose)).toBeLessThan(2e-3);
      expect(Math.abs(axisOf(pose, 2).x)).toBeLessThan(0.02);
      expect(pose.size).toEqual(placed(query, new Vector3(aside, 0.2, 4)).size);
    }
  });

  it.each(shapes)("lies straight under another one on %s, and in the model's middle height at once", (_, query) => {
    const other = placed(query, new Vector3(0.2, 0.6, 4));
    const height = { point: new Vector3(), normal: new Vector3(0, 1, 0), of: null };
    const [down] = planesOf(other) as [AlignmentPlane, AlignmentPlane];
    const pose = broughtOnto(query, placed(query, new Vector3(0.26, 0.05, 4)), [down, height]) as DecalPose;
    expect(Math.abs(distanceFrom(down, pose))).toBeLessThan(1e-5);
    expect(Math.abs(pose.position.y)).toBeLessThan(1e-5);
    expect(liftOf(query, pose)).toBeLessThan(2e-3);
  });

  it("stays where it is when it lies in line already", () => {
    const query = queryOf(cylinder());
    const there = broughtOnto(query, placed(query, new Vector3(0.1, 0, 4)), [MIDDLE]) as DecalPose;
    expect(broughtOnto(query, there, [MIDDLE])).toBe(there);
  });

  it("is not brought to where the surface does not lead", () => {
    const query = queryOf(cube());
    const beside = { point: new Vector3(5, 0, 0), normal: new Vector3(1, 0, 0), of: null };
    expect(broughtOnto(query, placed(query, new Vector3(0.1, 0.2, 4)), [beside])).toBeNull();
  });
});

describe("a decal that is centred on its model", () => {
  const middles = ([0, 1, 2] as const).map((axis) => ({ ...MIDDLE, normal: new Vector3().setComponent(axis, 1) }));

  it("comes into the middle of its width from all over its side, and keeps its height", () => {
    const query = queryOf(cylinder());
    for (const aside of [-0.6, -0.1, 0.5]) {
      const pose = centredOn(query, placed(query, new Vector3(aside * 4, 0.3, 4)), middles) as DecalPose;
      expect(Math.abs(pose.position.x)).toBeLessThan(1e-5);
      expect(pose.position.y).toBeCloseTo(0.3, 2);
    }
  });

  it("goes by its own right where it lies on its side", () => {
    const query = queryOf(cylinder());
    const upright = placed(query, new Vector3(0.8, 0.3, 4));
    const quarter = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), Math.PI / 2);
    const lying = { ...upright, rotation: upright.rotation.clone().multiply(quarter) };
    const pose = centredOn(query, lying, middles) as DecalPose;
    expect(Math.abs(pose.position.y)).toBeLessThan(1e-5);
  });
});

describe("what a decal can come into line with", () => {
  const query = queryOf(cube());
  const pose = placed(query, new Vector3(0.1, 0.2, 4));

  it("is the model's middles that cut through the surface there, by their distance", () => {
    const middles = ([0, 1, 2] as const).map((axis) => ({ ...MIDDLE, normal: new Vector3().setComponent(axis, 1) }));
    const ways = waysOnto(middles, pose);
    expect(ways.map(({ plane }) => middles.indexOf(plane))).toEqual([0, 1]);
    expect(ways[0]?.way.length()).toBeCloseTo(Math.abs(pose.position.x), 9);
    expect(ways[1]?.way.length()).toBeCloseTo(Math.abs(pose.position.y), 9);
  });

  it("is no decal on another side of the model", () => {
    const behind = placed(query, new Vector3(0.1, 0.2, -4));
    const aside = placed(query, new Vector3(4, 0.2, 0.1));
    expect(waysOnto([...planesOf(behind), ...planesOf(aside)], pose)).toEqual([]);
    expect(waysOnto(planesOf(placed(query, new Vector3(0.6, 0.2, 4))), pose)).toHaveLength(2);
  });

  it("are two lines that cross, the nearest first, and not two that run side by side", () => {
    const near = planesOf(placed(query, new Vector3(0.12, 0.8, 4)));
    const far = planesOf(placed(query, new Vector3(0.14, -0.8, 4)));
    const ways = waysOnto([...far, ...near], pose).sort((one, other) => one.way.length() - other.way.length());
    const [first, second] = chosenPlanes(ways, pose) as [AlignmentPlane, AlignmentPlane];
    expect(first).toBe(near[0]);
    expect(Math.abs(first.normal.dot(second.normal))).toBeLessThan(0.1);
    expect(chosenPlanes(ways.slice(0, 2), pose)).toHaveLength(1);
  });

  it("is told once it lies there, all that it lies in", () => {
    const other = placed(query, new Vector3(0, 0.8, 4));
    const planes = [MIDDLE, ...planesOf(other)];
    const there = broughtOnto(query, pose, [MIDDLE]) as DecalPose;
    expect(planesThrough(planes, pose)).toEqual([]);
    expect(planesThrough(planes, there)).toEqual([planes[0], planes[1]]);
  });
});

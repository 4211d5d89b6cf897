import { Quaternion, Vector3 } from "three";
import { expect } from "vitest";
import type { PerspectiveProjector } from "../../web/engine/engine-api.ts";
import type { DecalPose } from "../../web/viewer/decal-pose.ts";
import { toView } from "../../web/viewer/projector-sight.ts";

export function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

type Triple = [number, number, number];

/** A pose turned by `turn` radians about `axis`; a unit cube at the origin without options. */
export function poseAt(options: { position?: Triple; turn?: number; axis?: Triple; size?: Triple }): DecalPose {
  const axis = new Vector3(...(options.axis ?? [0, 1, 0])).normalize();
  return {
    position: new Vector3(...(options.position ?? [0, 0, 0])),
    rotation: new Quaternion().setFromAxisAngle(axis, options.turn ?? 0),
    size: new Vector3(...(options.size ?? [1, 1, 1])),
  };
}

/** Where a slide's picture shows a point of model space, decal space; null behind its eye. */
export function slideSpot(slide: PerspectiveProjector, point: Vector3): { x: number; y: number } | null {
  const { x, y, z } = toView(slide, point);
  if (z >= 0) return null;
  const halfHeight = -z * Math.tan(radians(slide.fov) / 2);
  return { x: x / (2 * halfHeight * slide.aspect), y: y / (2 * halfHeight) };
}

export function expectVector(actual: Vector3, expected: Vector3, tolerance = 1e-9): void {
  expect(
    actual.distanceTo(expected),
    `(${actual.toArray().join(", ")}) is not (${expected.toArray().join(", ")})`,
  ).toBeLessThanOrEqual(tolerance);
}

/** Which materials a projector reaches: those with a triangle inside its volume that its light meets from the front. */
import { type Box3, Plane, type Triangle, Vector3 } from "three";
import type { Projector, UvProjector } from "../engine/engine-api.ts";
import { rotationOf } from "./projector-sight.ts";

/** A projector's volume as a query asks for it; for a label its bounding box, which is larger. */
export interface ReachVolume {
  /** Whether a box may hold some of the volume. */
  touchesBox(box: Box3): boolean;
  /** Whether some of the triangle lies inside and looks at the projector. */
  reachesTriangle(triangle: Triangle): boolean;
}

/** Null for the flat stamp, which lies in the texture alone. With `backfaces`, surfaces that look away count too. */
export function reachVolume(projector: Projector, backfaces: boolean): ReachVolume | null {
  if (projector.kind === "uv") return null;
  const planes = boundingPlanes(projector);
  const towards = lightDirection(projector);
  const corner = new Vector3();
  const normal = new Vector3();
  return {
    touchesBox: ({ min, max }) =>
      planes.every((plane) => {
        const { x, y, z } = plane.normal;
        corner.set(x > 0 ? max.x : min.x, y > 0 ? max.y : min.y, z > 0 ? max.z : min.z);
        return plane.distanceToPoint(corner) >= 0;
      }),
    reachesTriangle(triangle) {
      let inside: Vector3[] = [triangle.a, triangle.b, triangle.c];
      for (const plane of planes) {
        inside = clipped(inside, plane);
        if (inside.length === 0) return false;
      }
      triangle.getNormal(normal);
      return backfaces || inside.some((point) => normal.dot(towards(point)) > 0);
    },
  };
}

/** Planes whose normals look inward, model space. */
function boundingPlanes(projector: Exclude<Projector, UvProjector>): Plane[] {
  const rotation = rotationOf(projector);
  const origin = new Vector3(...projector.position);
  // A plane through `point` of the projector's own axes, metres.
  const plane = (normal: Vector3, point = new Vector3()): Plane =>
    new Plane().setFromNormalAndCoplanarPoint(
      normal.normalize().applyQuaternion(rotation),
      point.applyQuaternion(rotation).add(origin),
    );
  const slab = (low: Vector3, high: Vector3): Plane[] =>
    [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].flatMap((axis) => [
      plane(axis.clone(), low.clone()),
      plane(axis.clone().negate(), high.clone()),
    ]);
  if (projector.kind === "planar") {
    const half = new Vector3(...projector.size).multiplyScalar(0.5);
    return slab(half.clone().negate(), half);
  }
  if (projector.kind === "perspective") {
    const rise = Math.tan((projector.fov * Math.PI) / 360);
    const run = rise * projector.aspect;
    return [
      plane(new Vector3(0, 0, -1), new Vector3(0, 0, -projector.near)),
      plane(new Vector3(0, 0, 1), new Vector3(0, 0, -projector.far)),
      plane(new Vector3(1, 0, -run)),
      plane(new Vector3(-1, 0, -run)),
      plane(new Vector3(0, 1, -rise)),
      plane(new Vector3(0, -1, -rise)),
    ];
  }
  const { height, arc } = projector;
  const half = (Math.min(arc, 360) * Math.PI) / 360;
  const outer = projector.radius + projector.depth;
  const inner = Math.max(0, projector.radius - projector.depth);
  const side = outer * Math.sin(Math.min(half, Math.PI / 2));
  const back = half > Math.PI / 2 ? outer * Math.cos(half) : inner * Math.cos(half);
  return slab(new Vector3(-side, -height / 2, back), new Vector3(side, height / 2, outer));
}

/** From a point towards where the light comes from; the length does not matter. */
function lightDirection(projector: Exclude<Projector, UvProjector>): (point: Vector3) => Vector3 {
  const rotation = rotationOf(projector);
  const origin = new Vector3(...projector.position);
  if (projector.kind === "planar") {
    const forward = new Vector3(0, 0, 1).applyQuaternion(rotation);
    return () => forward;
  }
  if (projector.kind === "perspective") return (point) => origin.clone().sub(point);
  const axis = new Vector3(0, 1, 0).applyQuaternion(rotation);
  return (point) => {
    const fromMiddle = point.clone().sub(origin);
    return fromMiddle.addScaledVector(axis, -fromMiddle.dot(axis));
  };
}

/** The part of a convex polygon in front of a plane (Sutherland and Hodgman). */
function clipped(polygon: readonly Vector3[], plane: Plane): Vector3[] {
  const kept: Vector3[] = [];
  polygon.forEach((point, index) => {
    const next = polygon[(index + 1) % polygon.length] as Vector3;
    const here = plane.distanceToPoint(point);
    const there = plane.distanceToPoint(next);
    if (here >= 0) kept.push(point);
    if (here * there < 0) kept.push(point.clone().lerp(next, here / (here - there)));
  });
  return kept;
}

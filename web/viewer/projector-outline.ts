/** Lines that show a projector which is no box: its picture's border on the surface, and its volume's edges. */
import { Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector, UvProjector } from "../engine/engine-api.ts";
import { type OutlinePoint, POINTS_PER_EDGE, rectangleBorder } from "./decal-outline.ts";
import type { DecalPose } from "./decal-pose.ts";
import { type PictureRay, pictureRay } from "./picture-ray.ts";
import { rotationOf } from "./projector-sight.ts";
import type { SurfaceQuery } from "./surface-query.ts";

type ThrownProjector = PerspectiveProjector | CylindricalProjector;

/** Points of a volume's curved edge from end to end. */
const ARC_PIECES = 24;

/** The picture's border where its rays meet the surface; empty for the flat stamp, which lies in the texture alone. */
export function throwOutline(
  query: SurfaceQuery,
  projector: ThrownProjector | UvProjector,
  pointsPerEdge = POINTS_PER_EDGE,
): OutlinePoint[] {
  if (projector.kind === "uv") return [];
  const lift = query.bounds.radius * 0.002;
  return rectangleBorder(pointsPerEdge).flatMap(([x, y]) => {
    const ray = pictureRay(projector, x, y);
    if (ray === null) return [];
    const hit = query.raycast(ray.origin, ray.direction, ray.length);
    const distance = hit === null ? restingDistance(query, projector, ray) : hit.distance - lift;
    return { position: along(ray, distance), height: 0, onSurface: hit !== null };
  });
}

/** The volume's edges as polylines, model space. No longer than it takes to pass the model. */
export function volumeEdges(query: SurfaceQuery, projector: Projector): Vector3[][] {
  if (projector.kind === "planar" || projector.kind === "uv") return [];
  const ends = (x: number, y: number): readonly [Vector3, Vector3] => {
    const ray = pictureRay(projector, x, y) as PictureRay;
    return [ray.origin, along(ray, Math.min(ray.length, passing(query, ray)))];
  };
  const corners = [ends(-0.5, -0.5), ends(0.5, -0.5), ends(0.5, 0.5), ends(-0.5, 0.5)] as const;
  const spokes = corners.map(([near, far]) => [near, far]);
  const pieces = projector.kind === "cylindrical" ? ARC_PIECES : 1;
  const rim = (end: 0 | 1, y: number): Vector3[] =>
    Array.from({ length: pieces + 1 }, (_, piece) => ends(piece / pieces - 0.5, y)[end]);
  const sides = ([0, 1] as const).flatMap((end) => [
    rim(end, -0.5),
    rim(end, 0.5),
    [corners[0][end], corners[3][end]],
    [corners[1][end], corners[2][end]],
  ]);
  return [...spokes, ...sides];
}

/** A box about the place where the picture's middle meets the surface, for the camera to look at; null without one. */
export function pictureBox(query: SurfaceQuery, projector: Projector): DecalPose | null {
  if (projector.kind === "planar" || projector.kind === "uv") return null;
  const ray = pictureRay(projector, 0, 0) as PictureRay;
  const hit = query.raycast(ray.origin, ray.direction, ray.length);
  const distance = hit?.distance ?? restingDistance(query, projector, ray);
  const rotation = rotationOf(projector);
  const position = along(ray, distance);
  if (projector.kind === "cylindrical") {
    const width = 2 * projector.radius * Math.sin((Math.min(projector.arc, 180) * Math.PI) / 360);
    return { position, rotation, size: new Vector3(width, projector.height, projector.depth) };
  }
  const height = 2 * (projector.near + distance) * Math.tan((projector.fov * Math.PI) / 360);
  return { position, rotation, size: new Vector3(height * projector.aspect, height, height) };
}

/** Where a ray's point is drawn that meets no surface: on the radius; as far away as the model's middle. */
function restingDistance(query: SurfaceQuery, projector: ThrownProjector, ray: PictureRay): number {
  if (projector.kind === "cylindrical") return Math.min(projector.depth, ray.length);
  const middle = query.bounds.center.clone().sub(ray.origin).dot(ray.direction);
  return Math.min(Math.max(0, middle), ray.length);
}

/** How far a ray runs until it has surely left the model. */
function passing(query: SurfaceQuery, ray: PictureRay): number {
  return query.bounds.center.distanceTo(ray.origin) + query.bounds.radius;
}

function along(ray: PictureRay, distance: number): Vector3 {
  return ray.origin.clone().addScaledVector(ray.direction, distance);
}

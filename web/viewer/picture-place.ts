/** Where a projector's picture lies on the surface, whatever its kind: what one kind hands over to another. */
import { Vector3 } from "three";
import type { Projector, UvProjector } from "../engine/engine-api.ts";
import { axisOf, poseOf } from "./decal-pose.ts";
import { pictureRay } from "./picture-ray.ts";
import { rotationOf } from "./projector-sight.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";

/** The picture's middle on the surface, and the ways from there to its sides. Metres, model space. */
export interface PicturePlace {
  readonly position: Vector3;
  /** Unit; the surface's own. */
  readonly normal: Vector3;
  /** From the picture's left side to its right one, as long as the picture is wide. */
  readonly right: Vector3;
  /** From its bottom to its top. */
  readonly up: Vector3;
}

/** The surface at a place of the texture on which a flat stamp lies; null where no triangle is. */
export type SurfaceOfStamp = (uv: readonly [number, number]) => SurfaceSample | null;

/** Share of a stamp's size in which its directions on the surface are measured. */
const STAMP_STEP = 0.02;

/** Null where the picture's middle meets no surface at all. */
export function placeOfPicture(
  query: SurfaceQuery,
  projector: Projector,
  surfaceOfStamp: SurfaceOfStamp,
): PicturePlace | null {
  if (projector.kind === "uv") return placeOfStamp(projector, surfaceOfStamp);
  const ray = pictureRay(projector, 0, 0);
  if (ray === null) return null;
  const end = ray.origin.clone().addScaledVector(ray.direction, ray.length / 2);
  const hit = query.raycast(ray.origin, ray.direction, ray.length) ?? query.closest(end);
  if (hit === null) return null;
  const { position, normal } = hit;
  const rotation = rotationOf(projector);
  const [x, y] = [new Vector3(1, 0, 0).applyQuaternion(rotation), new Vector3(0, 1, 0).applyQuaternion(rotation)];
  const sized = (width: number, height: number): PicturePlace => ({
    position,
    normal,
    right: x.multiplyScalar(width),
    up: y.multiplyScalar(height),
  });
  if (projector.kind === "planar") {
    const pose = poseOf(projector);
    // A box that was missed keeps its own direction: the nearest surface may look anywhere.
    const facing = axisOf(pose, 2).dot(normal) > 0 ? normal : axisOf(pose, 2);
    return { ...sized(pose.size.x, pose.size.y), normal: facing };
  }
  if (projector.kind === "cylindrical") {
    return sized((projector.radius * projector.arc * Math.PI) / 180, projector.height);
  }
  const depth = position
    .clone()
    .sub(new Vector3(...projector.position))
    .dot(ray.direction);
  const height = 2 * depth * Math.tan((projector.fov * Math.PI) / 360);
  return sized(height * projector.aspect, height);
}

function placeOfStamp({ center, size, angle }: UvProjector, surfaceOfStamp: SurfaceOfStamp): PicturePlace | null {
  const middle = surfaceOfStamp(center);
  if (middle === null) return null;
  const radians = (angle * Math.PI) / 180;
  const alongX = [Math.cos(radians), Math.sin(radians)] as const;
  const alongY = [Math.sin(radians), -Math.cos(radians)] as const;
  const measured = ([du, dv]: readonly [number, number], extent: number): Vector3 | null => {
    for (const step of [STAMP_STEP * extent, -STAMP_STEP * extent]) {
      const beside = surfaceOfStamp([center[0] + du * step, center[1] + dv * step]);
      if (beside !== null)
        return beside.position
          .clone()
          .sub(middle.position)
          .multiplyScalar(extent / step);
    }
    return null;
  };
  const right = measured(alongX, size[0]);
  const up = measured(alongY, size[1]);
  return right && up && { position: middle.position, normal: middle.normal, right, up };
}

/**
 * The flat stamp that covers a place, by the texture's own scale there; null where the surface has no texture coordinates.
 * A chart that is mirrored in the texture shows the stamp's picture mirrored.
 */
export function stampAt(query: SurfaceQuery, place: PicturePlace): UvProjector | null {
  const middle = query.closest(place.position);
  if (middle === null) return null;
  const measured = (way: Vector3): readonly [number, number] | null => {
    for (const share of [STAMP_STEP, -STAMP_STEP]) {
      const beside = query.closest(place.position.clone().addScaledVector(way, share));
      if (beside === null) continue;
      const [du, dv] = [beside.uv[0] - middle.uv[0], beside.uv[1] - middle.uv[1]];
      // A step over a seam lands anywhere in the texture.
      if (Math.hypot(du, dv) < 0.25) return [du / share, dv / share];
    }
    return null;
  };
  const alongX = measured(place.right);
  const alongY = measured(place.up);
  if (alongX === null || alongY === null) return null;
  const size = [Math.hypot(...alongX), Math.hypot(...alongY)] as const;
  if (!(size[0] > 1e-5 && size[1] > 1e-5)) return null;
  const angle = (Math.atan2(alongX[1], alongX[0]) * 180) / Math.PI;
  const inTile = (value: number): number => value - Math.floor(value);
  return { kind: "uv", center: [inTile(middle.uv[0]), inTile(middle.uv[1])], size, angle };
}

/** The rays that draw a picture's border on the model (spec.md, section 3). No DOM, no scene. */
import { Vector3 } from "three";
import type { Projector } from "../engine/engine-api.ts";
import { axisOf, poseOf } from "./decal-pose.ts";
import { rotationOf } from "./projector-sight.ts";

/** A ray towards the surface, along which a point of the picture is thrown. */
export interface PictureRay {
  readonly origin: Vector3;
  /** Unit. */
  readonly direction: Vector3;
  /** Metres inside the volume. */
  readonly length: number;
}

/** The ray that throws a point of the picture (decal space, x and y); null for the flat stamp, which throws nothing. */
export function pictureRay(projector: Projector, x: number, y: number): PictureRay | null {
  if (projector.kind === "planar") {
    const { position, size } = poseOf(projector);
    const rotation = rotationOf(projector);
    const origin = new Vector3(x * size.x, y * size.y, size.z / 2).applyQuaternion(rotation).add(position);
    return { origin, direction: axisOf(poseOf(projector), 2).negate(), length: size.z };
  }
  if (projector.kind === "uv") {
    return null;
  }
  const rotation = rotationOf(projector);
  const position = new Vector3(...projector.position);
  if (projector.kind === "perspective") {
    const half = Math.tan((projector.fov * Math.PI) / 360);
    const way = new Vector3(2 * x * half * projector.aspect, 2 * y * half, -1);
    const direction = way.clone().applyQuaternion(rotation);
    const origin = direction.clone().multiplyScalar(projector.near).add(position);
    const perDepth = way.length();
    return { origin, direction: direction.normalize(), length: (projector.far - projector.near) * perDepth };
  }
  const angle = (x * projector.arc * Math.PI) / 180;
  const outward = new Vector3(Math.sin(angle), 0, Math.cos(angle));
  const inner = Math.max(0, projector.radius - projector.depth);
  const outer = projector.radius + projector.depth;
  const origin = outward
    .clone()
    .multiplyScalar(outer)
    .setY(y * projector.height);
  return {
    origin: origin.applyQuaternion(rotation).add(position),
    direction: outward.negate().applyQuaternion(rotation),
    length: outer - inner,
  };
}

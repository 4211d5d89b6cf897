/** Drags and steps of projectors that are no boxes, by their picture. */
import { Quaternion, Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector, UvProjector } from "../engine/engine-api.ts";
import type { PictureGrab, ProjectorDrag } from "./box-drag.ts";
import { minimalRotation, tupleOf } from "./decal-pose.ts";
import { rotationOf, toView } from "./projector-sight.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** The point of the picture that was grabbed keeps under the pointer. */
export function pictureDrag(
  query: SurfaceQuery,
  start: Exclude<Projector, { kind: "planar" }>,
  grab: PictureGrab,
): ProjectorDrag {
  let material: number | null = null;
  return {
    kind: "slide",
    get material() {
      return material;
    },
    readout: () => null,
    move({ ray, met }) {
      const target = met === undefined ? query.raycast(ray.origin, ray.direction) : met;
      if (target === null) {
        return null;
      }
      material = target.material;
      if (start.kind === "perspective") return swung(start, grab.position, target.position);
      if (start.kind === "cylindrical") return turnedRound(start, grab.position, target.position);
      return grab.uv === undefined ? null : shifted(start, target.uv[0] - grab.uv[0], target.uv[1] - grab.uv[1]);
    },
  };
}

/** A projector moved by steps as the view sees them, metres: keyboard nudges. `extent`: the model's own size, metres. */
export function nudged(
  projector: Exclude<Projector, { kind: "planar" }>,
  axes: { readonly right: Vector3; readonly up: Vector3 },
  rightMetres: number,
  upMetres: number,
  extent: number,
): Projector {
  if (projector.kind === "uv") {
    return shifted(projector, rightMetres / extent, -upMetres / extent);
  }
  if (projector.kind === "cylindrical") {
    return rolled(projector, rightMetres / projector.radius, upMetres);
  }
  const position = new Vector3(...projector.position)
    .addScaledVector(axes.right, rightMetres)
    .addScaledVector(axes.up, upMetres);
  return { ...projector, position: tupleOf(position) };
}

/** The eye stays where it is and looks from one point to another. */
function swung(start: PerspectiveProjector, from: Vector3, to: Vector3): Projector | null {
  const eye = new Vector3(...start.position);
  const before = from.clone().sub(eye).normalize();
  const after = to.clone().sub(eye).normalize();
  if (before.lengthSq() === 0 || after.lengthSq() === 0) {
    return null;
  }
  const rotation = minimalRotation(before, after).multiply(rotationOf(start)).normalize();
  return { ...start, rotation: [rotation.x, rotation.y, rotation.z, rotation.w] };
}

/** A label turned about its axis and moved along it as what lies on it goes from one place to another. */
export function turnedRound(start: CylindricalProjector, from: Vector3, to: Vector3): CylindricalProjector {
  const before = toView(start, from);
  const after = toView(start, to);
  return rolled(start, Math.atan2(after.x, after.z) - Math.atan2(before.x, before.z), after.y - before.y);
}

/** Turned about its own axis, radians from +Z towards +X, and moved along it, metres. */
export function rolled(start: CylindricalProjector, angle: number, along: number): CylindricalProjector {
  const rotation = rotationOf(start);
  const position = new Vector3(0, along, 0).applyQuaternion(rotation).add(new Vector3(...start.position));
  rotation.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), angle)).normalize();
  return {
    ...start,
    position: tupleOf(position),
    rotation: [rotation.x, rotation.y, rotation.z, rotation.w],
  };
}

function shifted(start: UvProjector, u: number, v: number): UvProjector {
  return { ...start, center: [start.center[0] + u, start.center[1] + v] };
}

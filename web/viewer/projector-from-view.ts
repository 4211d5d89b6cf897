/** Projectors that throw a picture from where the camera stands: what it covers on the screen is what it paints. */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { PerspectiveProjector } from "../engine/engine-api.ts";
import { tupleOf } from "./decal-pose.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** Degrees; wider or narrower a picture says nothing any more. */
const LEAST_FOV = 0.1;
const WIDEST_FOV = 170;
/** The range from near to far holds the model with this much room, in its radii. */
const ROOM = 1.05;
/** Nearer than this to the eye nothing is painted, in the model's radii. */
const NEAREST = 0.01;

/**
 * The projector at `eye` whose picture covers the same part of the view as a quadrilateral does now.
 *
 * @param corners bottom left, bottom right, top right, top left as the picture's viewer sees them; model space, metres
 * @param aspect width by height of the new picture; null takes what the corners show, however squeezed
 * @returns null where the corners are not seen from the eye
 */
export function projectorFromView(
  query: SurfaceQuery,
  corners: readonly [Vector3, Vector3, Vector3, Vector3],
  eye: Vector3,
  aspect: number | null,
): PerspectiveProjector | null {
  let forward = directionTo(corners, eye);
  // The mean of directions is not the middle of what is seen: the second round takes that.
  for (let round = 0; round < 2; round++) {
    const seen = corners.map((corner) => onPlane(corner, eye, forward));
    if (seen.some((point) => point === null)) return null;
    const [sw, se, ne, nw] = seen as [Vector3, Vector3, Vector3, Vector3];
    const middle = meanOf([sw, se, ne, nw]);
    const right = meanOf([se, ne]).sub(meanOf([sw, nw]));
    const up = meanOf([ne, nw]).sub(meanOf([se, sw]));
    if (round === 0) {
      forward = middle.normalize();
      continue;
    }
    const backward = forward.clone().negate();
    // Where the quadrilateral leans, the picture stands between its two directions.
    const y = up.clone().normalize().add(backward.clone().cross(right).normalize()).normalize();
    const x = new Vector3().crossVectors(y, backward).normalize();
    let [width, height] = [right.dot(x), up.dot(y)];
    if (!(width > 1e-9 && height > 1e-9)) return null;
    if (aspect !== null) {
      const area = width * height;
      height = Math.sqrt(area / aspect);
      width = height * aspect;
    }
    const rotation = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, backward));
    return {
      kind: "perspective",
      position: tupleOf(eye),
      rotation: [rotation.x, rotation.y, rotation.z, rotation.w],
      fov: Math.min(WIDEST_FOV, Math.max(LEAST_FOV, (Math.atan(height / 2) * 360) / Math.PI)),
      aspect: width / height,
      ...rangeAround(query, eye),
    };
  }
  return null;
}

/** Near and far, metres, that hold the whole model. */
export function rangeAround(query: SurfaceQuery, eye: Vector3): { near: number; far: number } {
  const { center, radius } = query.bounds;
  const distance = center.distanceTo(eye);
  return { near: Math.max(distance - ROOM * radius, NEAREST * radius), far: distance + ROOM * radius };
}

function directionTo(points: readonly Vector3[], eye: Vector3): Vector3 {
  return meanOf(points.map((point) => point.clone().sub(eye).normalize())).normalize();
}

/** Where the plane one metre before the eye shows a point, from the eye; null behind it. */
function onPlane(point: Vector3, eye: Vector3, forward: Vector3): Vector3 | null {
  const way = point.clone().sub(eye);
  const depth = way.dot(forward);
  return depth > 1e-9 ? way.divideScalar(depth) : null;
}

function meanOf(points: readonly Vector3[]): Vector3 {
  return points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length);
}

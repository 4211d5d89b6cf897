/**
 * The cylinder that fits a surface round a place, for labels that are wrapped around it.
 *
 * A circle through points p with normals n is p = c + r n: least squares over both gives centre and radius in one step,
 * from an arc as short as a small decal covers. Where the surface is flat there (the chest of a figure made of boxes) the
 * body's thickness tells the middle. Then the whole ring round that middle is looked at and the circle fitted again.
 */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { CylindricalProjector } from "../engine/engine-api.ts";
import { tangentPart, tupleOf, UP_MODEL } from "./decal-pose.ts";
import type { PicturePlace } from "./picture-place.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** Rays along the picture's sides, and how far beyond them they look, as a share of the side. */
const COLUMNS = 11;
const ROWS = 5;
const BEYOND = 0.4;
/** Mean square of the normals' part along an axis by which it may be worse than the best one, and which it may have at all. */
const AS_GOOD = 0.0015;
const PARALLEL = 0.02;
/** Mean square spread of the normals across an axis below which the surface counts as flat (4°). */
const FLAT = 0.005;
/** The ring: heights, and degrees between two rays. */
const RING_HEIGHTS = [-0.4, 0, 0.4] as const;
const RING_STEP = 10;
/** Surfaces farther off the circle than this, in radii, are another part: a mug's handle. */
const OFF_CIRCLE = 0.4;
const LEAST_DEPTH = 0.05;
const MOST_DEPTH = 0.6;

interface Circle {
  readonly center: Vector3;
  readonly radius: number;
}

/** Half of what is looked at, degrees: the label's own share and some more, or all of it where it is guessed at first. */
const WHOLE = 180;
const LEAST_HALF = 60;
const MORE = 1.2;

/** A point with the surface's unit normal. */
interface Sighting {
  readonly position: Vector3;
  readonly normal: Vector3;
}

/** A label of the place's size round the surface there; null where no cylinder fits. */
export function wrapAround(query: SurfaceQuery, place: PicturePlace): CylindricalProjector | null {
  const near = sightingsRound(query, place);
  const axis = axisFor(near, place);
  const curved = circleOf(near, axis, query);
  const begin = curved ?? circleByThickness(query, place, axis);
  if (begin === null) return null;
  const width = place.right.length();
  const height = place.up.length();
  const ownShare = MORE * (width / begin.radius) * (90 / Math.PI);
  const half = curved === null ? WHOLE : Math.min(WHOLE, Math.max(LEAST_HALF, ownShare));
  const circle = refined(query, begin, place, axis, half, height);
  const outward = tangentPart(place.position.clone().sub(circle.center), axis);
  if (outward.lengthSq() < 1e-18) return null;
  outward.normalize();
  const top = axis.clone().multiplyScalar(axis.dot(place.up) < 0 ? -1 : 1);
  const center = circle.center.clone().addScaledVector(axis, place.position.clone().sub(circle.center).dot(axis));
  const right = new Vector3().crossVectors(top, outward);
  const rotation = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(right, top, outward));
  const arc = Math.min(360, (width / circle.radius) * (180 / Math.PI));
  const ring = ringOf(query, { ...circle, center }, outward, axis, arc / 2, height);
  const off = Math.max(0, ...ring.map(({ distance }) => Math.abs(distance - circle.radius)));
  const depth = Math.min(MOST_DEPTH, Math.max(LEAST_DEPTH, (1.3 * off) / circle.radius)) * circle.radius;
  return {
    kind: "cylindrical",
    position: tupleOf(center),
    rotation: [rotation.x, rotation.y, rotation.z, rotation.w],
    radius: circle.radius,
    height,
    arc,
    depth,
  };
}

function sightingsRound(query: SurfaceQuery, place: PicturePlace): Sighting[] {
  const reach = Math.max(place.right.length(), place.up.length());
  const inward = place.normal.clone().negate();
  const found: Sighting[] = [];
  for (let row = 0; row < ROWS; row++) {
    for (let column = 0; column < COLUMNS; column++) {
      const x = (column / (COLUMNS - 1) - 0.5) * (1 + 2 * BEYOND);
      const y = row / (ROWS - 1) - 0.5;
      const origin = place.position
        .clone()
        .addScaledVector(place.right, x)
        .addScaledVector(place.up, y)
        .addScaledVector(place.normal, reach);
      const hit = query.raycast(origin, inward, 3 * reach);
      if (hit !== null && hit.normal.dot(place.normal) > 0.1) found.push(hit);
    }
  }
  return found.length > 0 ? found : [place];
}

/** The model's own directions come first: people stand things upright. */
function axisFor(near: readonly Sighting[], place: PicturePlace): Vector3 {
  const along = (axis: Vector3): number =>
    near.reduce((sum, { normal }) => sum + normal.dot(axis) ** 2, 0) / near.length;
  const ofPicture = tangentPart(place.up, place.normal).normalize();
  const best = leastMet(near, place);
  const enough = Math.min(PARALLEL, 2 * along(best) + AS_GOOD);
  const usual = [new Vector3().copy(UP_MODEL), ofPicture, new Vector3(1, 0, 0), new Vector3(0, 0, 1)];
  return usual.find((axis) => axis.lengthSq() > 0.5 && along(axis) <= enough) ?? best;
}

/** The direction across the mean normal that the normals have the least of: the minor axis of their spread. */
function leastMet(near: readonly Sighting[], place: PicturePlace): Vector3 {
  const mean = meanOf(near.map(({ normal }) => normal)).normalize();
  const x = tangentPart(place.right, mean).normalize();
  const y = new Vector3().crossVectors(mean, x);
  let [xx, xy, yy] = [0, 0, 0];
  for (const { normal } of near) {
    const [u, v] = [normal.dot(x), normal.dot(y)];
    xx += u * u;
    xy += u * v;
    yy += v * v;
  }
  const major = Math.atan2(2 * xy, xx - yy) / 2;
  return y.multiplyScalar(Math.cos(major)).addScaledVector(x, -Math.sin(major));
}

/** Null where the surface is flat, or so nearly that its middle lies beside the model. */
function circleOf(near: readonly Sighting[], axis: Vector3, query: SurfaceQuery): Circle | null {
  const flat = near.map(({ position, normal }) => ({
    position: tangentPart(position, axis),
    normal: tangentPart(normal, axis).normalize(),
  }));
  const middle = meanOf(flat.map(({ position }) => position));
  const mean = meanOf(flat.map(({ normal }) => normal));
  let [shared, spread] = [0, 0];
  for (const { position, normal } of flat) {
    const turn = normal.clone().sub(mean);
    shared += position.clone().sub(middle).dot(turn);
    spread += turn.lengthSq();
  }
  const radius = shared / spread;
  if (!(spread / near.length > FLAT && radius > 0 && radius < query.bounds.radius * 1.5)) return null;
  const inPlane = middle.addScaledVector(mean, -radius);
  const height = meanOf(near.map(({ position }) => position)).dot(axis);
  return { center: inPlane.addScaledVector(axis, height), radius };
}

/** Half way to the surface that looks the other way behind the place. */
function circleByThickness(query: SurfaceQuery, place: PicturePlace, axis: Vector3): Circle | null {
  const outward = tangentPart(place.normal, axis).normalize();
  const far = 2 * query.bounds.radius + query.bounds.center.distanceTo(place.position);
  const origin = place.position.clone().addScaledVector(outward, -far);
  const backs = query.raycastFacing(origin, outward, far).map(({ distance }) => far - distance);
  const least = 0.1 * place.right.length();
  const thickness = Math.min(...backs.filter((depth) => depth > least));
  if (!Number.isFinite(thickness)) return null;
  const radius = thickness / 2;
  return { center: place.position.clone().addScaledVector(outward, -radius), radius };
}

/** The circle by the ring of surface round it; as it was where the ring says nothing better. */
function refined(
  query: SurfaceQuery,
  begin: Circle,
  place: PicturePlace,
  axis: Vector3,
  half: number,
  height: number,
): Circle {
  let circle = begin;
  for (let round = 0; round < 2; round++) {
    const outward = tangentPart(place.position.clone().sub(circle.center), axis).normalize();
    const better = circleThrough(
      ringOf(query, circle, outward, axis, half, height).map(({ position }) => position),
      axis,
    );
    const near = better !== null && better.radius > circle.radius / 2 && better.radius < circle.radius * 2;
    if (!near) return circle;
    circle = better;
  }
  return circle;
}

/** Outward surfaces round a circle, over `half` degrees either side of `outward`; `distance` from the axis, metres. */
function ringOf(
  query: SurfaceQuery,
  { center, radius }: Circle,
  outward: Vector3,
  axis: Vector3,
  half: number,
  height: number,
): { position: Vector3; distance: number }[] {
  const found: { position: Vector3; distance: number }[] = [];
  for (const share of RING_HEIGHTS) {
    for (let angle = -half; angle <= half; angle += RING_STEP) {
      const direction = outward.clone().applyAxisAngle(axis, (angle * Math.PI) / 180);
      const middle = center.clone().addScaledVector(axis, share * height);
      const origin = middle.clone().addScaledVector(direction, radius * (1 + 2 * OFF_CIRCLE));
      const hits = query.raycastFacing(origin, direction.clone().negate(), radius * (1 + 3 * OFF_CIRCLE));
      const nearest = hits
        .map(({ position }) => ({ position, distance: position.distanceTo(middle) }))
        .sort((a, b) => Math.abs(a.distance - radius) - Math.abs(b.distance - radius))[0];
      if (nearest !== undefined && Math.abs(nearest.distance - radius) < OFF_CIRCLE * radius) found.push(nearest);
    }
  }
  return found;
}

/** Algebraic least squares (Kåsa): x² + y² = 2 a x + 2 b y + c, about the points' mean. */
function circleThrough(points: readonly Vector3[], axis: Vector3): Circle | null {
  if (points.length < 6) return null;
  const mean = meanOf(points);
  const x = tangentPart(Math.abs(axis.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0), axis).normalize();
  const y = new Vector3().crossVectors(axis, x);
  let [xx, xy, yy, xz, yz, zz] = [0, 0, 0, 0, 0, 0];
  for (const point of points) {
    const from = point.clone().sub(mean);
    const [u, v] = [from.dot(x), from.dot(y)];
    const square = u * u + v * v;
    xx += u * u;
    xy += u * v;
    yy += v * v;
    xz += u * square;
    yz += v * square;
    zz += square;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-9 * zz * zz)) return null;
  const a = (xz * yy - yz * xy) / (2 * determinant);
  const b = (yz * xx - xz * xy) / (2 * determinant);
  const radius = Math.sqrt(a * a + b * b + zz / points.length);
  return { center: mean.addScaledVector(x, a).addScaledVector(y, b), radius };
}

function meanOf(points: readonly Vector3[]): Vector3 {
  return points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length || 1);
}

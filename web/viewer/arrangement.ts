/**
 * Several pictures turned, sized and moved as one about the middle of the box round all of them, as if they were printed on one
 * sheet: each keeps its way along the surface from there, and how it lies on the surface at that way's end (a geodesic polar
 * map: exact on a plane, the unrolled label on a mug). Every answer is worked out from where they were at first, so nothing adds
 * up however often the box is moved.
 */
import { Quaternion, Vector3 } from "three";
import type { PerspectiveProjector, Projector } from "../engine/engine-api.ts";
import { fittingDepth, smoothedNear } from "./decal-placement.ts";
import {
  axisOf,
  type DecalPose,
  minimalRotation,
  poseOf,
  projectorOf,
  tangentPart,
  tupleOf,
  uprightFrame,
} from "./decal-pose.ts";
import { turnedRound } from "./projector-drag.ts";
import { rotationOf } from "./projector-sight.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { Arrangement } from "./viewer-api.ts";

/** A place on the surface, and how the sheet lies there: its +Z is the surface's normal. */
interface Frame {
  readonly position: Vector3;
  readonly rotation: Quaternion;
}

/** A picture on the sheet. */
interface Lying {
  /** Its middle's foot on the surface: of a thousand it takes its time, and most are never turned. */
  readonly foot: () => Vector3;
  readonly pose: DecalPose;
}

/** Where a picture lies on the sheet, and how it lies on the surface there. */
interface Way {
  /** From the sheet's middle along the surface, by the sheet's own axes, metres. */
  readonly x: number;
  readonly y: number;
  /** From the surface's frame at the way's end. */
  readonly position: Vector3;
  readonly rotation: Quaternion;
}

/** What has become of the sheet. */
interface Change {
  readonly from: Frame;
  readonly to: Frame;
  readonly scale: Vector3;
}

/** Steps of a way over the surface. */
const MOST_STEPS = 8;
const LEAST_STEPS = 2;
/** ...of all ways together: each asks the surface, a fiftieth of a millisecond. */
const STEPS_IN_ALL = 400;
/** Corrections of a way until it ends where it should. What is missing then is carried along as it is. */
const MOST_TRIES = 8;
/** Of a way's length: what may be missing at its end, and of each of many ways. That little, too, is carried along as it is. */
const CLOSE = 1e-9;
const CLOSE_OF_MANY = 1e-4;
/** Of a step: what is nearest lies so far back only behind an edge, or at the surface's border. */
const PASSED = 0.25;
/** Cosine: pictures that look further away than this from their common direction have no middle on the surface. */
const LEAST_FACING = 0.1;
/** So many lie by the surface's normals averaged under each, as in a drag of one; for more it would take too long. */
const MOST_AVERAGED = 24;

const FULL_ARC = 360;
const Z: Readonly<Vector3> = new Vector3(0, 0, 1);
const CORNERS = [
  [0.5, 0.5],
  [0.5, -0.5],
  [-0.5, 0.5],
  [-0.5, -0.5],
] as const;

/** `ModelViewer.arrangement`. */
export function arrangementOf(query: SurfaceQuery, projectors: readonly Projector[]): Arrangement | null {
  const all = projectors.map((projector) => lyingOf(query, projector));
  const lying = all.filter((each) => each !== null);
  const normal = new Vector3();
  for (const { pose } of lying) normal.add(axisOf(pose, 2));
  normal.normalize();
  if (lying.length < 2 || lying.some(({ pose }) => axisOf(pose, 2).dot(normal) < LEAST_FACING)) return null;
  const walk = new Walk(query, lying.length);
  const box = boxRound(query, lying, normal);
  const from = walk.along(box, 0, 0);
  // As with the feet.
  let ways: readonly (Way | null)[] | null = null;
  return {
    box: projectorOf(box),
    at(now) {
      ways ??= all.map((each) => each && wayTo(walk, from, box, each));
      const change = changeOf(walk, from, box, poseOf(now));
      const each = (index: number): [Lying | null, Way | null] => [all[index] ?? null, ways?.[index] ?? null];
      return projectors.map((projector, index) => placed(walk, projector, ...each(index), change));
    },
  };
}

function lyingOf(query: SurfaceQuery, projector: Projector): Lying | null {
  if (projector.kind === "planar") {
    const pose = poseOf(projector);
    return { pose, foot: () => footUnder(query, pose) };
  }
  if (projector.kind !== "cylindrical") return null;
  const { radius, height, arc } = projector;
  const rotation = rotationOf(projector);
  const foot = new Vector3(0, 0, radius).applyQuaternion(rotation).add(new Vector3(...projector.position));
  const width = 2 * radius * Math.sin((Math.min(arc, 180) * Math.PI) / 360);
  return { pose: { position: foot, rotation, size: new Vector3(width, height, 0) }, foot: () => foot };
}

/** On the surface below a box's middle or above it; over no surface the middle itself, as what is nearest lies aside. */
function footUnder(query: SurfaceQuery, pose: DecalPose): Vector3 {
  const normal = axisOf(pose, 2);
  const reach = pose.size.z / 2;
  return crossing(query, pose.position, normal, reach) ?? pose.position;
}

/** Where the line through a place along a normal meets the surface that looks along it, nearest to the place. */
function crossing(query: SurfaceQuery, place: Vector3, normal: Vector3, reach: number): Vector3 | null {
  const hits = query.raycastFacing(place.clone().addScaledVector(normal, reach), normal.clone().negate(), 2 * reach);
  const off = ({ distance }: SurfaceSample): number => Math.abs(distance - reach);
  return hits.sort((a, b) => off(a) - off(b))[0]?.position ?? null;
}

/** Upright, looking where all look, round all rectangles; its middle on the surface where that goes on there. */
function boxRound(query: SurfaceQuery, lying: readonly Lying[], normal: Vector3): DecalPose {
  const level = new Vector3(0, 0, -Math.sign(normal.y));
  const rotation = uprightFrame(normal) ?? uprightFrame(normal, level) ?? new Quaternion();
  const toBox = rotation.clone().invert();
  const low = new Vector3().addScalar(Number.POSITIVE_INFINITY);
  const high = low.clone().negate();
  for (const { pose } of lying) {
    for (const [x, y] of CORNERS) {
      const corner = new Vector3(x, y, 0).multiply(pose.size).applyQuaternion(pose.rotation).add(pose.position);
      corner.applyQuaternion(toBox);
      low.min(corner);
      high.max(corner);
    }
  }
  const size = high.clone().sub(low);
  const middle = low.add(high).divideScalar(2).applyQuaternion(rotation);
  const longer = Math.max(size.x, size.y);
  const position = crossing(query, middle, normal, 2 * query.bounds.radius) ?? middle;
  const depth = fittingDepth(query, { position, rotation, size: size.clone().setZ(longer / 2) });
  return { position, rotation, size: size.setZ(Math.max(depth, 2.1 * size.z)) };
}

/** Ways straight on along the surface. */
class Walk {
  readonly #query: SurfaceQuery;
  readonly #steps: number;
  readonly averages: boolean;
  /** Of a way's length: what may be missing at its end. */
  readonly close: number;

  /** @param ways how many there are: of many, none may take long */
  constructor(query: SurfaceQuery, ways: number) {
    this.#query = query;
    this.#steps = Math.min(MOST_STEPS, Math.max(LEAST_STEPS, Math.floor(STEPS_IN_ALL / ways)));
    this.averages = ways <= MOST_AVERAGED;
    this.close = this.averages ? CLOSE : CLOSE_OF_MANY;
  }

  /**
   * From a frame by x and y of it, metres: the frame there, which turns with the surface and never by itself. Where the surface
   * ends the way goes straight on.
   *
   * @param size of the picture that lies there, under which the normal is averaged
   */
  along(from: Frame, x: number, y: number, size: Vector3 | null = null): Frame {
    const position = from.position.clone();
    const rotation = from.rotation.clone();
    const step = new Vector3(x, y, 0).divideScalar(this.#steps);
    const length = step.length();
    let last: SurfaceSample | null = null;
    for (let taken = 0; taken < (length > 0 ? this.#steps : 1); taken++) {
      position.add(step.clone().applyQuaternion(rotation));
      last = this.#land(position, rotation, length);
    }
    if (last !== null && size !== null && this.averages) {
      stand(rotation, smoothedNear(this.#query, last, size).normal);
    }
    return { position, rotation };
  }

  /** Brings what a step took off the surface back onto it. Null where the surface has ended. */
  #land(position: Vector3, rotation: Quaternion, length: number): SurfaceSample | null {
    const normal = Z.clone().applyQuaternion(rotation);
    const nearest = this.#query.closest(position);
    if (nearest === null) return null;
    const back = tangentPart(nearest.position.clone().sub(position), normal);
    const beside = back.length();
    const passed = length > 0 && beside > PASSED * length;
    const landing = passed ? this.#roundEdge(position, normal, back, beside) : nearest;
    if (landing === null || (!passed && landing.normal.dot(normal) <= 0)) return null;
    if (passed) position.addScaledVector(normal, -beside);
    // Along the normal alone: what is nearest is drawn back from a border.
    position.addScaledVector(landing.normal, landing.normal.dot(landing.position.clone().sub(position)));
    stand(rotation, landing.normal);
    return landing;
  }

  /** The surface that goes down behind an edge, where one does. */
  #roundEdge(position: Vector3, normal: Vector3, back: Vector3, beside: number): SurfaceSample | null {
    const below = this.#query.closest(position.clone().addScaledVector(normal, -beside));
    return below !== null && -below.normal.dot(back) > PASSED * beside ? below : null;
  }
}

function stand(rotation: Quaternion, normal: Vector3): void {
  rotation.premultiply(minimalRotation(Z.clone().applyQuaternion(rotation), normal)).normalize();
}

function wayTo(walk: Walk, from: Frame, box: DecalPose, { foot: footOf, pose }: Lying): Way {
  const foot = footOf();
  const straight = foot.clone().sub(box.position);
  const aim = straight.clone().applyQuaternion(box.rotation.clone().invert()).setZ(0);
  // A chord is nearer to its arc's length than its foot is; but of what lies straight below it has no direction.
  if (2 * aim.length() > straight.length()) aim.setLength(straight.length());
  let best: { aim: Vector3; missing: number; end: Frame } = { aim, missing: Number.POSITIVE_INFINITY, end: from };
  for (let tries = 0; tries < MOST_TRIES && best.missing > walk.close * straight.length(); tries++) {
    const end = walk.along(from, aim.x, aim.y);
    const missing = foot.clone().sub(end.position);
    if (missing.length() < best.missing) best = { aim: aim.clone(), missing: missing.length(), end };
    aim.add(missing.applyQuaternion(end.rotation.clone().invert()).setZ(0));
  }
  const end = walk.averages ? walk.along(from, best.aim.x, best.aim.y, pose.size) : best.end;
  const toEnd = end.rotation.clone().invert();
  return {
    x: best.aim.x,
    y: best.aim.y,
    position: pose.position.clone().sub(end.position).applyQuaternion(toEnd),
    rotation: toEnd.multiply(pose.rotation),
  };
}

function changeOf(walk: Walk, from: Frame, box: DecalPose, now: DecalPose): Change {
  const toBox = box.rotation.clone().invert();
  const { x, y } = now.position.clone().sub(box.position).applyQuaternion(toBox);
  const { position, rotation } = walk.along(from, x, y);
  const to = { position, rotation: rotation.multiply(toBox.multiply(now.rotation)) };
  return { from, to, scale: now.size.clone().divide(box.size) };
}

/** A stamp lies in the texture, and stays. */
function placed(walk: Walk, projector: Projector, lying: Lying | null, way: Way | null, change: Change): Projector {
  if (projector.kind === "perspective") return thrown(projector, change);
  if (projector.kind === "uv" || lying === null || way === null) return projector;
  const { to, scale } = change;
  const { size } = lying.pose;
  const end = walk.along(to, way.x * scale.x, way.y * scale.y, size);
  if (projector.kind === "cylindrical") {
    const { height, arc } = projector;
    const sized = { ...projector, height: height * scale.y, arc: Math.min(FULL_ARC, arc * scale.x) };
    return turnedRound(sized, lying.foot(), end.position);
  }
  return projectorOf({
    position: way.position.clone().applyQuaternion(end.rotation).add(end.position),
    rotation: end.rotation.multiply(way.rotation),
    size: size.clone().multiply(new Vector3(stretchOf(way, 0, scale), stretchOf(way, 1, scale), scale.z)),
  });
}

/**
 * What the sheet's stretch is along a side of a picture that is turned on it: that of the sheet's own axis, or in between. As a
 * power, so that to stretch and to shrink again is nothing; a rectangle cannot be slanted as the sheet would slant it.
 */
function stretchOf({ rotation }: Way, side: 0 | 1, scale: Vector3): number {
  const { x, y } = new Vector3().setComponent(side, 1).applyQuaternion(rotation);
  const share = (x * x) / (x * x + y * y || 1);
  return scale.x ** share * scale.y ** (1 - share);
}

/** An eye goes with the sheet as one body, as far off as that has grown. */
function thrown(eye: PerspectiveProjector, { from, to, scale }: Change): PerspectiveProjector {
  const turn = to.rotation.clone().multiply(from.rotation.clone().invert());
  const factor = Math.sqrt(scale.x * scale.y);
  const position = new Vector3(...eye.position).sub(from.position).multiplyScalar(factor).applyQuaternion(turn);
  const { x, y, z, w } = turn.multiply(rotationOf(eye)).normalize();
  return {
    ...eye,
    position: tupleOf(position.add(to.position)),
    rotation: [x, y, z, w],
    near: eye.near * factor,
    far: eye.far * factor,
  };
}

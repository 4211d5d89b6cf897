/** What goes along with a decal that is dragged: it keeps its place beside it, round a mug as well as over a table. */
import type { CylindricalProjector, PlanarProjector, Projector, Quaternion, Vec3 } from "../../engine/engine-api.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { cross, dot } from "../document/axes.ts";
import { inverse, minus, plus, product, turned } from "../document/rigid-motion.ts";
import { scaledProjector, spunProjector } from "./projector-steps.ts";

/** A place of the surface, and where that looks. */
export type Foot = Pick<SurfaceHit, "position" | "normal">;

/** Where the surface is nearest to a place, as what is so wide lies on it; null where there is none. */
export type NearSurface = (place: Vec3, width?: number) => Foot | null;

/** Where a decal stands on the surface before it is carried; null where it does not. */
export const footOf = (projector: Projector, near: NearSurface): Foot | null =>
  projector.kind === "planar" ? near(projector.position, widthOf(projector)) : null;

const widthOf = ({ size: [width, height] }: PlanarProjector): number => Math.max(width, height);

/**
 * `other`, whose foot was at `foot`, carried as one body with what was dragged from `start` to `now`. Of a stamp and what is no
 * stamp neither carries the other: one lies in the texture, the other on the model.
 */
export function carriedProjector(
  start: Projector,
  now: Projector,
  other: Projector,
  foot: Foot | null,
  near: NearSurface,
): Projector {
  if (start.kind === "uv" && now.kind === "uv" && other.kind === "uv") {
    const [u, v] = other.center;
    return { ...other, center: [u + now.center[0] - start.center[0], v + now.center[1] - start.center[1]] };
  }
  if (start.kind === "uv" || now.kind === "uv" || other.kind === "uv") return other;
  const turn = times(now.rotation, inverse(start.rotation));
  const carry = (place: Vec3): Vec3 => plus(now.position, turned(turn, minus(place, start.position)));
  if (other.kind === "cylindrical") return carriedRound(other, carry);
  const position = carry(other.position);
  const rotation = times(turn, other.rotation);
  if (other.kind === "perspective") return { ...other, position, rotation };
  // The surface need not go on as it did under the dragged one: the foot stays on it, and the decal leans with it.
  const carriedFoot = foot && carry(foot.position);
  const landing = carriedFoot && near(carriedFoot, widthOf(other));
  if (!landing) return { ...other, position, rotation };
  const lean = leanOf(turned(turn, foot.normal), landing.normal);
  const above = turned(lean, minus(position, carriedFoot));
  return { ...other, position: plus(landing.position, above), rotation: times(lean, rotation) };
}

/** The least turn from one direction to another; none to one that looks away, as behind an edge: nothing lies there. */
function leanOf(from: Vec3, to: Vec3): Quaternion {
  const facing = dot(from, to);
  if (facing <= 0) return [0, 0, 0, 1];
  const [x, y, z] = cross(from, to);
  return times([x, y, z, 1 + facing], [0, 0, 0, 1]);
}

/** `other` turned and sized where it lies as what was dragged from `start` to `now` was, as far as both kinds let it. */
export function changedAlike(start: Projector, now: Projector, other: Projector): Projector {
  return scaledProjector(spunProjector(other, spinOf(start, now)), growthOf(start, now));
}

/** Degrees counter-clockwise as the viewer sees it. */
function spinOf(start: Projector, now: Projector): number {
  if (start.kind === "uv" || now.kind === "uv") {
    return start.kind === "uv" && now.kind === "uv" ? start.angle - now.angle : 0;
  }
  const [, , z, w] = times(inverse(start.rotation), now.rotation);
  return (Math.atan2(z, w) * 360) / Math.PI;
}

/** By how much the picture is larger; 1 where its proportions are others: a side of it was dragged. */
function growthOf(start: Projector, now: Projector): number {
  const [width, height] = sidesOf(start);
  const [nowWidth, nowHeight] = sidesOf(now);
  const [across, up] = [nowWidth / width, nowHeight / height];
  return Math.abs(across / up - 1) < 1e-6 ? across : 1;
}

/** In whatever unit. */
function sidesOf(projector: Projector): readonly [number, number] {
  if (projector.kind === "cylindrical") return [projector.arc, projector.height];
  if (projector.kind !== "perspective") return [projector.size[0], projector.size[1]];
  const slope = Math.tan((projector.fov * Math.PI) / 360);
  return [slope, slope];
}

/** A label stays on its axis: it goes round it, and along it. */
function carriedRound(label: CylindricalProjector, carry: (place: Vec3) => Vec3): CylindricalProjector {
  const { position, rotation, radius } = label;
  const front = plus(position, turned(rotation, [0, 0, radius]));
  const [x, y, z] = turned(inverse(rotation), minus(carry(front), position));
  const half = Math.atan2(x, z) / 2;
  return {
    ...label,
    position: plus(position, turned(rotation, [0, y, 0])),
    rotation: times(rotation, [0, Math.sin(half), 0, Math.cos(half)]),
  };
}

/** First `b`, then `a`; kept a unit, as a long drag multiplies its rounding. */
export function times(a: Quaternion, b: Quaternion): Quaternion {
  const made = product(a, b);
  const length = Math.hypot(...made);
  return made.map((part) => part / length) as unknown as Quaternion;
}

/**
 * From the path of a brush over the surface to its dabs. Only + - * / and square roots, so that every engine places them
 * at the same numbers (spec.md, 7).
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Quaternion, Vec3 } from "../../engine/engine-api.ts";
import { cross } from "./axes.ts";
import type { Dab } from "./design.ts";
import { DESIGN_LIMITS } from "./design-schema.ts";
import { minus } from "./rigid-motion.ts";

/** Where the pen touched the model. */
export interface PathPoint {
  /** Metres, model space. */
  readonly position: Vec3;
  /** Outward; need not be of unit length. */
  readonly normal: Vec3;
  /** 0 to 1; default 1. */
  readonly pressure?: number;
}

export interface StrokePathOptions {
  /** Of a dab, its longer side, metres. */
  readonly size: number;
  /** Width by height of a picture that is the tip; default 1. */
  readonly aspect?: number;
  /** From dab to dab along the path, as a share of the size, above 0; default 0.15. */
  readonly spacing?: number;
  /** How far a dab reaches in and out of the surface altogether, metres; default: the size. */
  readonly depth?: number;
  /** What a point's pressure is a share of: a dab's flow (default), or its width and height, which the spacing then follows. */
  readonly pressure?: "flow" | "size";
}

/** Where a path under way has got to. */
export interface PathTail {
  readonly point: PathPoint;
  /** Along the path until the next dab, metres. */
  readonly untilNext: number;
}

export interface StrokePiece {
  readonly dabs: readonly Dab[];
  /** For the piece after this one; null where there was no point yet. */
  readonly tail: PathTail | null;
}

const DEFAULT_SPACING = 0.15;
/** Of the size: thinner than this no line is seen, and a length must not be 0. */
const LEAST_WIDTH = 0.05;
/** A dab is due this share of a step early: sums of lengths that were chopped otherwise differ in their last digits. */
const SLACK = 1e-9;

/**
 * Places planar dabs along straight lines from point to point, the first on the first point: their +Z the surface's
 * normal, their flow the pen's pressure, both taken between the points. What is left over of a line carries on to the next
 * one, so it does not matter how finely a path is sampled, or in how many pieces it comes.
 *
 * @param tail Of the piece before; null (default) begins a stroke.
 * @throws TexelcastError "bad-argument" naming the field, and for more dabs than a stroke may hold.
 */
export function placeDabs(
  points: readonly PathPoint[],
  options: StrokePathOptions,
  tail: PathTail | null = null,
): StrokePiece {
  const { size, aspect = 1, spacing = DEFAULT_SPACING, depth = size, pressure = "flow" } = options;
  checkAbove0("size", size);
  checkAbove0("aspect", aspect);
  checkAbove0("spacing", spacing);
  checkAbove0("depth", depth);
  points.forEach(checkPoint);
  const step = size * spacing;
  const dabs: Dab[] = [];
  /** Returns how far along the path the next one is. */
  const lay = (point: PathPoint): number => {
    if (dabs.length >= DESIGN_LIMITS.dabs) {
      throw badArgument("spacing", spacing, `a stroke of more than ${DESIGN_LIMITS.dabs} dabs`);
    }
    const pressed = point.pressure ?? 1;
    const share = pressure === "size" ? Math.max(LEAST_WIDTH, pressed) : 1;
    const side = size * share;
    const box: Vec3 = [side * Math.min(1, aspect), side / Math.max(1, aspect), depth];
    dabs.push(dabAt(point, box, pressure === "flow" ? pressed : 1));
    return step * share;
  };
  let last = tail?.point;
  let untilNext = tail?.untilNext ?? 0;
  for (const point of points) {
    if (last === undefined) {
      untilNext = lay(point);
    } else {
      const line = lengthOf(minus(point.position, last.position));
      let at = untilNext;
      while (at <= line + SLACK * step) at += lay(between(last, point, line > 0 ? Math.min(at / line, 1) : 1));
      untilNext = at - line;
    }
    last = point;
  }
  return { dabs, tail: last === undefined ? null : { point: last, untilNext } };
}

function dabAt(point: PathPoint, size: Vec3, flow: number): Dab {
  return {
    kind: "planar",
    position: point.position,
    rotation: facing(point.normal),
    size,
    flow,
  };
}

function between(a: PathPoint, b: PathPoint, share: number): PathPoint {
  const mix = (from: number, to: number): number => from + (to - from) * share;
  const mixed = (from: Vec3, to: Vec3): Vec3 => [mix(from[0], to[0]), mix(from[1], to[1]), mix(from[2], to[2])];
  const normal = mixed(unit(a.normal), unit(b.normal));
  return {
    position: mixed(a.position, b.position),
    // Opposite normals, as on the two sides of a sheet, have no middle.
    normal: lengthOf(normal) > 1e-6 ? normal : b.normal,
    pressure: mix(a.pressure ?? 1, b.pressure ?? 1),
  };
}

/**
 * The turn whose +Z is the normal and whose +Y is as upright in the model as that allows; on level surfaces, where nothing
 * is upright, +Y points away from +Z as on a table seen from the front.
 */
function facing(normal: Vec3): Quaternion {
  const z = unit(normal);
  const isLevel = z[0] * z[0] + z[2] * z[2] < 1e-6;
  const x = unit(cross(isLevel ? [0, 0, z[1] > 0 ? -1 : 1] : [0, 1, 0], z));
  const y = cross(z, x);
  // Shepperd's method: divides by the largest of the four parts.
  const trace = x[0] + y[1] + z[2];
  if (trace > 0) {
    const s = Math.sqrt(trace + 1) * 2;
    return [(y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4];
  }
  if (x[0] > y[1] && x[0] > z[2]) {
    const s = Math.sqrt(1 + x[0] - y[1] - z[2]) * 2;
    return [s / 4, (x[1] + y[0]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s];
  }
  if (y[1] > z[2]) {
    const s = Math.sqrt(1 + y[1] - x[0] - z[2]) * 2;
    return [(x[1] + y[0]) / s, s / 4, (y[2] + z[1]) / s, (z[0] - x[2]) / s];
  }
  const s = Math.sqrt(1 + z[2] - x[0] - y[1]) * 2;
  return [(z[0] + x[2]) / s, (y[2] + z[1]) / s, s / 4, (x[1] - y[0]) / s];
}

const lengthOf = (v: Vec3): number => Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

function unit(v: Vec3): Vec3 {
  const length = lengthOf(v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

function checkAbove0(field: string, value: number): void {
  if (!(value > 0 && value <= DESIGN_LIMITS.lengthMax)) throw badArgument(field, value, "a number above 0");
}

function checkPoint({ position, normal, pressure = 1 }: PathPoint, index: number): void {
  const isInRange = (v: Vec3): boolean => v.every((part) => Math.abs(part) <= DESIGN_LIMITS.lengthMax);
  const place = `points[${index}]`;
  if (!isInRange(position)) throw badArgument(`${place}.position`, position, "three finite numbers");
  if (!isInRange(normal) || !(lengthOf(normal) > 1e-9)) throw badArgument(`${place}.normal`, normal, "a direction");
  if (!(pressure >= 0 && pressure <= 1)) throw badArgument(`${place}.pressure`, pressure, "a number from 0 to 1");
}

function badArgument(field: string, value: number | Vec3, wanted: string): TexelcastError {
  const shown = String(value);
  const message =
    field === "spacing" && wanted.startsWith("a stroke")
      ? `“spacing” ${shown} makes ${wanted}.`
      : `“${field}” must be ${wanted}, not ${shown}.`;
  return new TexelcastError("bad-argument", message, { field, value: shown });
}

/**
 * How the clone tool looks at its source and throws what it saw: two eyes, one before the source, one before the place that
 * is painted, whose pictures are of one size where each looks. What lies a step beside the one goes that step beside the other.
 */
import type { PerspectiveProjector, Vec3 } from "../../engine/engine-api.ts";
import { cross, dot, lengthOf, scaled, turnOfAxes, unit } from "../document/axes.ts";
import { minus, plus } from "../document/rigid-motion.ts";

/** An eye that looks at a place; `up` is what stands upright in its picture. Model space, metres. */
export interface Look {
  readonly at: Vec3;
  readonly eye: Vec3;
  readonly up: Vec3;
}

/** Part of the plane through the place that is looked at, square to the look: metres to the right and up from there. */
export interface LookArea {
  readonly left: number;
  readonly right: number;
  readonly bottom: number;
  readonly top: number;
}

interface Axes {
  readonly x: Vec3;
  readonly y: Vec3;
  /** From the place to the eye. */
  readonly z: Vec3;
  readonly distance: number;
}

/** Degrees: a wider picture bends what it shows beyond use. */
const WIDEST = 160;
/** Of the way to the place: nearer to the eye nothing is met. */
const NEAREST = 0.01;

function axesOf({ at, eye, up }: Look): Axes {
  const way = minus(eye, at);
  const distance = lengthOf(way);
  const z = scaled(way, 1 / distance);
  const x = unit(cross(up, z));
  return { x, y: cross(z, x), z, distance };
}

/** The eye's picture of an area about its middle, metres from there to each side; `reach`: how far behind the place it sees. */
export function eyeOf(look: Look, half: readonly [number, number], reach: number): PerspectiveProjector {
  const { x, y, z, distance } = axesOf(look);
  const fov = (Math.atan(half[1] / distance) * 360) / Math.PI;
  return {
    kind: "perspective",
    position: look.eye,
    rotation: turnOfAxes(x, y, z),
    fov: Math.min(WIDEST, fov),
    aspect: half[0] / half[1],
    near: distance * NEAREST,
    far: distance + reach,
  };
}

/** Where the eye sees a ball, in the plane of what it looks at; null behind the eye. */
export function areaOf(look: Look, centre: Vec3, radius: number): LookArea | null {
  const { x, y, z, distance } = axesOf(look);
  const way = minus(centre, look.eye);
  const depth = -dot(way, z);
  if (depth <= radius) return null;
  const scale = distance / depth;
  const [right, up, reach] = [dot(way, x) * scale, dot(way, y) * scale, (radius * distance) / (depth - radius)];
  return { left: right - reach, right: right + reach, bottom: up - reach, top: up + reach };
}

export function joinedArea(a: LookArea | null, b: LookArea | null): LookArea | null {
  if (a === null || b === null) return a ?? b;
  return {
    left: Math.min(a.left, b.left),
    right: Math.max(a.right, b.right),
    bottom: Math.min(a.bottom, b.bottom),
    top: Math.max(a.top, b.top),
  };
}

/** The source's look once what is painted has gone from one place to another: a step of the one is a step of the other. */
export function steppedLook(source: Look, painted: Look, to: Vec3): Look {
  const from = axesOf(painted);
  const way = minus(to, painted.at);
  const own = axesOf(source);
  const step = plus(scaled(own.x, dot(way, from.x)), scaled(own.y, dot(way, from.y)));
  return { at: plus(source.at, step), eye: plus(source.eye, step), up: source.up };
}

/** What the handles of a flat stamp do to it, in texture coordinates. Pure. */
import { Quaternion, Vector3 } from "three";
import type { UvProjector } from "../engine/engine-api.ts";
import { type HandleSide, scaleByHandle } from "./decal-handles.ts";
import type { UvBounds } from "./uv-charts.ts";

export type Uv = readonly [number, number];

/** Parts of the texture: a stamp may be as small as this, and as large. */
const LIMITS = { least: 1e-4, most: 16 };
const SNAP = 15;
const DEGREES = 180 / Math.PI;

/** A point of the stamp's picture (decal space: x to the right, y up, -½ to ½) in the texture. */
export function uvOfStamp({ center, size, angle }: UvProjector, x: number, y: number): Uv {
  const [sine, cosine] = [Math.sin(angle / DEGREES), Math.cos(angle / DEGREES)];
  const [along, up] = [x * size[0], y * size[1]];
  return [center[0] + along * cosine + up * sine, center[1] + along * sine - up * cosine];
}

/** Upright, round all of some stamps. */
export function stampBounds(stamps: readonly UvProjector[]): UvBounds {
  const corners = stamps.flatMap((stamp) => [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].map((y) => uvOfStamp(stamp, x, y))));
  const most = (of: (...all: number[]) => number): Uv => [
    of(...corners.map(([u]) => u)),
    of(...corners.map(([, v]) => v)),
  ];
  return { low: most(Math.min), high: most(Math.max) };
}

/** A way in the texture along the stamp's own axes: to the right, and up. */
function ownWay({ angle }: UvProjector, from: Uv, to: Uv): { x: number; y: number } {
  const [sine, cosine] = [Math.sin(angle / DEGREES), Math.cos(angle / DEGREES)];
  const [right, down] = [to[0] - from[0], to[1] - from[1]];
  return { x: right * cosine + down * sine, y: right * sine - down * cosine };
}

/** True where the stamp's rectangle holds a place of the texture. */
export function stampHolds(stamp: UvProjector, uv: Uv): boolean {
  const { x, y } = ownWay(stamp, stamp.center, uv);
  return Math.abs(x) <= stamp.size[0] / 2 && Math.abs(y) <= stamp.size[1] / 2;
}

export function movedStamp(start: UvProjector, from: Uv, to: Uv): UvProjector {
  return { ...start, center: [start.center[0] + to[0] - from[0], start.center[1] + to[1] - from[1]] };
}

/** As a box's handles do: a corner keeps the proportions, the opposite side stays unless `fromCentre`. */
export function scaledStamp(start: UvProjector, side: HandleSide, from: Uv, to: Uv, fromCentre: boolean): UvProjector {
  const flat = {
    position: new Vector3(),
    rotation: new Quaternion(),
    size: new Vector3(start.size[0], start.size[1], 1),
  };
  const { size, position } = scaleByHandle(flat, side, ownWay(start, from, to), fromCentre, LIMITS);
  const center = uvOfStamp({ ...start, size: [1, 1] }, position.x, position.y);
  return { ...start, center, size: [size.x, size.y] };
}

/** @param snaps whether the angle goes in steps of 15° */
export function turnedStamp(start: UvProjector, from: Uv, to: Uv, snaps: boolean): UvProjector {
  const [u, v] = start.center;
  const turn = (Math.atan2(to[1] - v, to[0] - u) - Math.atan2(from[1] - v, from[0] - u)) * DEGREES;
  const angle = start.angle + turn;
  const stepped = snaps ? Math.round(angle / SNAP) * SNAP : angle;
  return { ...start, angle: ((((stepped + 180) % 360) + 360) % 360) - 180 };
}

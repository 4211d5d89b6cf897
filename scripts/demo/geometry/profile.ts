/**
 * Profiles: polylines in a half plane (x = distance from the axis, y = height) whose corners are rounded by arcs. Every
 * corner that a lathe turns is smooth this way, so normals never need to be split.
 */

import type { Vec2 } from "./vector.ts";

export interface ProfileCorner {
  readonly x: number;
  readonly y: number;
  /** Fillet radius, metres; 0 at the two ends. */
  readonly radius?: number;
  /** Arc pieces of the fillet; even, so that its middle is a point where charts can be parted. Default 6. */
  readonly steps?: number;
}

export interface ProfilePoint {
  readonly x: number;
  readonly y: number;
  /** Unit normal: the outside lies to the right of the direction of travel. */
  readonly normal: Vec2;
  /** Arc length from the profile's first point, metres. */
  readonly length: number;
  /** Index of the corner whose fillet has its middle here; -1 elsewhere. */
  readonly cornerMiddle: number;
}

interface RawPoint {
  x: number;
  y: number;
  tangent: Vec2;
  cornerMiddle: number;
}

/** Rounds the polyline; straight pieces longer than `maximumStep` (metres) are divided. */
export function roundedProfile(corners: readonly ProfileCorner[], maximumStep: number): ProfilePoint[] {
  const points: RawPoint[] = [];
  for (let index = 0; index < corners.length; index++) {
    const corner = corners[index] as ProfileCorner;
    const before = corners[index - 1];
    const after = corners[index + 1];
    if (before && after && corner.radius) appendFillet(points, before, corner, after, index, maximumStep);
    else if (after) appendLine(points, { ...corner, tangent: direction(corner, after), cornerMiddle: -1 }, maximumStep);
    else if (before)
      appendLine(points, { ...corner, tangent: direction(before, corner), cornerMiddle: -1 }, maximumStep);
  }
  let travelled = 0;
  return points.map((point, index) => {
    const last = points[index - 1];
    if (last) travelled += Math.hypot(point.x - last.x, point.y - last.y);
    const [tx, ty] = point.tangent;
    return { x: point.x, y: point.y, normal: [ty, -tx], length: travelled, cornerMiddle: point.cornerMiddle };
  });
}

/** The run of points between two corners' middles; -1 stands for the profile's own end. */
export function profileRun(profile: readonly ProfilePoint[], fromCorner: number, toCorner: number): ProfilePoint[] {
  const find = (corner: number): number => {
    const index = profile.findIndex((point) => point.cornerMiddle === corner);
    if (index < 0) throw new RangeError(`profileRun: corner ${corner} has no rounded middle`);
    return index;
  };
  const from = fromCorner < 0 ? 0 : find(fromCorner);
  const to = toCorner < 0 ? profile.length - 1 : find(toCorner);
  return profile.slice(from, to + 1);
}

function direction(from: { x: number; y: number }, to: { x: number; y: number }): Vec2 {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const size = Math.hypot(dx, dy);
  return [dx / size, dy / size];
}

function appendFillet(
  points: RawPoint[],
  before: ProfileCorner,
  corner: ProfileCorner,
  after: ProfileCorner,
  index: number,
  maximumStep: number,
): void {
  const radius = corner.radius ?? 0;
  const steps = corner.steps ?? 6;
  const into = direction(before, corner);
  const out = direction(corner, after);
  const turn = Math.atan2(into[0] * out[1] - into[1] * out[0], into[0] * out[0] + into[1] * out[1]);
  const side = Math.sign(turn);
  const reach = radius * Math.tan(Math.abs(turn) / 2);
  const start = { x: corner.x - into[0] * reach, y: corner.y - into[1] * reach };
  const centre = { x: start.x - into[1] * side * radius, y: start.y + into[0] * side * radius };
  for (let step = 0; step <= steps; step++) {
    const angle = (turn * step) / steps;
    const cos = Math.cos(angle);
    const sin = Math.sin(angle);
    const tangent: Vec2 = [into[0] * cos - into[1] * sin, into[0] * sin + into[1] * cos];
    const point: RawPoint = {
      x: centre.x + tangent[1] * side * radius,
      y: centre.y - tangent[0] * side * radius,
      tangent,
      cornerMiddle: step * 2 === steps ? index : -1,
    };
    if (step === 0) appendLine(points, point, maximumStep);
    else points.push(point);
  }
}

function appendLine(points: RawPoint[], end: RawPoint, maximumStep: number): void {
  const start = points[points.length - 1];
  if (!start) {
    points.push(end);
    return;
  }
  const distance = Math.hypot(end.x - start.x, end.y - start.y);
  // Two fillets that touch share their point: a full-round rim has no straight piece between its arcs.
  if (distance < 1e-7) return;
  const pieces = Math.ceil(distance / maximumStep);
  for (let piece = 1; piece < pieces; piece++) {
    const share = piece / pieces;
    points.push({
      x: start.x + (end.x - start.x) * share,
      y: start.y + (end.y - start.y) * share,
      tangent: end.tangent,
      cornerMiddle: -1,
    });
  }
  points.push(end);
}

/**
 * The deck of a skateboard that stands on its tail: +Y runs from tail to nose, the graphic side faces +Z, the grip -Z.
 * It is cut flat, with every length as it will be along the bent board, and then pressed into shape.
 */

import { type Chart, deformChart, gridChart, quarterTurnPattern } from "../geometry/chart.ts";
import { superellipse } from "../geometry/sweep.ts";
import { mix, smoothstep, type Vec2, type Vec3 } from "../geometry/vector.ts";

const MM = 0.001;
const DECK_LENGTH = 808 * MM;
const DECK_WIDTH = 205 * MM;
export const DECK_THICKNESS = 11 * MM;
const EDGE_RADIUS = 2.6 * MM;
const CONCAVE = 8 * MM;
const KICK_ANGLE = (21 * Math.PI) / 180;

/** A point of the outline with its outward normal in the plane. */
interface OutlinePoint {
  readonly point: Vec2;
  readonly normal: Vec2;
}

/** The right half of the outline, from the tip of the tail to the tip of the nose. */
function rightOutline(): OutlinePoint[] {
  const halfWidth = DECK_WIDTH / 2;
  const halfLength = DECK_LENGTH / 2;
  const end = (straightUntil: number, exponent: number): OutlinePoint[] => {
    const reach = halfLength - straightUntil;
    // Dense in the parameter, then taken at even distances: the parameter itself crowds at both ends.
    const dense = Array.from({ length: 2001 }, (_, index) => {
      const [x, y] = superellipse(((index / 2000) * Math.PI) / 2, exponent);
      return [Math.max(0, x) * halfWidth, straightUntil + y * reach] as Vec2;
    });
    const lengths = [0];
    for (let index = 1; index < dense.length; index++) {
      const [ax, ay] = dense[index - 1] as Vec2;
      const [bx, by] = dense[index] as Vec2;
      lengths.push((lengths[index - 1] as number) + Math.hypot(bx - ax, by - ay));
    }
    const total = lengths[lengths.length - 1] as number;
    const pieces = 34;
    return Array.from({ length: pieces + 1 }, (_, piece) => {
      const index = piece === pieces ? 2000 : lengths.findIndex((travelled) => travelled >= (total * piece) / pieces);
      const before = dense[Math.max(0, index - 1)] as Vec2;
      const after = dense[Math.min(2000, index + 1)] as Vec2;
      const size = Math.hypot(after[0] - before[0], after[1] - before[1]);
      // At the tip the two halves meet: the normal there is straight ahead.
      const normal: Vec2 = index === 2000 ? [0, 1] : [(after[1] - before[1]) / size, -(after[0] - before[0]) / size];
      return { point: dense[index] as Vec2, normal: index === 0 ? ([1, 0] as const) : normal };
    });
  };
  const nose = end(255 * MM, 2.35);
  const tail = end(243 * MM, 2.2).map(
    ({ point, normal }): OutlinePoint => ({ point: [point[0], -point[1]], normal: [normal[0], -normal[1]] }),
  );
  const sides: OutlinePoint[] = [];
  const pieces = 16;
  for (let piece = 1; piece < pieces; piece++) {
    sides.push({ point: [halfWidth, mix(-243 * MM, 255 * MM, piece / pieces)], normal: [1, 0] });
  }
  return [...tail.reverse(), ...sides, ...nose];
}

/** The two faces and the two halves of the edge, bent; the lowest point lies at the height of the flat tail's tip. */
export function deckCharts(): Chart[] {
  const outline = rightOutline();
  const flatCharts = [face("graphic", outline, 1), face("grip", outline, -1), edge("right edge", outline, 1)];
  return [...flatCharts, edge("left edge", outline, -1)].map((chart) => deformChart(chart, pressDeck));
}

/** `side` 1 faces +Z, -1 faces -Z. */
function face(name: string, outline: readonly OutlinePoint[], side: 1 | -1): Chart {
  const columns = 14;
  const rows = [...outline].reverse();
  return gridChart(name, rows.length, columns + 1, (row, column) => {
    const { point, normal } = rows[row] as OutlinePoint;
    const halfWidth = point[0] - normal[0] * EDGE_RADIUS;
    const x = side * mix(-halfWidth, halfWidth, column / columns);
    const y = point[1] - normal[1] * EDGE_RADIUS;
    return { position: [x, y, (side * DECK_THICKNESS) / 2], normal: [0, 0, side], flat: [side * x, -y] };
  });
}

/** Half of the rim: rounded, straight, rounded; its pattern stands upright. */
function edge(name: string, outline: readonly OutlinePoint[], side: 1 | -1): Chart {
  const points = side > 0 ? outline : [...outline].reverse();
  const arcSteps = 4;
  const straight = DECK_THICKNESS - 2 * EDGE_RADIUS;
  const rows = Array.from({ length: 2 * (arcSteps + 1) }, (_, index) => {
    const lower = index > arcSteps;
    const angle = (Math.PI / 2) * ((lower ? index - 1 : index) / arcSteps);
    const height = (lower ? -1 : 1) * (straight / 2) + EDGE_RADIUS * Math.cos(angle);
    return { angle, height, across: EDGE_RADIUS * angle + (lower ? straight : 0) };
  });
  const travelled = [0];
  for (let index = 1; index < points.length; index++) {
    const a = (points[index - 1] as OutlinePoint).point;
    const b = (points[index] as OutlinePoint).point;
    travelled.push((travelled[index - 1] as number) + Math.hypot(b[0] - a[0], b[1] - a[1]));
  }
  const chart = gridChart(name, rows.length, points.length, (row, column) => {
    const { angle, height, across } = rows[row] as (typeof rows)[number];
    const { point, normal } = points[column] as OutlinePoint;
    const inset = EDGE_RADIUS * (1 - Math.sin(angle));
    return {
      position: [side * (point[0] - normal[0] * inset), point[1] - normal[1] * inset, height],
      normal: [side * normal[0] * Math.sin(angle), normal[1] * Math.sin(angle), Math.cos(angle)],
      flat: [travelled[column] as number, across],
    };
  });
  return { ...quarterTurnPattern(chart), density: 0.8 };
}

/** Kicks by turning along the length, concave by lifting the sides towards the grip. Keeps lengths along the board. */
export function pressDeck([x, y, z]: Vec3): Vec3 {
  const lift = CONCAVE * smoothstep(22 * MM, 120 * MM, Math.abs(x)) * concaveShare(y);
  const { along, out, angle } = bendAt(y);
  const depth = z - lift;
  return [x, along + Math.sin(angle) * depth, out + Math.cos(angle) * depth];
}

/** The concave runs out towards the tips. */
const concaveShare = (y: number): number => 1 - smoothstep(0.24, 0.4, Math.abs(y));

const KICK_FROM = 0.222;
const KICK_UNTIL = 0.285;

/** The bent middle line: where it lies and how far it has turned, by arc length from the board's centre. */
function bendAt(y: number): { along: number; out: number; angle: number } {
  const distance = Math.abs(y);
  const side = Math.sign(y);
  const length = KICK_UNTIL - KICK_FROM;
  const share = Math.min(1, Math.max(0, (distance - KICK_FROM) / length));
  // The turn eases in and out as a smoothstep of the arc length; position is its integral, by Simpson's rule.
  const turn = (s: number): number => KICK_ANGLE * s * s * (3 - 2 * s);
  let along = Math.min(distance, KICK_FROM);
  let out = 0;
  const steps = 16;
  for (let step = 0; step < steps; step++) {
    const a = (share * step) / steps;
    const b = (share * (step + 1)) / steps;
    const weight = ((b - a) * length) / 6;
    along += weight * (Math.cos(turn(a)) + 4 * Math.cos(turn((a + b) / 2)) + Math.cos(turn(b)));
    out -= weight * (Math.sin(turn(a)) + 4 * Math.sin(turn((a + b) / 2)) + Math.sin(turn(b)));
  }
  const rest = Math.max(0, distance - KICK_UNTIL);
  return {
    along: side * (along + Math.cos(KICK_ANGLE) * rest),
    out: out - Math.sin(KICK_ANGLE) * rest,
    angle: side * turn(share),
  };
}

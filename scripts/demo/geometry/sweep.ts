/** A section swept along a plane curve. */

import { type Chart, gridChart, normalFromTangents } from "./chart.ts";
import { subtract, type Vec2, type Vec3 } from "./vector.ts";

export interface CurvePoint {
  readonly point: Vec2;
  readonly tangent: Vec2;
}

const STEPS_PER_PIECE = 256;

/** A curve in the XY plane by arc length, from pieces of cubic Bézier curves (four control points each). */
export class PlaneCurve {
  readonly length: number;
  readonly #points: Vec2[] = [];
  readonly #lengths: number[] = [];

  constructor(pieces: readonly (readonly [Vec2, Vec2, Vec2, Vec2])[]) {
    let travelled = 0;
    for (const [a, b, c, d] of pieces) {
      for (let step = this.#points.length === 0 ? 0 : 1; step <= STEPS_PER_PIECE; step++) {
        const t = step / STEPS_PER_PIECE;
        const s = 1 - t;
        const at = (axis: 0 | 1): number =>
          s * s * s * a[axis] + 3 * s * s * t * b[axis] + 3 * s * t * t * c[axis] + t * t * t * d[axis];
        const point: Vec2 = [at(0), at(1)];
        const last = this.#points[this.#points.length - 1];
        if (last) travelled += Math.hypot(point[0] - last[0], point[1] - last[1]);
        this.#points.push(point);
        this.#lengths.push(travelled);
      }
    }
    this.length = travelled;
  }

  /** Point and unit tangent at an arc length; beyond the ends the curve goes on straight. */
  at(distance: number): CurvePoint {
    const lengths = this.#lengths;
    let low = 0;
    let high = lengths.length - 2;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((lengths[middle] as number) <= distance) low = middle;
      else high = middle - 1;
    }
    const a = this.#points[low] as Vec2;
    const b = this.#points[low + 1] as Vec2;
    const span = (lengths[low + 1] as number) - (lengths[low] as number);
    const share = (distance - (lengths[low] as number)) / span;
    return {
      point: [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share],
      tangent: this.#tangent(low, share),
    };
  }

  #tangent(index: number, share: number): Vec2 {
    // Differences over two pieces, blended, so the tangent turns continuously and not in 1/256 steps.
    const difference = (i: number): Vec2 => {
      const from = this.#points[Math.max(0, i - 1)] as Vec2;
      const to = this.#points[Math.min(this.#points.length - 1, i + 1)] as Vec2;
      const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
      return [(to[0] - from[0]) / size, (to[1] - from[1]) / size];
    };
    const t = Math.min(1, Math.max(0, share));
    const a = difference(index);
    const b = difference(index + 1);
    const x = a[0] + (b[0] - a[0]) * t;
    const y = a[1] + (b[1] - a[1]) * t;
    const size = Math.hypot(x, y);
    return [x / size, y / size];
  }
}

/** A superellipse: 2 is an ellipse, larger exponents come near to a rounded box. Radians; unit half axes. */
export function superellipse(angle: number, exponent: number): Vec2 {
  const bend = (value: number): number => Math.sign(value) * Math.abs(value) ** (2 / exponent);
  return [bend(Math.cos(angle)), bend(Math.sin(angle))];
}

export interface SweepOptions {
  readonly curve: PlaneCurve;
  /** Arc lengths of the rings, rising. */
  readonly rings: readonly number[];
  readonly columns: number;
  /**
   * Offset from the curve at an arc length and an angle, radians: first to the curve's left (in its plane), then
   * along +Z; metres.
   */
  readonly section: (distance: number, angle: number) => Vec2;
  /** Angle of the seam, radians. */
  readonly seamAngle: number;
  /** Width of the pattern, metres; a mean perimeter. */
  readonly patternWidth: number;
  /** Applied to every point before normals are taken: bends the whole tube. */
  readonly bend?: (position: Vec3) => Vec3;
}

/** The tube, open at both ends; the curve runs to the right on the pattern. */
export function sweepChart(name: string, options: SweepOptions): Chart {
  const { curve, rings, columns } = options;
  const bend = options.bend ?? ((position: Vec3) => position);
  const surface = (distance: number, angle: number): Vec3 => {
    const { point, tangent } = curve.at(distance);
    const [left, out] = options.section(distance, angle);
    return bend([point[0] - tangent[1] * left, point[1] + tangent[0] * left, out]);
  };
  const first = rings[0] as number;
  const end = rings[rings.length - 1] as number;
  return gridChart(name, columns + 1, rings.length, (row, column) => {
    const distance = rings[column] as number;
    const angle = options.seamAngle + (row === columns ? 0 : (2 * Math.PI * row) / columns);
    const step = Math.min(2e-5, (end - first) / 100);
    const before = Math.max(first, distance - step);
    const after = Math.min(end, distance + step);
    const right = subtract(surface(after, angle), surface(before, angle));
    const down = subtract(surface(distance, angle + 1e-3), surface(distance, angle - 1e-3));
    return {
      position: surface(distance, angle),
      normal: normalFromTangents(right, down),
      flat: [distance - first, (options.patternWidth * row) / columns],
    };
  });
}

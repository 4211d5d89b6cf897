/** The charts of an unfolded mesh, and which of them lies where. */
import { chartsOf, repeatOf } from "../engine/uv-charts.ts";

/** Cells along each side of the grid by which a place's triangle is found. */
const CELLS = 64;

/** An upright rectangle of the texture: least and greatest u and v. */
export interface UvBounds {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
}

export class UvCharts {
  /** The chart of each triangle: the lowest index of its triangles. */
  readonly chartOf: Uint32Array;
  readonly #corners: Float32Array;
  /** Triangles that may lie in each cell; made at the first question. */
  #cells: number[][] | null = null;
  readonly #bounds = new Map<number, UvBounds>();

  /** @param uvTriangles six numbers a triangle, as the model has them */
  constructor(uvTriangles: Float32Array) {
    this.chartOf = chartsOf(uvTriangles);
    this.#corners = new Float32Array(this.chartOf.length * 6);
    for (let start = 0; start < this.#corners.length; start += 6) {
      const [right, down] = repeatOf(uvTriangles, start);
      for (let at = start; at < start + 6; at += 2) {
        this.#corners[at] = (uvTriangles[at] as number) - right;
        this.#corners[at + 1] = (uvTriangles[at + 1] as number) - down;
      }
    }
  }

  /** The chart at a place of the texture, wrapped; null beside all charts. The first triangle there counts. */
  chartAt(uv: readonly [number, number]): number | null {
    const triangle = this.triangleAt(uv);
    return triangle === null ? null : (this.chartOf[triangle] as number);
  }

  /** Round the chart at a place of the texture, in that repetition of the texture; null beside all charts. */
  boundsAt(uv: readonly [number, number]): UvBounds | null {
    const chart = this.chartAt(uv);
    if (chart === null) return null;
    const bounds = this.#bounds.get(chart) ?? boundsOf(this.cornersOfChart(chart));
    this.#bounds.set(chart, bounds);
    const [right, down] = [Math.floor(uv[0]), Math.floor(uv[1])];
    const shifted = ([u, v]: readonly [number, number]): [number, number] => [u + right, v + down];
    return { low: shifted(bounds.low), high: shifted(bounds.high) };
  }

  /** The first triangle at a place of the texture. */
  triangleAt([u, v]: readonly [number, number]): number | null {
    this.#cells ??= this.#fillCells();
    const [x, y] = [u - Math.floor(u), v - Math.floor(v)];
    const cell = this.#cells[cellOf(y) * CELLS + cellOf(x)] ?? [];
    return cell.find((triangle) => this.sharesAt(triangle, [x, y]) !== null) ?? null;
  }

  /** Shares of a triangle's corners at a place of the texture; null outside of it. */
  sharesAt(triangle: number, [u, v]: readonly [number, number]): [number, number, number] | null {
    const [u0, v0, u1, v1, u2, v2] = this.cornersOf(triangle) as unknown as Six;
    const area = (u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0);
    if (area === 0) {
      return null;
    }
    const second = ((u - u0) * (v2 - v0) - (u2 - u0) * (v - v0)) / area;
    const third = ((u1 - u0) * (v - v0) - (u - u0) * (v1 - v0)) / area;
    const slack = -1e-6;
    const inside = second >= slack && third >= slack && second + third <= 1 - slack;
    return inside ? [1 - second - third, second, third] : null;
  }

  trianglesOf(chart: number): number[] {
    const triangles: number[] = [];
    for (const [triangle, of] of this.chartOf.entries()) {
      if (of === chart) {
        triangles.push(triangle);
      }
    }
    return triangles;
  }

  /** Six numbers, brought back into [0, 1) as a whole. */
  cornersOf(triangle: number): Float32Array {
    return this.#corners.subarray(triangle * 6, triangle * 6 + 6);
  }

  /** All corners of a chart's triangles, six numbers each. */
  cornersOfChart(chart: number): Float32Array {
    const triangles = this.trianglesOf(chart);
    const corners = new Float32Array(triangles.length * 6);
    for (const [place, triangle] of triangles.entries()) {
      corners.set(this.cornersOf(triangle), place * 6);
    }
    return corners;
  }

  #fillCells(): number[][] {
    const cells: number[][] = Array.from({ length: CELLS * CELLS }, () => []);
    for (let triangle = 0; triangle < this.chartOf.length; triangle++) {
      const at = (place: number): number => this.#corners[triangle * 6 + place] as number;
      const left = cellOf(Math.min(at(0), at(2), at(4)));
      const right = cellOf(Math.max(at(0), at(2), at(4)));
      const top = cellOf(Math.min(at(1), at(3), at(5)));
      const bottom = cellOf(Math.max(at(1), at(3), at(5)));
      for (let row = top; row <= bottom; row++) {
        for (let column = left; column <= right; column++) {
          cells[row * CELLS + column]?.push(triangle);
        }
      }
    }
    return cells;
  }
}

/** @param corners u and v in turn */
function boundsOf(corners: Float32Array): UvBounds {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let at = 0; at < corners.length; at += 2) {
    const [u, v] = [corners[at] as number, corners[at + 1] as number];
    [left, right] = [Math.min(left, u), Math.max(right, u)];
    [top, bottom] = [Math.min(top, v), Math.max(bottom, v)];
  }
  return { low: [left, top], high: [right, bottom] };
}

type Six = readonly [number, number, number, number, number, number];

function cellOf(coordinate: number): number {
  return Math.min(CELLS - 1, Math.max(0, Math.floor(coordinate * CELLS)));
}

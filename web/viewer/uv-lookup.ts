/** From a place in the flat texture to the surface that it is painted on. */
import type { RestingSurface } from "./resting-surface.ts";

/** A triangle and the shares of its three corners at a place. */
export interface UvPlace {
  readonly triangle: number;
  readonly shares: readonly [number, number, number];
}

/** A place on an edge is in both triangles, whatever the last digits say. */
const SLACK = 1e-7;
/** Of a triangle that covers more tiles than this on a side, the others go unanswered. */
const MOST_TILES = 16;
/** Cells along each side of the grid over the unit square. */
const CELLS = 64;

/**
 * One material's triangles by where they lie in texture space. Coordinates wrap (spec.md, 1); where triangles overlap the
 * one with the lowest index owns the place, as in the bake (spec.md, 2).
 */
export class UvLookup {
  readonly #surface: Pick<RestingSurface, "uvs" | "index">;
  readonly #cells: (number[] | undefined)[] = new Array(CELLS * CELLS);

  constructor(surface: Pick<RestingSurface, "uvs" | "index" | "materialOfTriangle">, material: number) {
    this.#surface = surface;
    for (let triangle = 0; triangle < surface.materialOfTriangle.length; triangle++) {
      if (surface.materialOfTriangle[triangle] === material) this.#enter(triangle);
    }
  }

  /** Null where no triangle of the material lies. */
  at(u: number, v: number): UvPlace | null {
    const [x, y] = [wrap(u), wrap(v)];
    for (const triangle of this.#cells[cellOf(y) * CELLS + cellOf(x)] ?? []) {
      const shares = this.#sharesAt(triangle, x, y);
      if (shares !== null) return { triangle, shares };
    }
    return null;
  }

  #enter(triangle: number): void {
    const [a, b, c] = this.#cornersOf(triangle);
    const low = [Math.min(a[0], b[0], c[0]), Math.min(a[1], b[1], c[1])] as const;
    const high = [Math.max(a[0], b[0], c[0]), Math.max(a[1], b[1], c[1])] as const;
    if (!(low.every(Number.isFinite) && high.every(Number.isFinite))) return;
    const cells = (axis: 0 | 1): number[] => {
      const first = Math.floor(low[axis] * CELLS);
      const last = Math.min(Math.floor(high[axis] * CELLS), first + CELLS - 1);
      return Array.from({ length: last - first + 1 }, (_, step) => (((first + step) % CELLS) + CELLS) % CELLS);
    };
    const columns = cells(0);
    for (const row of cells(1)) {
      for (const column of columns) {
        const at = row * CELLS + column;
        const cell = this.#cells[at] ?? [];
        this.#cells[at] = cell;
        cell.push(triangle);
      }
    }
  }

  #sharesAt(triangle: number, x: number, y: number): UvPlace["shares"] | null {
    const [a, b, c] = this.#cornersOf(triangle);
    const area = cross(a, b, c);
    if (area === 0) return null;
    // The place in each of the tiles that the triangle lies in.
    for (const tileY of tilesOf(a[1], b[1], c[1])) {
      for (const tileX of tilesOf(a[0], b[0], c[0])) {
        const at = [x + tileX, y + tileY] as const;
        const shares = [cross(at, b, c) / area, cross(a, at, c) / area, cross(a, b, at) / area] as const;
        if (shares.every((share) => share >= -SLACK)) return shares;
      }
    }
    return null;
  }

  #cornersOf(triangle: number): [UvPoint, UvPoint, UvPoint] {
    const { uvs, index } = this.#surface;
    const corner = (step: number): UvPoint => {
      const vertex = index[triangle * 3 + step] as number;
      return [uvs[vertex * 2] as number, uvs[vertex * 2 + 1] as number];
    };
    return [corner(0), corner(1), corner(2)];
  }
}

type UvPoint = readonly [number, number];

/** Twice the area of a triangle, signed. */
const cross = (a: UvPoint, b: UvPoint, c: UvPoint): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

function tilesOf(...values: readonly number[]): number[] {
  const first = Math.floor(Math.min(...values));
  const count = Math.min(MOST_TILES, Math.floor(Math.max(...values)) - first + 1);
  return Array.from({ length: count }, (_, step) => first + step);
}

const cellOf = (value: number): number => Math.min(CELLS - 1, Math.floor(value * CELLS));

function wrap(value: number): number {
  const wrapped = value - Math.floor(value);
  return wrapped < 1 ? wrapped : 0;
}

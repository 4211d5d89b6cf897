/** The lines of an unfolded mesh: chart borders, which one triangle has, told from inner edges, which two share. */

import { broughtBack, gridKey } from "../engine/uv-charts.ts";

export interface UvEdges {
  /** Four numbers a line: u, v of both ends. */
  readonly borders: Float32Array;
  readonly inner: Float32Array;
}

/** Mean length of lines, in texture widths; 0 without any. */
export function meanLength(lines: Float32Array): number {
  let total = 0;
  for (let line = 0; line < lines.length; line += 4) {
    const [u0, v0, u1, v1] = lines.subarray(line, line + 4) as unknown as [number, number, number, number];
    total += Math.hypot(u1 - u0, v1 - v0);
  }
  return lines.length === 0 ? 0 : total / (lines.length / 4);
}

/**
 * @param uvTriangles six numbers a triangle, as the model has them: triangles that lie in another repeat of the texture
 *   are brought back into [0, 1) as a whole
 */
export function uvEdges(uvTriangles: Float32Array): UvEdges {
  const ends: number[] = [];
  const uses: number[] = [];
  const vertices = new Map<number, number>();
  const edges = new Map<number, number>();
  for (let triangle = 0; triangle + 5 < uvTriangles.length; triangle += 6) {
    const corners = broughtBack(uvTriangles.subarray(triangle, triangle + 6));
    for (let corner = 0; corner < 6; corner += 2) {
      const [fromU, fromV] = [corners[corner] as number, corners[corner + 1] as number];
      const [toU, toV] = [corners[(corner + 2) % 6] as number, corners[(corner + 3) % 6] as number];
      const from = numberOf(vertices, gridKey(fromU, fromV));
      const to = numberOf(vertices, gridKey(toU, toV));
      // The same for both directions of an edge; numbers hold 2^26 vertices twice.
      const edge = numberOf(edges, Math.min(from, to) * 2 ** 26 + Math.max(from, to));
      if (edge === uses.length) {
        ends.push(fromU, fromV, toU, toV);
      }
      uses[edge] = (uses[edge] ?? 0) + 1;
    }
  }
  return { borders: linesOf(ends, uses, true), inner: linesOf(ends, uses, false) };
}

function linesOf(ends: readonly number[], uses: readonly number[], border: boolean): Float32Array {
  const lines: number[] = [];
  for (const [edge, use] of uses.entries()) {
    if ((use === 1) === border) {
      lines.push(...ends.slice(edge * 4, edge * 4 + 4));
    }
  }
  return Float32Array.from(lines);
}

/** The key's place in the order in which keys came. */
function numberOf(known: Map<number, number>, key: number): number {
  const number = known.get(key) ?? known.size;
  known.set(key, number);
  return number;
}

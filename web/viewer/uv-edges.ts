/** The lines of an unfolded mesh: chart borders, which one triangle has, told from inner edges, which two share. */

import { gridKey, repeatOf } from "../engine/uv-charts.ts";

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
  for (let start = 0; start + 5 < uvTriangles.length; start += 6) {
    const [right, down] = repeatOf(uvTriangles, start);
    for (let corner = 0; corner < 6; corner += 2) {
      const fromU = (uvTriangles[start + corner] as number) - right;
      const fromV = (uvTriangles[start + corner + 1] as number) - down;
      const next = start + ((corner + 2) % 6);
      const toU = (uvTriangles[next] as number) - right;
      const toV = (uvTriangles[next + 1] as number) - down;
      const from = numberOf(vertices, gridKey(fromU, fromV));
      const to = numberOf(vertices, gridKey(toU, toV));
      const edge = numberOf(edges, edgeKey(from, to));
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
  for (let edge = 0; edge < uses.length; edge++) {
    if ((uses[edge] === 1) !== border) continue;
    for (let at = edge * 4; at < edge * 4 + 4; at++) lines.push(ends[at] as number);
  }
  return Float32Array.from(lines);
}

/** The same for both directions of an edge between two vertices by their numbers, of which there may be 2^26. */
export function edgeKey(from: number, to: number): number {
  return Math.min(from, to) * 2 ** 26 + Math.max(from, to);
}

/** The key's place in the order in which keys came. */
export function numberOf(known: Map<number, number>, key: number): number {
  const number = known.get(key);
  if (number !== undefined) return number;
  known.set(key, known.size);
  return known.size - 1;
}

/**
 * Connected parts of a surface. Vertices that lie in the same place are one, whatever seams in texture or normals
 * separate them in the file.
 */
import type { RestingSurface } from "./resting-surface.ts";

/** A number for each triangle, the same for triangles that are joined by shared corners. */
export function shellsOf(surface: Pick<RestingSurface, "positions" | "index">): Uint32Array {
  const { positions, index } = surface;
  const welded = weld(positions);
  const parent = Uint32Array.from({ length: welded.count }, (_, place) => place);
  for (let corner = 0; corner < index.length; corner += 3) {
    const [a, b, c] = [0, 1, 2].map((next) => welded.placeOf[index[corner + next] as number] as number);
    join(parent, a as number, b as number);
    join(parent, a as number, c as number);
  }
  return Uint32Array.from({ length: index.length / 3 }, (_, triangle) =>
    rootOf(parent, welded.placeOf[index[triangle * 3] as number] as number),
  );
}

/** Exact equality: seams repeat a vertex bit by bit. */
function weld(positions: Float32Array): { placeOf: Uint32Array; count: number } {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const places = new Map<string, number>();
  const placeOf = new Uint32Array(positions.length / 3);
  for (let vertex = 0; vertex < placeOf.length; vertex++) {
    const key = `${bits[vertex * 3]},${bits[vertex * 3 + 1]},${bits[vertex * 3 + 2]}`;
    const place = places.get(key) ?? places.size;
    places.set(key, place);
    placeOf[vertex] = place;
  }
  return { placeOf, count: places.size };
}

function join(parent: Uint32Array, a: number, b: number): void {
  const [rootA, rootB] = [rootOf(parent, a), rootOf(parent, b)];
  parent[Math.max(rootA, rootB)] = Math.min(rootA, rootB);
}

function rootOf(parent: Uint32Array, place: number): number {
  let at = place;
  while (parent[at] !== at) {
    // Halving the path keeps later walks short.
    parent[at] = parent[parent[at] as number] as number;
    at = parent[at] as number;
  }
  return at;
}

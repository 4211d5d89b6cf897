/**
 * Connected parts of a surface. Vertices that lie in the same place are one, whatever seams in texture or normals
 * separate them in the file.
 */
import type { RestingSurface } from "./resting-surface.ts";

/** A number for each triangle, the same for triangles that are joined by shared corners. */
export function shellsOf(surface: Pick<RestingSurface, "positions" | "index">): Uint32Array {
  const { positions, index } = surface;
  const welded = weld(positions);
  const parent = new Uint32Array(welded.count).map((_, place) => place);
  for (let corner = 0; corner < index.length; corner += 3) {
    const a = welded.placeOf[index[corner] as number] as number;
    join(parent, a, welded.placeOf[index[corner + 1] as number] as number);
    join(parent, a, welded.placeOf[index[corner + 2] as number] as number);
  }
  return new Uint32Array(index.length / 3).map((_, triangle) =>
    rootOf(parent, welded.placeOf[index[triangle * 3] as number] as number),
  );
}

/**
 * Exact equality: seams repeat a vertex bit by bit. A table of our own with open addressing, since a Map with keys of
 * text takes ten times as long.
 */
function weld(positions: Float32Array): { placeOf: Uint32Array; count: number } {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const placeOf = new Uint32Array(positions.length / 3);
  const firstVertex = new Uint32Array(placeOf.length);
  const slots = new Uint32Array(2 ** Math.ceil(Math.log2(placeOf.length * 2 + 2)));
  let count = 0;
  for (let vertex = 0; vertex < placeOf.length; vertex++) {
    const at = vertex * 3;
    const same = (other: number) =>
      bits[at] === bits[other] && bits[at + 1] === bits[other + 1] && bits[at + 2] === bits[other + 2];
    let slot = hash(bits[at] as number, bits[at + 1] as number, bits[at + 2] as number) & (slots.length - 1);
    // Slots hold places plus one; 0 is free.
    while (slots[slot] !== 0 && !same((firstVertex[(slots[slot] as number) - 1] as number) * 3)) {
      slot = (slot + 1) & (slots.length - 1);
    }
    if (slots[slot] === 0) {
      firstVertex[count] = vertex;
      count += 1;
      slots[slot] = count;
    }
    placeOf[vertex] = (slots[slot] as number) - 1;
  }
  return { placeOf, count };
}

/** The mixing of MurmurHash3's body, on three words. */
function hash(x: number, y: number, z: number): number {
  let mixed = 0;
  for (const word of [x, y, z]) {
    mixed ^= Math.imul(word, 0xcc9e2d51);
    mixed = Math.imul((mixed << 13) | (mixed >>> 19), 0x1b873593) + 0x6546b64;
  }
  return (mixed ^ (mixed >>> 16)) >>> 0;
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

/** Where a node puts what it holds: a linear map and where it lays the origin (glTF 2.0, 3.5.2). */
import type { JsonObject } from "./gltf-json.ts";

/** Columns of a linear map. */
export type Linear = readonly [
  readonly [number, number, number],
  readonly [number, number, number],
  readonly [number, number, number],
];

export interface Affine {
  readonly linear: Linear;
  readonly origin: readonly [number, number, number];
}

/** Leaves everything where it is. */
export const IDENTITY: Affine = {
  linear: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  origin: [0, 0, 0],
};

/** Of a node in its parent, as its matrix says, or its translation, rotation and scale; what is no number is as if not given. */
export function placeOf(node: JsonObject): Affine {
  if (Array.isArray(node.matrix)) return affineOf(numbersOf(node.matrix, 16, 0));
  const [x = 0, y = 0, z = 0, w = 1] = Array.isArray(node.rotation) ? numbersOf(node.rotation, 4, 0) : [0, 0, 0, 1];
  const [sx = 1, sy = 1, sz = 1] = Array.isArray(node.scale) ? numbersOf(node.scale, 3, 1) : [1, 1, 1];
  const [tx = 0, ty = 0, tz = 0] = Array.isArray(node.translation) ? numbersOf(node.translation, 3, 0) : [0, 0, 0];
  return {
    linear: [
      [sx * (1 - 2 * (y * y + z * z)), sx * 2 * (x * y + z * w), sx * 2 * (x * z - y * w)],
      [sy * 2 * (x * y - z * w), sy * (1 - 2 * (x * x + z * z)), sy * 2 * (y * z + x * w)],
      [sz * 2 * (x * z + y * w), sz * 2 * (y * z - x * w), sz * (1 - 2 * (x * x + y * y))],
    ],
    origin: [tx, ty, tz],
  };
}

const numbersOf = (list: readonly unknown[], count: number, otherwise: number): number[] =>
  Array.from({ length: count }, (_, i) => (typeof list[i] === "number" ? (list[i] as number) : otherwise));

/** Of the `index`-th matrix of four columns of four in a row of them. */
export function affineOf(matrices: ArrayLike<number>, index = 0): Affine {
  const column = (i: number): [number, number, number] => {
    const at = 16 * index + 4 * i;
    return [matrices[at] ?? 0, matrices[at + 1] ?? 0, matrices[at + 2] ?? 0];
  };
  return { linear: [column(0), column(1), column(2)], origin: column(3) };
}

/** First `b`, then `a`. */
export function times(a: Linear, b: Linear): Linear {
  const column = (by: readonly [number, number, number]): [number, number, number] => turned(a, by[0], by[1], by[2]);
  return [column(b[0]), column(b[1]), column(b[2])];
}

/** First `inner`, then `outer`. */
export function within(outer: Affine, inner: Affine): Affine {
  return { linear: times(outer.linear, inner.linear), origin: moved(outer, ...inner.origin) };
}

/** The vector as the map has it. */
export function turned([a, b, c]: Linear, x: number, y: number, z: number): [number, number, number] {
  return [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z];
}

/** The point as the map has it. */
export function moved({ linear, origin }: Affine, x: number, y: number, z: number): [number, number, number] {
  const [tx, ty, tz] = turned(linear, x, y, z);
  return [tx + origin[0], ty + origin[1], tz + origin[2]];
}

/** What a map makes of areas' normals, in direction: the inverse transpose but for its length, and for its sign in a mirror. */
export const cofactorsOf = ([a, b, c]: Linear): Linear => [cross(b, c), cross(c, a), cross(a, b)];

export const cross = (a: readonly number[], b: readonly number[]): [number, number, number] => {
  const [ax = 0, ay = 0, az = 0] = a;
  const [bx = 0, by = 0, bz = 0] = b;
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
};

/** Whether the map shows what it turns as in a mirror. */
export function isMirroring([a, b, c]: Linear): boolean {
  return (
    a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]) < 0
  );
}

/** How large a mesh stands in its scene: charts are cut and measured by the size that a viewer sees (glTF 2.0, 3.5.3). */

import type { Accessors } from "../accessors.ts";
import { indexAt, type JsonObject, listOf } from "../gltf-json.ts";

/** Columns of a linear map. */
export type Linear = readonly [
  readonly [number, number, number],
  readonly [number, number, number],
  readonly [number, number, number],
];

const NONE: Linear = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * What the first node with this mesh makes of its directions and lengths; of a skinned one, what its first joint does. A mesh
 * of several nodes has one set of texture coordinates, so one of them has to say.
 */
export function scaleOfMesh(json: JsonObject, mesh: number, accessors: Accessors, name: string): Linear {
  const nodes = listOf(json, "nodes", name);
  const node = nodes.findIndex((each) => each.mesh === mesh);
  if (node < 0) return NONE;
  const skin = listOf(json, "skins", name)[indexAt(nodes[node], "skin") ?? -1];
  if (skin === undefined) return worldOf(nodes, node);
  const joint = Array.isArray(skin.joints) && typeof skin.joints[0] === "number" ? skin.joints[0] : -1;
  const world = worldOf(nodes, joint);
  const bind = indexAt(skin, "inverseBindMatrices");
  return bind === undefined ? world : times(world, linearOf(accessors.readNumbers(bind)));
}

function worldOf(nodes: readonly JsonObject[], node: number): Linear {
  let world = NONE;
  let at = node;
  // A file may call a node its own ancestor: no chain is longer than there are nodes.
  for (let steps = 0; steps <= nodes.length && nodes[at] !== undefined; steps++) {
    world = times(localOf(nodes[at] as JsonObject), world);
    const child = at;
    at = nodes.findIndex(({ children }) => Array.isArray(children) && children.includes(child));
  }
  return world;
}

function localOf(node: JsonObject): Linear {
  if (Array.isArray(node.matrix)) return linearOf(numbersOf(node.matrix, 16, 0));
  const [x = 0, y = 0, z = 0, w = 1] = Array.isArray(node.rotation) ? numbersOf(node.rotation, 4, 0) : [0, 0, 0, 1];
  const [sx = 1, sy = 1, sz = 1] = Array.isArray(node.scale) ? numbersOf(node.scale, 3, 1) : [1, 1, 1];
  return [
    [sx * (1 - 2 * (y * y + z * z)), sx * 2 * (x * y + z * w), sx * 2 * (x * z - y * w)],
    [sy * 2 * (x * y - z * w), sy * (1 - 2 * (x * x + z * z)), sy * 2 * (y * z + x * w)],
    [sz * 2 * (x * z + y * w), sz * 2 * (y * z - x * w), sz * (1 - 2 * (x * x + y * y))],
  ];
}

const numbersOf = (list: readonly unknown[], count: number, otherwise: number): number[] =>
  Array.from({ length: count }, (_, i) => (typeof list[i] === "number" ? (list[i] as number) : otherwise));

/** Of a matrix of four columns of four. */
function linearOf(matrix: ArrayLike<number>): Linear {
  const column = (i: number): [number, number, number] => [
    matrix[4 * i] ?? 0,
    matrix[4 * i + 1] ?? 0,
    matrix[4 * i + 2] ?? 0,
  ];
  return [column(0), column(1), column(2)];
}

function times(a: Linear, b: Linear): Linear {
  const column = (by: readonly [number, number, number]): [number, number, number] => turned(a, by[0], by[1], by[2]);
  return [column(b[0]), column(b[1]), column(b[2])];
}

/** The vector as the map has it. */
export function turned([a, b, c]: Linear, x: number, y: number, z: number): [number, number, number] {
  return [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z];
}

/** Whether the map shows what it turns as in a mirror. */
export function isMirroring([a, b, c]: Linear): boolean {
  return (
    a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]) < 0
  );
}

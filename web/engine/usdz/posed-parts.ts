/**
 * A model's triangles where a viewer shows them at rest: nodes, skins in the nodes' own pose and morph targets at their default
 * weights applied (spec section 1), as OpenUSD's viewers have no word for all of these.
 */
import type { Accessors } from "../accessors.ts";
import {
  type Affine,
  affineOf,
  cofactorsOf,
  IDENTITY,
  isMirroring,
  moved,
  placeOf,
  turned,
  within,
} from "../affine-map.ts";
import { badContainer, indexAt, isObject, type JsonObject, listOf, objectAt } from "../gltf-json.ts";
import { isOfTriangles, trianglesOf } from "../primitive-triangles.ts";

/** One primitive of one node. */
export interface PosedPart {
  /** glTF material index; one past the last is the implied default material. */
  readonly material: number;
  /** Three numbers a vertex, metres. */
  readonly positions: Float64Array;
  /** Three numbers a vertex, of unit length; null where the file has none: its faces are flat then. */
  readonly normals: Float64Array | null;
  /** Two numbers a vertex of a UV set; null where the primitive lacks it. */
  uvs(set: number): Float64Array | null;
  /** Three vertices a triangle, anticlockwise as seen from its front. */
  readonly triangles: Uint32Array;
}

/**
 * Of the default scene. `json` and `accessors` are of an uncompressed model without instances. Throws "bad-container" for what does
 * not fit together.
 */
export function* posedParts(json: JsonObject, accessors: Accessors, name: string): Generator<PosedPart> {
  const nodes = listOf(json, "nodes", name);
  const meshes = listOf(json, "meshes", name);
  const implied = listOf(json, "materials", name).length;
  const places = placesOf(json, name);
  for (const index of shownNodes(json, name)) {
    const node = nodes[index] as JsonObject;
    const mesh = meshes[indexAt(node, "mesh") ?? -1];
    if (!Array.isArray(mesh?.primitives)) continue;
    const weights = Array.isArray(node.weights) ? node.weights : mesh.weights;
    const skin = listOf(json, "skins", name)[indexAt(node, "skin") ?? -1];
    const joints = skin && jointsOf(skin, places, accessors);
    for (const primitive of mesh.primitives) {
      if (!isObject(primitive) || !isOfTriangles(primitive)) continue;
      const vertices = new Vertices(primitive, Array.isArray(weights) ? weights : [], accessors, name);
      if (vertices.count === 0) continue;
      const place = places[index] ?? IDENTITY;
      const placing = joints ? vertices.skinnedBy(joints) : () => place;
      yield {
        material: indexAt(primitive, "material") ?? implied,
        ...vertices.placed(placing),
        uvs: (set) => vertices.read(`TEXCOORD_${set}`, 2),
        triangles: turnedOver(
          trianglesOf(primitive, vertices.count, accessors, name),
          isMirroring((joints ? placing(0) : place).linear),
        ),
      };
    }
  }
}

/** A primitive's attributes, its morph targets added. */
class Vertices {
  readonly count: number;
  readonly #attributes: JsonObject;
  readonly #targets: readonly JsonObject[];
  readonly #weights: readonly unknown[];
  readonly #accessors: Accessors;
  readonly #name: string;

  constructor(primitive: JsonObject, weights: readonly unknown[], accessors: Accessors, name: string) {
    this.#attributes = objectAt(primitive, "attributes") ?? {};
    this.#targets = Array.isArray(primitive.targets) ? primitive.targets.filter(isObject) : [];
    this.#weights = weights;
    this.#accessors = accessors;
    this.#name = name;
    const position = indexAt(this.#attributes, "POSITION");
    this.count = position === undefined ? 0 : (indexAt(accessors.at(position), "count") ?? 0);
  }

  /** `size` numbers a vertex, or null where there is no such attribute. */
  read(key: string, size: number): Float64Array | null {
    const numbers = this.#numbers(this.#attributes, key, size);
    if (numbers === null) return null;
    for (const [i, target] of this.#targets.entries()) {
      const weight = this.#weights[i];
      if (typeof weight !== "number" || weight === 0) continue;
      const changes = this.#numbers(target, key, size);
      changes?.forEach((change, at) => {
        numbers[at] = (numbers[at] as number) + weight * change;
      });
    }
    return numbers;
  }

  #numbers(attributes: JsonObject, key: string, size: number): Float64Array | null {
    const index = indexAt(attributes, key);
    if (index === undefined) return null;
    const numbers = this.#accessors.readNumbers(index, this.count);
    if (numbers.length === size * this.count) return numbers;
    throw badContainer(this.#name, `“accessors[${index}]” is ${key} but no VEC${size}`, `accessors[${index}].type`);
  }

  /** What places each vertex: its joints', by their weights. Weights ought to add up to 1; like common viewers, makes them. */
  skinnedBy(joints: readonly Affine[]): (vertex: number) => Affine {
    const columns = joints.map(({ linear, origin }) => [...linear, origin].flat());
    const sets = [0, 1].flatMap((set) => {
      const names = this.#numbers(this.#attributes, `JOINTS_${set}`, 4);
      const weights = this.#numbers(this.#attributes, `WEIGHTS_${set}`, 4);
      return names === null || weights === null ? [] : [{ names, weights }];
    });
    return (vertex) => {
      const sum = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
      let total = 0;
      for (const { names, weights } of sets) {
        for (let i = 4 * vertex; i < 4 * vertex + 4; i++) {
          const weight = weights[i] as number;
          const joint = columns[names[i] as number];
          if (weight === 0 || joint === undefined) continue;
          total += weight;
          for (let c = 0; c < sum.length; c++) sum[c] = (sum[c] as number) + weight * (joint[c] as number);
        }
      }
      if (total === 0) return IDENTITY;
      const column = (c: number): [number, number, number] => [
        (sum[3 * c] as number) / total,
        (sum[3 * c + 1] as number) / total,
        (sum[3 * c + 2] as number) / total,
      ];
      return { linear: [column(0), column(1), column(2)], origin: column(3) };
    };
  }

  placed(placing: (vertex: number) => Affine): Pick<PosedPart, "positions" | "normals"> {
    const positions = this.read("POSITION", 3) ?? new Float64Array();
    const normals = this.read("NORMAL", 3);
    for (let vertex = 0; vertex < this.count; vertex++) {
      const at = 3 * vertex;
      const place = placing(vertex);
      positions.set(moved(place, ...threeAt(positions, at)), at);
      if (normals === null) continue;
      const [x, y, z] = turned(cofactorsOf(place.linear), ...threeAt(normals, at));
      const length = Math.sqrt(x * x + y * y + z * z) * (isMirroring(place.linear) ? -1 : 1);
      normals.set(length === 0 ? [0, 0, 1] : [x / length, y / length, z / length], at);
    }
    return { positions, normals };
  }
}

const threeAt = (list: Float64Array, at: number): [number, number, number] => [
  list[at] as number,
  list[at + 1] as number,
  list[at + 2] as number,
];

/** A mirror turns a triangle's front to its back. */
function turnedOver(triangles: Uint32Array, turn: boolean): Uint32Array {
  if (!turn) return triangles;
  for (let i = 0; i < triangles.length; i += 3) {
    const second = triangles[i + 1] as number;
    triangles[i + 1] = triangles[i + 2] as number;
    triangles[i + 2] = second;
  }
  return triangles;
}

/** Of the default scene; without scenes, of all nodes that no other holds. Each once, whatever the file says. */
function shownNodes(json: JsonObject, name: string): Set<number> {
  const nodes = listOf(json, "nodes", name);
  const scenes = listOf(json, "scenes", name);
  const scene = scenes[indexAt(json, "scene") ?? 0];
  const held = new Set(nodes.flatMap(childrenOf));
  const shown = new Set<number>();
  const waiting = scenes.length > 0 ? numbersIn(scene?.nodes) : [...nodes.keys()].filter((index) => !held.has(index));
  // Grows while it is read.
  for (const index of waiting) {
    const node = nodes[index];
    if (node === undefined || shown.has(index)) continue;
    shown.add(index);
    waiting.push(...childrenOf(node));
  }
  return shown;
}

/** Of every node, in model space: joints may stand outside the scene. */
function placesOf(json: JsonObject, name: string): Affine[] {
  const nodes = listOf(json, "nodes", name);
  const held = new Set(nodes.flatMap(childrenOf));
  const places: Affine[] = [];
  const waiting = [...nodes.keys()].filter((index) => !held.has(index)).map((index) => ({ index, parent: IDENTITY }));
  // Grows while it is read.
  for (const { index, parent } of waiting) {
    const node = nodes[index];
    if (node === undefined || places[index] !== undefined) continue;
    const place = within(parent, placeOf(node));
    places[index] = place;
    waiting.push(...childrenOf(node).map((child) => ({ index: child, parent: place })));
  }
  return places;
}

/** What a skin's joints make of its mesh. */
function jointsOf(skin: JsonObject, places: readonly Affine[], accessors: Accessors): Affine[] {
  const bind = indexAt(skin, "inverseBindMatrices");
  const matrices = bind === undefined ? null : accessors.readNumbers(bind);
  return numbersIn(skin.joints).map((joint, i) => {
    const place = places[joint] ?? IDENTITY;
    return matrices === null ? place : within(place, affineOf(matrices, i));
  });
}

const childrenOf = ({ children }: JsonObject): number[] => numbersIn(children);

const numbersIn = (list: unknown): number[] =>
  Array.isArray(list) ? list.filter((item) => typeof item === "number") : [];

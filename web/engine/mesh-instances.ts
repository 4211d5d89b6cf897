/**
 * A mesh that stands in many places by EXT_mesh_gpu_instancing, as a node for each of them: what paints and what shows a model then
 * knows them as any other mesh in several places.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { Accessors } from "./accessors.ts";
import { forgetExtension } from "./extension-names.ts";
import { parseJson, readContainer, writeGlb } from "./gltf-container.ts";
import { badContainer, indexAt, type JsonObject, listForWriting, objectAt } from "./gltf-json.ts";
import { INSTANCES } from "./model-extensions.ts";

/** Each becomes a node and is baked. */
const MOST_INSTANCES = 65_536;

/** What an instance may have of its own: its name, its accessor's type, the node's member, how many numbers. */
const PLACES = [
  ["TRANSLATION", "VEC3", "translation", 3],
  ["ROTATION", "VEC4", "rotation", 4],
  ["SCALE", "VEC3", "scale", 3],
] as const;

/**
 * The uncompressed GLB without the extension; nodes keep their indices, new ones stand behind them. Throws "bad-container" naming the
 * node whose lists do not fit each other, and "out-of-budget".
 */
export function withoutInstances(glb: Uint8Array<ArrayBuffer>, name: string): Uint8Array<ArrayBuffer> {
  const container = readContainer({ name, bytes: glb });
  const json = parseJson(container);
  const accessors = new Accessors(container.json, container.binary, name);
  const nodes = listForWriting(json, "nodes", name);
  let total = 0;
  for (const [index, node] of [...nodes.entries()]) {
    const extensions = objectAt(node, "extensions");
    const attributes = objectAt(objectAt(extensions, INSTANCES), "attributes");
    if (extensions !== undefined) delete extensions[INSTANCES];
    // A skinned mesh stands where its joints are, wherever its node is.
    if (attributes === undefined || node.mesh === undefined || node.skin !== undefined) continue;
    const places = placesOf(attributes, accessors, index, name);
    total += places.length;
    if (total > MOST_INSTANCES) throw tooMany(name, `nodes[${index}]`, total);
    if (places.length > 0) spread(nodes, node, places);
  }
  forgetExtension(json, INSTANCES);
  return writeGlb(json, container.binary, container.extraChunks);
}

/** Gives the node a child for each place, and its mesh to them. */
function spread(nodes: JsonObject[], node: JsonObject, places: readonly JsonObject[]): void {
  const { mesh, weights, name, children } = node;
  delete node.mesh;
  delete node.weights;
  const own = places.map((place, i) => {
    const title = typeof name === "string" && { name: `${name} ${i + 1}` };
    return nodes.push({ ...title, ...place, mesh: mesh ?? 0, ...(weights !== undefined && { weights }) }) - 1;
  });
  node.children = [...(Array.isArray(children) ? children : []), ...own];
}

/** Of each instance, what a node says of its place. */
function placesOf(attributes: JsonObject, accessors: Accessors, node: number, name: string): JsonObject[] {
  const path = `nodes[${node}].extensions.${INSTANCES}.attributes`;
  const counts = Object.keys(attributes).map((key) => {
    const index = indexAt(attributes, key);
    if (index === undefined) throw badContainer(name, `“${path}.${key}” names no accessor`, path, attributes[key]);
    return indexAt(accessors.at(index), "count") ?? 0;
  });
  const [count = 0] = counts;
  if (counts.some((other) => other !== count)) {
    throw badContainer(name, `“${path}” has lists of ${counts.join(" and ")} instances`, path, attributes);
  }
  // Before room is made for what the file only claims to have.
  if (count > MOST_INSTANCES) throw tooMany(name, path, count);
  const places = Array.from({ length: count }, (): JsonObject => ({}));
  for (const [key, type, member, size] of PLACES) {
    const index = indexAt(attributes, key);
    if (index === undefined) continue;
    if (accessors.at(index).type !== type) {
      throw badContainer(name, `“${path}.${key}” is no ${type}`, `${path}.${key}`, accessors.at(index).type);
    }
    const numbers = accessors.readNumbers(index);
    for (const [i, place] of places.entries()) {
      const own = [...numbers.subarray(i * size, (i + 1) * size)];
      place[member] = member === "rotation" ? unitOf(own) : own;
    }
  }
  return places;
}

/** Quaternions in whole numbers are only near to one. */
function unitOf(quaternion: number[]): number[] {
  const length = Math.sqrt(quaternion.reduce((sum, value) => sum + value * value, 0));
  return length > 0 ? quaternion.map((value) => value / length) : [0, 0, 0, 1];
}

const tooMany = (name: string, field: string, count: number): TexelcastError =>
  new TexelcastError(
    "out-of-budget",
    `“${name}” has ${count} instances of its meshes, and ${MOST_INSTANCES} are the most.`,
    {
      subject: name,
      field,
      value: String(count),
      hint: "Export the model with fewer of them.",
    },
  );

/** A model's geometry said in a way that three.js understands, where the file's own is sound glTF and three.js is wrong about it. */
import { COMPONENT_BYTES, SHAPES } from "../engine/accessor-shapes.ts";
import { Accessors } from "../engine/accessors.ts";
import { indexAt, isObject, type JsonObject, listForWriting, listOf, objectAt, textAt } from "../engine/gltf-json.ts";
import { allPrimitives } from "../engine/gltf-primitives.ts";
import { OWN_WEIGHTS } from "./all-joints.ts";

/** What it morphs: where some of a primitive's targets have one, it takes the vertices' own for those that lack it. */
const MORPHED = ["POSITION", "NORMAL", "COLOR_0"];

/** The new BIN, `json` changed; null where there is nothing to change. `name` is the file that errors name. */
export function plainGeometry(json: JsonObject, binary: Uint8Array | null, name: string): Uint8Array | null {
  const views = listOf(json, "bufferViews", name);
  const list = listForWriting(json, "accessors", name);
  const accessors = new Accessors(json, binary, name);
  const misread = [...list.keys()].filter((index) => {
    const accessor = list[index] ?? {};
    return isMisread(accessor, views[indexAt(accessor, "bufferView") ?? -1]);
  });
  for (const index of misread) {
    accessors.replace(index);
    const plain = accessors.addLike(index, accessors.read(index));
    list[index] = list[plain] as JsonObject;
  }
  const isFilled = fillTargets(json, list, name);
  const isKept = keepWeights(json, accessors, name);
  return misread.length > 0 || isFilled || isKept ? accessors.finish() : null;
}

/**
 * Elements that lie apart are misread where a sparse list replaces some of them, where one is cut in two by the gaps' grid, and where
 * the last has no gap behind it.
 */
function isMisread(accessor: JsonObject, view: JsonObject | undefined): boolean {
  const stride = indexAt(view, "byteStride");
  const [columns, rows] = SHAPES[textAt(accessor, "type") ?? ""] ?? [0, 0];
  const size = columns * rows * (COMPONENT_BYTES[accessor.componentType as number] ?? 0);
  if (stride === undefined || stride === size) return false;
  const offset = indexAt(accessor, "byteOffset") ?? 0;
  const end = offset - (offset % stride) + (indexAt(accessor, "count") ?? 0) * stride;
  return accessor.sparse !== undefined || (offset % stride) + size > stride || end > (indexAt(view, "byteLength") ?? 0);
}

/** Targets get what they lack as zeros, which is what an accessor without a buffer view holds. */
function fillTargets(json: JsonObject, list: JsonObject[], name: string): boolean {
  const before = list.length;
  const primitives = allPrimitives(json, name);
  for (const primitive of primitives) {
    const targets = Array.isArray(primitive.targets) ? primitive.targets.filter(isObject) : [];
    for (const key of MORPHED) {
      const own = list[indexAt(objectAt(primitive, "attributes"), key) ?? -1];
      const lacking = targets.filter((target) => target[key] === undefined);
      if (own === undefined || lacking.length === targets.length) continue;
      for (const target of lacking) {
        target[key] = list.push({ componentType: 5126, count: own.count ?? 0, type: own.type ?? "VEC3" }) - 1;
      }
    }
  }
  return list.length > before;
}

/** Vertices of more than four joints get their first four's weights a second time. */
function keepWeights(json: JsonObject, accessors: Accessors, name: string): boolean {
  let isKept = false;
  for (const primitive of allPrimitives(json, name)) {
    const attributes = objectAt(primitive, "attributes");
    const weights = indexAt(attributes, "WEIGHTS_0");
    if (attributes?.JOINTS_1 === undefined || weights === undefined) continue;
    attributes[OWN_WEIGHTS] = accessors.addLike(weights, accessors.read(weights));
    isKept = true;
  }
  return isKept;
}

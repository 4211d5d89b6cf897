/** Where a model's accessors reach beyond their bytes: what unpacks its geometry fails over that, or reads fewer elements, and does not say so. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { COMPONENT_BYTES, SHAPES } from "./accessor-shapes.ts";
import { padded } from "./gltf-container.ts";
import { badContainer, indexAt, type JsonObject, listOf, objectAt, textAt } from "./gltf-json.ts";
import { allPrimitives } from "./gltf-primitives.ts";
import { DRACO } from "./model-extensions.ts";

/** Null where all but those that Draco holds lie within their buffer views; "bad-container" naming the file for the first that does not. */
export function accessorBeyond(json: JsonObject, name: string): TexelcastError | null {
  const views = listOf(json, "bufferViews", name);
  const packed = packedByDraco(json, name);
  for (const [index, accessor] of listOf(json, "accessors", name).entries()) {
    if (packed.has(index)) continue;
    const view = views[indexAt(accessor, "bufferView") ?? -1];
    if (view === undefined) continue;
    const [columns, rows] = SHAPES[textAt(accessor, "type") ?? ""] ?? [1, 1];
    const columnBytes = rows * (COMPONENT_BYTES[accessor.componentType as number] ?? 1);
    const elementBytes = columns * (columns > 1 ? padded(columnBytes, 4) : columnBytes);
    const stride = indexAt(view, "byteStride") ?? elementBytes;
    const count = indexAt(accessor, "count") ?? 0;
    const end = (indexAt(accessor, "byteOffset") ?? 0) + (count - 1) * stride + elementBytes;
    const length = indexAt(view, "byteLength") ?? 0;
    if (end <= length) continue;
    const field = `accessors[${index}]`;
    const problem = `“${field}” reaches to byte ${end} of “bufferViews[${accessor.bufferView}]”, which has ${length}`;
    return badContainer(name, problem, `${field}.count`, count);
  }
  return null;
}

/** Of these, what they say of a buffer view is for readers without Draco. */
function packedByDraco(json: JsonObject, name: string): ReadonlySet<unknown> {
  const primitives = allPrimitives(json, name);
  return new Set(
    primitives.flatMap((primitive) => {
      const held = objectAt(objectAt(objectAt(primitive, "extensions"), DRACO), "attributes");
      if (held === undefined) return [];
      const attributes = objectAt(primitive, "attributes") ?? {};
      return [primitive.indices, ...Object.keys(held).map((key) => attributes[key])];
    }),
  );
}

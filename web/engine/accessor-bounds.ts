/** Where a model's accessors reach beyond their bytes. Asked only when what unpacks its geometry has failed, which does not say so. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { COMPONENT_BYTES, SHAPES } from "./accessor-shapes.ts";
import { padded } from "./gltf-container.ts";
import { badContainer, indexAt, type JsonObject, listOf, textAt } from "./gltf-json.ts";

/** Null where all lie within their buffer views; "bad-container" naming the file for the first that does not. */
export function accessorBeyond(json: JsonObject, name: string): TexelcastError | null {
  const views = listOf(json, "bufferViews", name);
  for (const [index, accessor] of listOf(json, "accessors", name).entries()) {
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

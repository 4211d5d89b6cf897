/**
 * Draco holds a primitive's numbers beside its accessors, and some programs (Adobe Dimension) have many primitives name the same ones,
 * which stand for nothing. Unpacked, each needs its own.
 */
import { indexAt, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { allPrimitives } from "./gltf-primitives.ts";
import { dracoOf } from "./unpack-geometry.ts";

/** Gives a primitive copies of the accessors that stand for other numbers already; `json` is changed. `name` is the file that errors name. */
export function separateAccessors(json: JsonObject, name: string): void {
  const accessors = listOf(json, "accessors", name);
  /** Accessors that stand for something, and of what each names, which one does. */
  const taken = new Set<number>();
  const standing = new Map<string, number>();
  const separate = (holder: JsonObject | undefined, key: string, source: string): void => {
    const index = indexAt(holder, key);
    const accessor = accessors[index ?? -1];
    if (holder === undefined || index === undefined || accessor === undefined) return;
    const known = standing.get(`${index} ${source}`);
    const isTaken = known === undefined && taken.has(index);
    const own = known ?? (isTaken ? accessors.push(structuredClone(accessor)) - 1 : index);
    if (own !== index) holder[key] = own;
    taken.add(own);
    standing.set(`${index} ${source}`, own);
  };
  for (const primitive of allPrimitives(json, name)) {
    const place = dracoOf(primitive);
    for (const [semantic, id] of Object.entries(objectAt(place, "attributes") ?? {})) {
      separate(objectAt(primitive, "attributes"), semantic, `${place?.bufferView} ${id}`);
    }
    if (place !== undefined) separate(primitive, "indices", `${place.bufferView}`);
  }
}

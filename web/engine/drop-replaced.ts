/** Takes out of a model the accessors that others have replaced, with their bytes, where nobody else can mean them. */
import { cutsOf, moveViews, spanOf, withoutCuts } from "./cut-bytes.ts";
import { indexAt, isObject, type JsonObject, type JsonValue, listOf, objectAt } from "./gltf-json.ts";

/** Extensions that name no accessor and no buffer view. One that is unknown here may, and where is not known either. */
const HARMLESS = new Set([
  "EXT_texture_avif",
  "EXT_texture_webp",
  "KHR_animation_pointer",
  "KHR_lights_punctual",
  "KHR_mesh_quantization",
  "KHR_node_visibility",
  "KHR_texture_basisu",
  "KHR_texture_transform",
  "KHR_xmp_json_ld",
]);
const isHarmless = (extension: string): boolean => HARMLESS.has(extension) || extension.startsWith("KHR_materials_");

/**
 * The BIN without what only `replaced` accessors lay on; `json` is changed in place, and what it names by number is numbered
 * anew. Both stay as they are where the model has an extension that may name some of it.
 */
export function dropReplaced(
  json: JsonObject,
  binary: Uint8Array,
  replaced: ReadonlySet<number>,
  name: string,
): Uint8Array {
  if (!extensionsOf(json).every(isHarmless)) return binary;
  const accessors = listOf(json, "accessors", name);
  const named = new Set(accessorNames(json, name).map(({ holder, key }) => holder[key]));
  const goneAccessors = new Set([...replaced].filter((index) => !named.has(index)));
  const gone = accessors.filter((_, index) => goneAccessors.has(index));
  if (gone.length === 0) return binary;

  const before = new Set(gone.flatMap(viewNames).map(({ holder, key }) => holder[key]));
  renumber(json, "accessors", goneAccessors, accessorNames(json, name), name);
  const places = [...listOf(json, "accessors", name).flatMap(viewNames), ...imageNames(json, name)];
  const alive = new Set(places.map(({ holder, key }) => holder[key]));
  const goneViews = new Set([...before].filter((view): view is number => typeof view === "number" && !alive.has(view)));
  const views = listOf(json, "bufferViews", name);
  const cuts = cutsOf(
    views.filter((_, index) => goneViews.has(index)).map(spanOf),
    views.filter((_, index) => !goneViews.has(index)).map(spanOf),
  );
  renumber(json, "bufferViews", goneViews, places, name);
  moveViews(json, cuts, name);
  return withoutCuts(binary, cuts);
}

/** Where a number of the JSON stands that names something in a list. */
interface Place {
  readonly holder: JsonObject;
  readonly key: string;
}

function accessorNames(json: JsonObject, name: string): Place[] {
  const all = (holder: JsonObject | undefined): Place[] =>
    holder === undefined ? [] : Object.keys(holder).map((key) => ({ holder, key }));
  const primitives = listOf(json, "meshes", name).flatMap((mesh) => objectsIn(mesh.primitives));
  const samplers = listOf(json, "animations", name).flatMap((animation) => objectsIn(animation.samplers));
  return [
    ...primitives.flatMap((primitive) => [
      ...all(objectAt(primitive, "attributes")),
      ...objectsIn(primitive.targets).flatMap(all),
      { holder: primitive, key: "indices" },
    ]),
    ...samplers.flatMap((holder) => [
      { holder, key: "input" },
      { holder, key: "output" },
    ]),
    ...listOf(json, "skins", name).map((holder) => ({ holder, key: "inverseBindMatrices" })),
  ];
}

function viewNames(accessor: JsonObject): Place[] {
  const sparse = objectAt(accessor, "sparse");
  return [accessor, objectAt(sparse, "indices"), objectAt(sparse, "values")]
    .filter((holder) => holder !== undefined)
    .map((holder) => ({ holder, key: "bufferView" }));
}

const imageNames = (json: JsonObject, name: string): Place[] =>
  listOf(json, "images", name).map((holder) => ({ holder, key: "bufferView" }));

const objectsIn = (value: JsonValue | undefined): JsonObject[] => (Array.isArray(value) ? value.filter(isObject) : []);

/** Takes items out of a list, and gives those that name others of it their new numbers. */
function renumber(
  json: JsonObject,
  key: string,
  gone: ReadonlySet<number>,
  places: readonly Place[],
  name: string,
): void {
  const kept: JsonObject[] = [];
  const numbers = listOf(json, key, name).map((item, index) => (gone.has(index) ? -1 : kept.push(item) - 1));
  json[key] = kept;
  for (const { holder, key: member } of places) {
    const index = indexAt(holder, member);
    if (index !== undefined && numbers[index] !== undefined) holder[member] = numbers[index];
  }
}

/** Names of all extensions that the model says it uses, or has anywhere. */
function extensionsOf(json: JsonObject): string[] {
  const found = new Set<string>();
  const visit = (value: JsonValue | undefined): void => {
    if (Array.isArray(value)) value.forEach(visit);
    if (!isObject(value)) return;
    for (const [key, member] of Object.entries(value)) {
      if (key === "extensions" && isObject(member)) for (const extension of Object.keys(member)) found.add(extension);
      if (key !== "extras") visit(member);
    }
  };
  visit(json);
  const { extensionsUsed } = json;
  for (const used of Array.isArray(extensionsUsed) ? extensionsUsed : []) found.add(String(used));
  return [...found];
}

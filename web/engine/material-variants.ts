/** The variants of a model's materials (KHR_materials_variants), and a model that shows another one of them. */
import type { ModelSource } from "./engine-api.ts";
import { readContainer, writeGlb } from "./gltf-container.ts";
import { indexAt, isObject, type JsonObject, listOf, objectAt, textAt } from "./gltf-json.ts";
import { packGltf } from "./gltf-packer.ts";

export const VARIANTS = "KHR_materials_variants";
/** In a primitive's extension, `extras`: its material in the file as it came, which says nothing where it is the one that it has. */
const OWN = "texelcastMaterial";

export interface Variants {
  /** As the model calls them; "" where it gives no name. */
  readonly names: readonly string[];
  /** Place among them of the one that is shown; null: the file's own look is, which is none of them. */
  readonly shown: number | null;
  /** Whether the file's own look is none of them. */
  readonly hasOwnLook: boolean;
}

export interface VariantModel {
  /** Self-contained; compressed geometry stays compressed. */
  readonly glb: Uint8Array<ArrayBuffer>;
  /** Which materials are where one was, by glTF material index; those that stay are not in it. */
  readonly moved: ReadonlyMap<number, readonly number[]>;
  /** Whether each of `moved` has become one other, which was nowhere else: its faces have the numbers that they had. */
  readonly isRenaming: boolean;
}

/** What variants a model has; null: none. Throws "bad-container". */
export function variantsOf({ name, bytes }: Pick<ModelSource, "name" | "bytes">): Variants | null {
  const { json } = readContainer({ name, bytes });
  const listed = objectAt(objectAt(json, "extensions"), VARIANTS)?.variants;
  if (!Array.isArray(listed) || listed.length === 0) return null;
  const names = listed.map((variant) => (isObject(variant) ? (textAt(variant, "name") ?? "") : ""));
  const primitives = primitivesOf(json, name);
  const shows = (variant: number | null): boolean =>
    primitives.every((primitive) => materialFor(primitive, variant) === indexAt(primitive, "material"));
  const looksOwn = (variant: number): boolean =>
    primitives.every((primitive) => materialFor(primitive, variant) === materialFor(primitive, null));
  const found = names.findIndex((_, variant) => shows(variant));
  return { names, shown: found < 0 ? null : found, hasOwnLook: !names.some((_, variant) => looksOwn(variant)) };
}

/**
 * The model with the materials of a variant, null: of the file as it came. The same bytes in the browser and in Node. Throws
 * "missing-file" and "bad-container".
 */
export function withVariant(source: ModelSource, variant: number | null): VariantModel {
  const { name } = source;
  const container = readContainer(source);
  const { json, binary } = packGltf(container);
  const implied = listOf(json, "materials", name).length;
  const after = new Map<number, Set<number>>();
  for (const primitive of primitivesOf(json, name)) {
    const before = indexAt(primitive, "material");
    const material = materialFor(primitive, variant);
    const now = after.get(before ?? implied) ?? new Set();
    after.set(before ?? implied, now.add(material ?? implied));
    if (material === before) continue;
    keepOwn(primitive, before);
    if (material === undefined) delete primitive.material;
    else primitive.material = material;
  }
  const moved = [...after].filter(([before, now]) => now.size !== 1 || !now.has(before));
  const places = [...after.values()].flatMap((now) => [...now]);
  return {
    glb: writeGlb(json, binary, container.extraChunks),
    moved: new Map(moved.map(([before, now]) => [before, [...now].sort((a, b) => a - b)])),
    isRenaming: moved.every(([, now]) => now.size === 1) && new Set(places).size === places.length,
  };
}

/** Of all meshes, in their order; the JSON's own. */
export function primitivesOf(json: JsonObject, name: string): JsonObject[] {
  return listOf(json, "meshes", name).flatMap(({ primitives }) =>
    Array.isArray(primitives) ? primitives.filter((primitive) => isObject(primitive)) : [],
  );
}

/** What a variant does not name has the file's own material; undefined: the one that glTF implies. */
export function materialFor(primitive: JsonObject, variant: number | null): number | undefined {
  const extension = objectAt(objectAt(primitive, "extensions"), VARIANTS);
  const { mappings } = extension ?? {};
  const mapping = Array.isArray(mappings)
    ? mappings
        .filter((each) => isObject(each))
        .find(({ variants }) => Array.isArray(variants) && variants.includes(variant))
    : undefined;
  const mapped = indexAt(mapping, "material");
  if (mapped !== undefined) return mapped;
  const extras = objectAt(extension, "extras");
  return extras !== undefined && OWN in extras ? indexAt(extras, OWN) : indexAt(primitive, "material");
}

/** Written once: null is the implied material. */
function keepOwn(primitive: JsonObject, material: number | undefined): void {
  const extension = objectAt(objectAt(primitive, "extensions"), VARIANTS);
  const extras = objectAt(extension, "extras");
  if (extension === undefined || (extras !== undefined && OWN in extras)) return;
  extension.extras = { ...extras, [OWN]: material ?? null };
}

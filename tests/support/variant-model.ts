/** Models whose materials have variants (KHR_materials_variants). */
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import type { buildModel } from "./model-builder.ts";

/** The primitives of all meshes, in their order; the JSON's own. */
export const primitivesOf = (json: JsonObject): JsonObject[] =>
  (json.meshes as JsonObject[]).flatMap(({ primitives }) => primitives as JsonObject[]);

/** The model as a GLB, with variants of those names. `mappings`: of each primitive, in its order; undefined: it has none. */
export function glbWithVariants(
  { json, binary }: ReturnType<typeof buildModel>,
  names: readonly string[],
  mappings: readonly (readonly JsonObject[] | undefined)[],
): Uint8Array<ArrayBuffer> {
  for (const [i, own] of mappings.entries()) {
    if (own)
      Object.assign(primitivesOf(json)[i] ?? {}, { extensions: { KHR_materials_variants: { mappings: [...own] } } });
  }
  json.extensions = { KHR_materials_variants: { variants: names.map((name) => ({ name })) } };
  json.extensionsUsed = ["KHR_materials_variants"];
  return writeGlb(json, binary);
}

/**
 * Parts that a material's first texture would not lie on, as they have no texture coordinates: glTF forbids such a texture there, and
 * viewers show its corner all over them. The core paints none of them (spec.md, 1).
 */
import { isObject, type JsonObject, objectAt } from "./gltf-json.ts";
import { allPrimitives } from "./gltf-primitives.ts";

/** What names a material: primitives, and what variants make of them. */
export type BareParts = readonly JsonObject[];

/** Of the parts that material `index` is on, those without coordinates of the set `texCoord`; none where no other part has them. */
export function bareParts(json: JsonObject, index: number, texCoord: number, name: string): BareParts {
  const primitives = allPrimitives(json, name);
  const parts = primitives.flatMap((primitive) => {
    const isBare = objectAt(primitive, "attributes")?.[`TEXCOORD_${texCoord}`] === undefined;
    const names = [primitive, ...mappingsOf(primitive)].filter(({ material }) => material === index);
    return names.map((part) => ({ part, isBare }));
  });
  return parts.every(({ isBare }) => isBare) ? [] : parts.filter(({ isBare }) => isBare).map(({ part }) => part);
}

function mappingsOf(primitive: JsonObject): JsonObject[] {
  const variants = objectAt(objectAt(primitive, "extensions"), "KHR_materials_variants");
  return Array.isArray(variants?.mappings) ? variants.mappings.filter(isObject) : [];
}

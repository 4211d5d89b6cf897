import { type JsonObject, listOf } from "./gltf-json.ts";

/** Of all meshes of a model, in their order; the JSON's own. Throws "bad-container" where a list is none. */
export const allPrimitives = (json: JsonObject, name: string): JsonObject[] =>
  listOf(json, "meshes", name).flatMap((mesh) => listOf(mesh, "primitives", name));

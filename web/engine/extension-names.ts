/** The lists of extensions that a model has at its top. */
import type { JsonObject } from "./gltf-json.ts";

/** Readers refuse a file that requires an extension they lack, so one that nothing needs any more must not be named. */
export function forgetExtension(json: JsonObject, extension: string): void {
  for (const key of ["extensionsUsed", "extensionsRequired"]) {
    const list = json[key];
    if (!Array.isArray(list) || !list.includes(extension)) continue;
    const rest = list.filter((item) => item !== extension);
    // A list that is there may not be empty.
    if (rest.length > 0) json[key] = rest;
    else delete json[key];
  }
}

/**
 * Materials whose colour stands in KHR_materials_pbrSpecularGlossiness, as tools wrote it before glTF had extensions of metal and
 * roughness: their diffuse picture and colour are what is painted on, as of any other material.
 */
import { forgetExtension } from "./extension-names.ts";
import { type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { SPECULAR_GLOSSINESS } from "./model-extensions.ts";

/** The model without the extension; `json` is changed. Textures keep their indices. */
export function withoutSpecularGlossiness(json: JsonObject, name: string): void {
  for (const material of listOf(json, "materials", name)) {
    const extensions = objectAt(material, "extensions");
    if (extensions?.[SPECULAR_GLOSSINESS] === undefined) continue;
    takeDiffuse(material);
    delete extensions[SPECULAR_GLOSSINESS];
    if (Object.keys(extensions).length === 0) delete material.extensions;
  }
  forgetExtension(json, SPECULAR_GLOSSINESS);
}

/** Gives a material its diffuse colour as its base colour, where it has none for viewers without the extension. */
export function takeDiffuse(material: JsonObject): void {
  const shine = objectAt(objectAt(material, "extensions"), SPECULAR_GLOSSINESS);
  const { baseColorTexture, baseColorFactor } = objectAt(material, "pbrMetallicRoughness") ?? {};
  if (shine === undefined || baseColorTexture !== undefined || baseColorFactor !== undefined) return;
  const { diffuseTexture, diffuseFactor, glossinessFactor, specularGlossinessTexture } = shine;
  const glossiness = typeof glossinessFactor === "number" ? glossinessFactor : 1;
  // How glossy a picture is on the whole is not known without looking into it.
  const share = specularGlossinessTexture === undefined ? 1 : 0.5;
  material.pbrMetallicRoughness = {
    ...(diffuseTexture !== undefined && { baseColorTexture: structuredClone(diffuseTexture) }),
    ...(diffuseFactor !== undefined && { baseColorFactor: structuredClone(diffuseFactor) }),
    metallicFactor: 0,
    roughnessFactor: 1 - glossiness * share,
  };
}

/** The diffuse colour after the base colour: what viewers with the extension show is what others do. */
export function giveDiffuse(material: JsonObject): void {
  const shine = objectAt(objectAt(material, "extensions"), SPECULAR_GLOSSINESS);
  if (shine === undefined) return;
  const { baseColorTexture, baseColorFactor } = objectAt(material, "pbrMetallicRoughness") ?? {};
  if (baseColorTexture !== undefined) shine.diffuseTexture = structuredClone(baseColorTexture);
  if (baseColorFactor !== undefined) shine.diffuseFactor = structuredClone(baseColorFactor);
}

/**
 * Puts finished textures into the user's own file. Only the picture and what points to it change: geometry, compression,
 * animations, extras and extensions unknown here stay as they were.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { type BareParts, bareParts } from "./bare-parts.ts";
import { forgetExtension } from "./extension-names.ts";
import { BinaryEditor } from "./gltf-binary-editor.ts";
import { type GltfContainer, writeGlb } from "./gltf-container.ts";
import {
  badContainer,
  indexAt,
  isObject,
  type JsonObject,
  type JsonValue,
  listForWriting,
  listOf,
  objectAt,
} from "./gltf-json.ts";
import { packGltf } from "./gltf-packer.ts";
import { SPECULAR_GLOSSINESS } from "./model-extensions.ts";
import { TEXTURE_SOURCE_EXTENSIONS } from "./model-textures.ts";
import { giveDiffuse, takeDiffuse } from "./specular-glossiness.ts";

export interface TextureEdit {
  /** glTF material index; one past the last is the implied default material. */
  readonly material: number;
  /** The encoded picture. */
  readonly png: Uint8Array;
  /** UV set that a material without a texture gets. */
  readonly texCoord: number;
  /** The picture already holds the material's base colour factor, which must then not be multiplied in again. */
  readonly factorBaked: boolean;
  /** Whether the picture repeats to its sides, and above and below, whatever its sampler says; without it, as that says. */
  readonly repeats?: readonly [s: boolean, t: boolean];
}

/** A sampler's, which is also what it does where it says nothing. */
const REPEAT = 10497;

/** A self-contained GLB of the model with the textures inside. Throws "bad-argument" for a material it does not have. */
export function writeModel(original: GltfContainer, edits: readonly TextureEdit[]): Uint8Array<ArrayBuffer> {
  const { json, binary } = packGltf(original);
  const editor = new BinaryEditor(json, binary, original.name);
  const kept: { readonly material: JsonObject; readonly parts: BareParts }[] = [];
  for (const edit of edits) {
    const material = materialOf(json, edit.material, original.name);
    const asItWas = structuredClone(material);
    takeDiffuse(material);
    // One picture that stands in both places would count as two uses of it.
    delete objectAt(objectAt(material, "extensions"), SPECULAR_GLOSSINESS)?.diffuseTexture;
    if (objectAt(material, "pbrMetallicRoughness")?.baseColorTexture === undefined) {
      const parts = bareParts(json, edit.material, edit.texCoord, original.name);
      if (parts.length > 0) kept.push({ material: asItWas, parts });
    }
    putTexture(json, editor, material, edit, original.name);
    repeatTexture(json, material, edit.repeats, original.name);
    giveDiffuse(material);
  }
  // Behind all that the edits name.
  for (const { material, parts } of kept) {
    const index = listForWriting(json, "materials", original.name).push(material) - 1;
    for (const part of parts) part.material = index;
  }
  dropUnusedTextureExtensions(json, original.name);
  return writeGlb(json, editor.finish(), original.extraChunks);
}

function putTexture(
  json: JsonObject,
  editor: BinaryEditor,
  material: JsonObject,
  edit: TextureEdit,
  name: string,
): void {
  const pbr = memberOf(material, "pbrMetallicRoughness");
  if (edit.factorBaked) pbr.baseColorFactor = [1, 1, 1, 1];
  const info = objectAt(pbr, "baseColorTexture");
  const textures = listForWriting(json, "textures", name);
  const index = indexAt(info, "index");
  const texture = index === undefined ? undefined : textures[index];

  if (info === undefined || texture === undefined) {
    const image = editor.addImage(edit.png);
    pbr.baseColorTexture = { index: textures.length, ...(edit.texCoord !== 0 && { texCoord: edit.texCoord }) };
    textures.push({ source: image });
    return;
  }
  // The texture info stays whatever the case: it holds the UV set and KHR_texture_transform.
  if (countTextureUses(json, index ?? -1) > 1) {
    const { source: _, extensions, ...kept } = texture;
    const others = withoutSources(extensions);
    info.index = textures.length;
    textures.push({ ...kept, ...(others !== undefined && { extensions: others }), source: editor.addImage(edit.png) });
    return;
  }
  const image = soleImage(json, texture, name);
  if (image === undefined) texture.source = editor.addImage(edit.png);
  else {
    editor.replaceImage(image, edit.png);
    texture.source = image;
  }
  const others = withoutSources(texture.extensions);
  if (others === undefined) delete texture.extensions;
  else texture.extensions = others;
}

/** Gives the material's texture, which is its own by now, a sampler of its own where the one that it has does otherwise. */
function repeatTexture(
  json: JsonObject,
  material: JsonObject,
  [s, t]: NonNullable<TextureEdit["repeats"]> = [false, false],
  name: string,
): void {
  const info = objectAt(objectAt(material, "pbrMetallicRoughness"), "baseColorTexture");
  const texture = listOf(json, "textures", name)[indexAt(info, "index") ?? -1];
  const samplers = listOf(json, "samplers", name);
  const sampler = samplers[indexAt(texture, "sampler") ?? -1];
  if (texture === undefined || sampler === undefined) return;
  const repeating = { ...sampler, ...(s && { wrapS: REPEAT }), ...(t && { wrapT: REPEAT }) };
  const isSame = (key: "wrapS" | "wrapT"): boolean => (sampler[key] ?? REPEAT) === (repeating[key] ?? REPEAT);
  if (!isSame("wrapS") || !isSame("wrapT")) texture.sampler = samplers.push(repeating) - 1;
}

/** The material to write to; makes the implied default material real and gives it to the primitives without one. */
function materialOf(json: JsonObject, index: number, name: string): JsonObject {
  const materials = listForWriting(json, "materials", name);
  const found = materials[index];
  if (found !== undefined) return found;
  if (index !== materials.length) {
    throw new TexelcastError("bad-argument", `“${name}” has no material ${index}.`, {
      subject: name,
      field: "material",
      value: String(index),
    });
  }
  const material: JsonObject = {};
  materials.push(material);
  for (const [i, mesh] of listOf(json, "meshes", name).entries()) {
    const primitives = mesh.primitives;
    if (!Array.isArray(primitives)) throw badContainer(name, `“meshes[${i}]” has no primitives`, `meshes[${i}]`);
    for (const primitive of primitives) {
      if (isObject(primitive) && primitive.material === undefined) primitive.material = index;
    }
  }
  return material;
}

function memberOf(parent: JsonObject, key: string): JsonObject {
  const found = objectAt(parent, key);
  if (found !== undefined) return found;
  const made: JsonObject = {};
  parent[key] = made;
  return made;
}

/**
 * How often texture `index` is referred to, in any material slot and any extension: wherever a member that is called
 * "…Texture" has that index. Extensions unknown here follow that naming too.
 */
function countTextureUses(json: JsonObject, index: number): number {
  let uses = 0;
  const visit = (value: JsonValue | undefined): void => {
    if (Array.isArray(value)) value.forEach(visit);
    if (!isObject(value)) return;
    for (const [key, member] of Object.entries(value)) {
      if (/texture$/i.test(key) && isObject(member) && member.index === index) uses++;
      visit(member);
    }
  };
  visit(json.materials);
  visit(json.extensions);
  return uses;
}

/** The texture's picture if nothing else uses it and it may be replaced where it is. */
function soleImage(json: JsonObject, texture: JsonObject, name: string): number | undefined {
  const own = sourcesOf(texture);
  const all = listOf(json, "textures", name).flatMap(sourcesOf);
  return own.find((image) => all.filter((other) => other === image).length === 1 && image < imageCount(json, name));
}

function imageCount(json: JsonObject, name: string): number {
  return listOf(json, "images", name).length;
}

/** Images that a texture names, by itself or by an extension. */
function sourcesOf(texture: JsonObject): number[] {
  const holders = [texture, ...Object.values(objectAt(texture, "extensions") ?? {}).filter(isObject)];
  return holders.map((holder) => indexAt(holder, "source")).filter((source) => source !== undefined);
}

/** A texture's extensions without those that name a picture in another format; undefined when none are left. */
function withoutSources(extensions: JsonValue | undefined): JsonObject | undefined {
  if (!isObject(extensions)) return undefined;
  const kept = Object.entries(extensions).filter(([key]) => !TEXTURE_SOURCE_EXTENSIONS.some((known) => known === key));
  return kept.length === 0 ? undefined : Object.fromEntries(kept);
}

function dropUnusedTextureExtensions(json: JsonObject, name: string): void {
  const textures = listOf(json, "textures", name);
  for (const extension of TEXTURE_SOURCE_EXTENSIONS) {
    if (textures.some((texture) => objectAt(texture, "extensions")?.[extension] !== undefined)) continue;
    forgetExtension(json, extension);
  }
}

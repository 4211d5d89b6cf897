/** A glTF material as a UsdPreviewSurface (openusd.org, "UsdPreviewSurface Specification"), as far as that goes. */
import { indexAt, type JsonObject, type JsonValue, listOf, objectAt, textAt } from "../gltf-json.ts";
import { imageOfTexture } from "../model-textures.ts";
import { placeOfTexture, type TexturePlace } from "../texture-place.ts";
import { block, numberText, tupleText } from "./usd-text.ts";

export interface UsdMaterial {
  readonly lines: readonly string[];
  /** Texture coordinates that it asks for, by the name of their primvar. */
  readonly uvs: ReadonlyMap<string, TexturePlace>;
  readonly isDoubleSided: boolean;
}

/** Where in the package a picture of the model lies; undefined for one that is not there. */
export type PathOfImage = (image: number) => string | undefined;

const WRAPS: Readonly<Record<number, string>> = { 33071: "clamp", 33648: "mirror" };
/** What is seen through clear glass is bent and tinted, of which the surface knows nothing: so much of it stays to be seen. */
const LEAST_OPACITY = 0.1;
const ONES = [1, 1, 1, 1];

/** @param material index; one past the last is the implied default material. `path`: of the material's prim. */
export function usdMaterial(
  json: JsonObject,
  material: number,
  path: string,
  pathOfImage: PathOfImage,
  name: string,
): UsdMaterial {
  const gltf = listOf(json, "materials", name)[material] ?? {};
  const network = new Network(json, path, pathOfImage, name);
  const extension = (key: string): JsonObject | undefined => objectAt(objectAt(gltf, "extensions"), key);
  const pbr = objectAt(gltf, "pbrMetallicRoughness");
  const base = network.texture("base", objectAt(pbr, "baseColorTexture"), "sRGB", factors(pbr?.baseColorFactor, 4));
  const color = base.value("rgb");
  if (extension("KHR_materials_unlit") !== undefined) {
    network.input("color3f", "diffuseColor", "(0, 0, 0)");
    network.input("color3f", "emissiveColor", color);
    network.input("float", "roughness", "1");
  } else {
    network.input("color3f", "diffuseColor", color);
    const [roughness, metallic] = [numberOf(pbr?.roughnessFactor, 1), numberOf(pbr?.metallicFactor, 1)];
    const info = objectAt(pbr, "metallicRoughnessTexture");
    const surface = network.texture("surface", info, "raw", [1, roughness, metallic, 1]);
    network.input("float", "roughness", surface.value("g"));
    network.input("float", "metallic", surface.value("b"));
    network.input("color3f", "emissiveColor", emission(network, gltf, extension("KHR_materials_emissive_strength")));
    addDetails(network, gltf);
    addCoat(network, extension("KHR_materials_clearcoat"));
    const ior = extension("KHR_materials_ior")?.ior;
    if (typeof ior === "number") network.input("float", "ior", numberText(ior));
  }
  const alpha = base.value("a");
  const mode = textAt(gltf, "alphaMode");
  const clear = numberOf(extension("KHR_materials_transmission")?.transmissionFactor, 0);
  if (mode === "MASK") {
    network.input("float", "opacity", alpha);
    network.input("float", "opacityThreshold", numberText(numberOf(gltf.alphaCutoff, 0.5)));
  } else if (mode === "BLEND") network.input("float", "opacity", alpha);
  else if (clear > 0) network.input("float", "opacity", numberText(Math.max(1 - clear, LEAST_OPACITY)));
  return { lines: network.lines(), uvs: network.uvs, isDoubleSided: gltf.doubleSided === true };
}

function emission(network: Network, gltf: JsonObject, extension: JsonObject | undefined): string {
  const strength = numberOf(extension?.emissiveStrength, 1);
  const factor = factors(gltf.emissiveFactor, 3, 0).map((part) => part * strength);
  const texture = network.texture("emission", objectAt(gltf, "emissiveTexture"), "sRGB", [...factor, 1]);
  return texture.value("rgb");
}

/** Bumps and shade. */
function addDetails(network: Network, gltf: JsonObject): void {
  const normal = objectAt(gltf, "normalTexture");
  const scale = numberOf(normal?.scale, 1);
  const bumps = network.texture("normal", normal, "raw", [2 * scale, 2 * scale, 2, 1], [-scale, -scale, -1, 0]);
  if (bumps.isThere) network.input("normal3f", "normal", bumps.value("rgb"));
  const occlusion = objectAt(gltf, "occlusionTexture");
  const strength = numberOf(occlusion?.strength, 1);
  const scales = [strength, strength, strength, 1];
  const shade = network.texture("occlusion", occlusion, "raw", scales, [1 - strength, 1 - strength, 1 - strength, 0]);
  if (shade.isThere) network.input("float", "occlusion", shade.value("r"));
}

function addCoat(network: Network, coat: JsonObject | undefined): void {
  if (coat === undefined) return;
  const part = (name: string, key: string, channel: "r" | "g"): string => {
    const factor = numberOf(coat[`${key}Factor`], 0);
    const texture = network.texture(name, objectAt(coat, `${key}Texture`), "raw", [factor, factor, factor, 1]);
    return texture.value(channel);
  };
  network.input("float", "clearcoat", part("coat", "clearcoat", "r"));
  network.input("float", "clearcoatRoughness", part("coatRoughness", "clearcoatRoughness", "g"));
}

/** What an input of the surface is: a texture's channel, or the constant that stands where there is none. */
interface Source {
  readonly isThere: boolean;
  value(channel: "rgb" | "r" | "g" | "b" | "a"): string;
}

/** Shaders and what connects them. */
class Network {
  readonly uvs = new Map<string, TexturePlace>();
  readonly #json: JsonObject;
  readonly #path: string;
  readonly #pathOfImage: PathOfImage;
  readonly #name: string;
  readonly #inputs: string[] = [];
  readonly #shaders: string[] = [];
  /** Primvars by what lies in them. */
  readonly #primvars = new Map<string, string>();

  constructor(json: JsonObject, path: string, pathOfImage: PathOfImage, name: string) {
    this.#json = json;
    this.#path = path;
    this.#pathOfImage = pathOfImage;
    this.#name = name;
  }

  /** @param value a constant, or "<…>", where it comes from */
  input(type: string, key: string, value: string): void {
    this.#inputs.push(`${type} inputs:${key}${value.startsWith("<") ? ".connect" : ""} = ${value}`);
  }

  /** The texture that `info` names in the material, times `scale` and with `bias` added; without it, `scale` itself. */
  texture(
    shader: string,
    info: JsonObject | undefined,
    space: "sRGB" | "raw",
    scale: readonly number[],
    bias: readonly number[] = [0, 0, 0, 0],
  ): Source {
    const texture = listOf(this.#json, "textures", this.#name)[indexAt(info, "index") ?? -1];
    const file = this.#pathOfImage((texture && imageOfTexture(texture)) ?? -1);
    if (info === undefined || texture === undefined || file === undefined) return constant(scale);
    const sampler = listOf(this.#json, "samplers", this.#name)[indexAt(texture, "sampler") ?? -1];
    const wrap = (key: string): string => `token inputs:${key} = "${WRAPS[indexAt(sampler, key) ?? 0] ?? "repeat"}"`;
    const lines = [
      'uniform token info:id = "UsdUVTexture"',
      `asset inputs:file = @${file}@`,
      `float2 inputs:st.connect = <${this.#path}/${this.#reader(info)}.outputs:result>`,
      `token inputs:sourceColorSpace = "${space}"`,
      wrap("wrapS"),
      wrap("wrapT"),
      `float4 inputs:scale = ${tupleText(scale)}`,
      `float4 inputs:bias = ${tupleText(bias)}`,
      `float4 inputs:fallback = ${tupleText(ONES)}`,
      "float3 outputs:rgb",
      ...["r", "g", "b", "a"].map((channel) => `float outputs:${channel}`),
    ];
    this.#shaders.push(...block(`def Shader "${shader}"`, lines));
    return { isThere: true, value: (channel) => `<${this.#path}/${shader}.outputs:${channel}>` };
  }

  /** The shader that reads a texture's coordinates. */
  #reader(info: JsonObject): string {
    const place = placeOfTexture(info);
    // Where two corners of the picture come to lie tells one place from another.
    const key = JSON.stringify([place.texCoord, place.apply(0, 0), place.apply(1, 0), place.apply(0, 1)]);
    const known = this.#primvars.get(key);
    if (known !== undefined) return `${known}Reader`;
    const primvar = `st${this.#primvars.size || ""}`;
    this.#primvars.set(key, primvar);
    this.uvs.set(primvar, place);
    const lines = [
      'uniform token info:id = "UsdPrimvarReader_float2"',
      `string inputs:varname = "${primvar}"`,
      "float2 outputs:result",
    ];
    this.#shaders.push(...block(`def Shader "${primvar}Reader"`, lines));
    return `${primvar}Reader`;
  }

  lines(): string[] {
    const surface = ['uniform token info:id = "UsdPreviewSurface"', ...this.#inputs, "token outputs:surface"];
    return block(`def Material "${this.#path.slice(this.#path.lastIndexOf("/") + 1)}"`, [
      `token outputs:surface.connect = <${this.#path}/Surface.outputs:surface>`,
      ...block('def Shader "Surface"', surface),
      ...this.#shaders,
    ]);
  }
}

const CHANNELS = ["r", "g", "b", "a"];

function constant(values: readonly number[]): Source {
  return {
    isThere: false,
    value: (channel) =>
      channel === "rgb" ? tupleText(values.slice(0, 3)) : numberText(values[CHANNELS.indexOf(channel)] as number),
  };
}

function factors(list: JsonValue | undefined, count: number, otherwise = 1): number[] {
  return Array.from({ length: count }, (_, i) => numberOf(Array.isArray(list) ? list[i] : undefined, otherwise));
}

const numberOf = (value: JsonValue | undefined, otherwise: number): number =>
  typeof value === "number" ? value : otherwise;

/** The colour of a material that has no picture, as pixels. */
import { type JsonObject, listOf, objectAt } from "../gltf-json.ts";

/** RGBA of a material's base colour factor as the core has it (wasm/session.cpp): sRGB, white where it has none. */
export function plainColor(json: JsonObject, material: number, name: string): readonly number[] {
  const factor = objectAt(listOf(json, "materials", name)[material], "pbrMetallicRoughness")?.baseColorFactor;
  const channelAt = (index: number): number => {
    const channel = Array.isArray(factor) ? factor[index] : undefined;
    return typeof channel === "number" ? channel : 1;
  };
  const alpha = Math.min(1, Math.max(0, channelAt(3)));
  return [...[0, 1, 2].map((index) => srgbByte(channelAt(index))), Math.floor(alpha * 255 + 0.5)];
}

/**
 * Linear light, 0 to 1, as an sRGB byte. Found by its borders, where both sides of the curve's root are whole powers: by
 * + - * / alone, so that it is the same everywhere (spec.md, 7).
 */
function srgbByte(linear: number): number {
  let byte = 0;
  while (byte < 255 && isBrighter(linear, (byte + 0.5) / 255)) byte++;
  return byte;
}

/** linear ** (1 / 2.4) * 1.055 - 0.055 >= encoded, above the curve's straight part. */
function isBrighter(linear: number, encoded: number): boolean {
  if (encoded <= 0.04045) return linear * 12.92 >= encoded;
  const root = (encoded + 0.055) / 1.055;
  const cube = root * root * root;
  return linear * linear * linear * linear * linear >= cube * cube * cube * cube;
}

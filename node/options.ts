/** Values of options: from the words of the command line to what they mean, or commander's own error. */
import path from "node:path";
import { InvalidArgumentError } from "commander";
import { MAX_SIZE, MAX_TEXTURE_SIZE } from "../web/core/sizes.ts";
import { isHexColor, parseHexColor } from "../web/editor/document/hex-color.ts";

const MAX_GUTTER = 64;
/** Charts of a smaller texture would be all gutter. */
const LEAST_SIDE = 64;
const MAX_DPI = 10_000;

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** A colour, or the path of a picture. */
export type BaseOption = readonly [number, number, number, number] | { readonly file: string };

function wholeNumber(text: string, min: number, max: number): number {
  const value = /^\d{1,9}$/.test(text) ? Number(text) : Number.NaN;
  if (!(value >= min && value <= max)) {
    throw new InvalidArgumentError(`It must be a whole number from ${min} to ${max}.`);
  }
  return value;
}

/** Texels: one number, or two as in "2048x1024". */
export const parseSize = (text: string): Size => sizeWithin(text, MAX_SIZE);
/** Of a texture that is only printed. */
export const parsePrintSize = (text: string): Size => sizeWithin(text, MAX_TEXTURE_SIZE);

function sizeWithin(text: string, max: number): Size {
  const [width = "", height = width, ...rest] = text.toLowerCase().split("x");
  if (rest.length > 0) throw new InvalidArgumentError('It must be one number, or two as in "2048x1024".');
  return { width: wholeNumber(width, 1, max), height: wholeNumber(height, 1, max) };
}

/** A glTF material index. */
export const parseMaterial = (text: string): number => wholeNumber(text, 0, 65_535);
/** Texels. */
export const parseGutter = (text: string): number => wholeNumber(text, 0, MAX_GUTTER);

/** Side of a square texture, texels. */
export const parseSide = (text: string): number => wholeNumber(text, LEAST_SIDE, MAX_SIZE);

/** Pixels an inch of print. */
export const parseDpi = (text: string): number => wholeNumber(text, 1, MAX_DPI);

/** A path that ends in .png. */
export function parsePrintOutput(text: string): string {
  if (/\.png$/i.test(text)) return text;
  throw new InvalidArgumentError("It must end in .png.");
}

/** A path that ends in .glb. */
export function parseGlbOutput(text: string): string {
  if (/\.glb$/i.test(text)) return text;
  throw new InvalidArgumentError("It must end in .glb.");
}

/** "white", a hex colour (channels from 0 to 1), or else the path of a picture. */
export function parseBase(text: string): BaseOption {
  if (text === "white") return [1, 1, 1, 1];
  if (isHexColor(text)) return parseHexColor(text);
  if (text.startsWith("#")) throw new InvalidArgumentError('A colour must be "#rrggbb" or "#rrggbbaa".');
  return { file: parsePath(text) };
}

/** Stands in the name of a picture for the index of the material that it shows. */
export const MATERIAL_IN_NAME = "{material}";

/** "pngs" is one picture for each material, told apart by their names. */
export interface RenderOutput {
  readonly file: string;
  readonly kind: "png" | "pngs" | "glb" | "usdz";
}

/** What is written is told by the path: by its ending, and by `{material}` in the file's name. */
export function parseRenderOutput(text: string): RenderOutput {
  const kind = /\.(png|glb|usdz)$/i.exec(text)?.[1]?.toLowerCase();
  if (kind !== "png" && kind !== "glb" && kind !== "usdz") {
    throw new InvalidArgumentError("It must end in .png (the texture), or .glb or .usdz (the model with it inside).");
  }
  const each = path.basename(text).includes(MATERIAL_IN_NAME);
  if (each && kind !== "png") {
    throw new InvalidArgumentError(`A .${kind} holds all materials, so its name has no {material}.`);
  }
  return { file: text, kind: each ? "pngs" : kind };
}

/** The picture's path for one material. */
export function fileOfMaterial(file: string, material: number): string {
  const name = path.basename(file);
  // Not by `path.join`, to which a link to a folder and a way up behind it are none.
  return file.slice(0, file.length - name.length) + name.replaceAll(MATERIAL_IN_NAME, String(material));
}

/** A path that is not empty, and no option that stands where a path was forgotten. */
export function parsePath(text: string): string {
  if (text === "") throw new InvalidArgumentError("It must not be empty.");
  if (!text.startsWith("-")) return text;
  throw new InvalidArgumentError(`It begins as an option does: write "./${text}" where it is a name.`);
}

/** What a target's layers lie on: the material's own picture or colour, or what the caller gives instead. */
import { Filters } from "../core/abi.ts";
import type { Target } from "../core/target.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { checkFile } from "./check-file.ts";
import type { EngineColor, Picture, TargetOptions } from "./engine-api.ts";
import { REPAIR } from "./gltf-json.ts";
import type { LoadedModel } from "./model-loader.ts";
import { baseTextureSize } from "./model-loader.ts";
import { findBaseTexture, imageBytes } from "./model-textures.ts";
import { decodePicture, readPictureHeader } from "./picture-decoder.ts";

/** Side of a target whose material has no picture and for which no size is asked, texels. */
const DEFAULT_SIZE = 1024;

export interface BasePicture {
  /** Null: the target keeps the core's own base (the material's colour factor, or white). */
  readonly picture: Picture | null;
  /** sRGB, 0 to 255; null unless the caller gave a colour. */
  readonly color: readonly [number, number, number, number] | null;
  readonly filter: number;
  /** The base colour factor is part of the base: true for a material without a picture of its own. */
  readonly factorBaked: boolean;
}

/** The target's size: as asked, else that of the base picture (by its header), else of the material's own, else 1024. */
export async function targetSize(model: LoadedModel, options: TargetOptions): Promise<readonly [number, number]> {
  const { width, height, base } = options;
  if (width !== undefined || height !== undefined) return [width ?? height ?? 0, height ?? width ?? 0];
  if (isFile(base)) {
    const header = await readPictureHeader(base.bytes, base.name);
    return [header.width, header.height];
  }
  return (await baseTextureSize(model, options.material)) ?? [DEFAULT_SIZE, DEFAULT_SIZE];
}

/** Decodes what the target shall lie on. Throws "bad-picture", "unsupported" and "bad-argument", naming the file. */
export async function loadBasePicture(model: LoadedModel, options: TargetOptions): Promise<BasePicture> {
  const { base = "model" } = options;
  if (base === "model") return await loadModelBase(model, options.material);
  if (isFile(base)) {
    const picture = await decodePicture(base.bytes, base.name);
    return { picture, color: null, filter: Filters.linear, factorBaked: false };
  }
  if (!isColor(base)) {
    const value = String(base);
    throw new TexelcastError("bad-argument", `A base colour has four numbers from 0 to 1, not ${value}.`, {
      field: "base",
      value,
    });
  }
  const color = base.map((channel) => Math.round(channel * 255)) as [number, number, number, number];
  return { picture: null, color, filter: Filters.linear, factorBaked: false };
}

type Base = NonNullable<TargetOptions["base"]>;

function isFile(base: Base | undefined): base is Extract<Base, { readonly bytes: Uint8Array }> {
  if (!("bytes" in Object(base))) return false;
  checkFile(base as Extract<Base, { readonly bytes: Uint8Array }>);
  return true;
}

/** Callers without types may give anything. */
const isColor = (base: unknown): base is EngineColor =>
  Array.isArray(base) &&
  base.length === 4 &&
  base.every((channel: unknown) => typeof channel === "number" && channel >= 0 && channel <= 1);

async function loadModelBase(model: LoadedModel, material: number): Promise<BasePicture> {
  const { json, binary } = model.packed;
  const texture = findBaseTexture(json, material, model.name);
  if (texture === null) return { picture: null, color: null, filter: Filters.linear, factorBaked: true };
  if (texture.image === null) {
    throw new TexelcastError(
      "unsupported",
      `The texture of material ${material} of “${model.name}” is ${texture.undecodable}, which cannot be decoded here.`,
      {
        subject: model.name,
        field: `textures[${texture.texture}].extensions.${texture.undecodable}`,
        hint: "Export the model with PNG, JPEG, WebP or AVIF textures, or choose another base for painting.",
      },
    );
  }
  const image = imageBytes(json, binary, texture.image, model.name);
  if (image === null) {
    throw new TexelcastError(
      "bad-picture",
      `The texture of material ${material} of “${model.name}” has no picture data.`,
      {
        subject: model.name,
        field: `images[${texture.image}]`,
        hint: REPAIR,
      },
    );
  }
  const picture = await decodePicture(image.bytes, image.name).catch(async (error: unknown) => {
    throw (await import("./model-fault.ts")).pictureFault(
      error,
      model.original.json,
      texture.image as number,
      model.name,
    );
  });
  return { picture, color: null, filter: texture.nearest ? Filters.nearest : Filters.linear, factorBaked: false };
}

/** Gives the core's target a picture or a colour to lie on; the core keeps copies. */
export function applyBase(target: Target, base: BasePicture): void {
  if (base.picture !== null) target.setBase(base.picture.width, base.picture.height, base.picture.rgba, base.filter);
  if (base.color !== null) target.setBaseColor(...base.color);
}

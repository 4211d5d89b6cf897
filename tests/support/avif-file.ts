/** AVIF files: encoded as tests need them, and their containers made box by box, so that each part of one can be tested. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { default as encode, init as startEncoder } from "@jsquash/avif/encode.js";
import type { Picture } from "../../web/engine/engine-api.ts";
import { buildGlb, type ModelParts, plane } from "./model-builder.ts";

const require = createRequire(import.meta.url);

let started: Promise<unknown> | null = null;

async function startedEncoder(): Promise<typeof encode> {
  const path = require.resolve("@jsquash/avif/codec/enc/avif_enc.wasm");
  started ??= WebAssembly.compile(readFileSync(path)).then((module) => startEncoder(module));
  await started;
  return encode;
}

/** Colours and alpha as they are, or with the losses of a quality from 0 to 100. */
export async function avifFile({ width, height, rgba }: Picture, quality?: number): Promise<Uint8Array> {
  const image = { width, height, data: new Uint8ClampedArray(rgba) } as ImageData;
  return new Uint8Array(
    await (await startedEncoder())(image, quality === undefined ? { lossless: true } : { quality }),
  );
}

/** Channels of 10 or 12 bits, as they are. */
export async function deepAvifFile(
  { width, height, channels }: { readonly width: number; readonly height: number; readonly channels: Uint16Array },
  bitDepth: 10 | 12,
): Promise<Uint8Array> {
  const image = { width, height, data: channels, colorSpace: "srgb" } as const;
  return new Uint8Array(await (await startedEncoder())(image, { lossless: true, bitDepth }));
}

/** A square whose one material has the picture as AVIF alone. */
export function avifModel(avif: Uint8Array, parts: Partial<ModelParts> = {}): Uint8Array {
  return buildGlb({
    meshes: [plane(1, 0)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ extensions: { EXT_texture_avif: { source: 0 } } }],
    images: [{ bytes: avif, mimeType: "image/avif", name: "paint" }],
    more: { extensionsUsed: ["EXT_texture_avif"], extensionsRequired: ["EXT_texture_avif"] },
    ...parts,
  });
}

/** An item of a container. Its number is its place in the list, from 1. */
export interface AvifPart {
  /** "av01", "grid", "Exif", … */
  readonly type: string;
  readonly data: Uint8Array;
  /** Whole boxes, of `ispe` and the like. */
  readonly properties?: readonly Uint8Array[];
  /** What it says of others, by their numbers. */
  readonly references?: Readonly<Record<string, readonly number[]>>;
}

export interface AvifParts {
  readonly brand?: string;
  readonly brands?: readonly string[];
  /** The picture's number, from 1. */
  readonly primary?: number;
  readonly parts: readonly AvifPart[];
  /** Boxes behind `meta`. */
  readonly more?: readonly Uint8Array[];
  /** Boxes in it, beside those that it must have. */
  readonly inMeta?: readonly Uint8Array[];
  /** What its `iloc` box holds behind its flags, in place of what is so. */
  readonly places?: Uint8Array;
}

/** What the encoder made of a picture: the colours, and the alpha where it has some. */
export function partsOf(file: Uint8Array): AvifPart[] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const at = (type: string, from = 0): number => Buffer.from(file).indexOf(type, from, "latin1");
  const box = (start: number): Uint8Array => file.slice(start - 4, start - 4 + view.getUint32(start - 4));
  const iloc = at("iloc");
  const data = (place: number): Uint8Array => {
    const offset = view.getUint32(place + 6);
    return file.slice(offset, offset + view.getUint32(place + 10));
  };
  const size = box(at("ispe"));
  const colours = [size, box(at("pixi")), box(at("av1C")), box(at("colr"))];
  const parts: AvifPart[] = [{ type: "av01", data: data(iloc + 12), properties: colours }];
  if (at("auxC") < 0) return parts;
  const alpha = [size, box(at("pixi", at("pixi") + 4)), box(at("av1C", at("av1C") + 4)), box(at("auxC"))];
  return [...parts, { type: "av01", data: data(iloc + 26), properties: alpha, references: { auxl: [1] } }];
}

export function makeAvif(file: AvifParts): Uint8Array {
  const { brand = "avif", brands, primary = 1, parts, more = [], inMeta = [] } = file;
  const properties = parts.flatMap((part) => part.properties ?? []);
  const unique = [...new Map(properties.map((each) => [Buffer.from(each).toString("hex"), each])).entries()];
  const numberOf = (each: Uint8Array): number =>
    1 + unique.findIndex(([key]) => key === Buffer.from(each).toString("hex"));
  const links = parts.flatMap(({ references = {} }, index) =>
    Object.entries(references).map(([type, to]) => box(type, u16(index + 1), u16(to.length), ...to.map(u16))),
  );
  const associations = parts.map(({ properties: own = [] }, index) =>
    joined(u16(index + 1), [own.length], ...own.map((each) => [0x80 | numberOf(each)])),
  );
  const ftyp = box("ftyp", text(brand), [0, 0, 0, 0], ...(brands ?? [brand, "mif1", "miaf"]).map(text));
  const meta = (first: number): Uint8Array => {
    let offset = first;
    const own = parts.map(({ data }, index) => {
      const place = joined(u16(index + 1), u16(0), u16(1), u32(offset), u32(data.length));
      offset += data.length;
      return place;
    });
    return fullBox(
      "meta",
      0,
      fullBox("hdlr", 0, u32(0), text("pict"), u32(0), u32(0), u32(0), [0]),
      fullBox("pitm", 0, u16(primary)),
      fullBox("iloc", 0, file.places ?? joined([0x44, 0], u16(parts.length), ...own)),
      fullBox("iinf", 0, u16(parts.length), ...parts.map(({ type }, index) => entry(index + 1, type))),
      ...(links.length > 0 ? [fullBox("iref", 0, ...links)] : []),
      box(
        "iprp",
        box("ipco", ...unique.map(([, each]) => each)),
        fullBox("ipma", 0, u32(parts.length), ...associations),
      ),
      ...inMeta,
    );
  };
  const before = joined(...more);
  const start = ftyp.length + meta(0).length + before.length + 8;
  return joined(ftyp, meta(start), before, box("mdat", ...parts.map(({ data }) => data)));
}

const entry = (id: number, type: string): Uint8Array =>
  fullBox("infe", 2, u16(id), u16(0), text(type), [0], type === "mime" ? text("application/rdf+xml\0") : []);

type Bytes = Uint8Array | readonly number[];

export const box = (type: string, ...content: readonly Bytes[]): Uint8Array => {
  const inside = joined(...content);
  return joined(u32(inside.length + 8), text(type), inside);
};

/** With its version; no flags. */
export const fullBox = (type: string, version: number, ...content: readonly Bytes[]): Uint8Array =>
  box(type, [version, 0, 0, 0], ...content);

/** How large a picture is said to be. */
export const sizeBox = (width: number, height: number): Uint8Array => fullBox("ispe", 0, u32(width), u32(height));

/** Quarter turns against the clock. */
export const turnBox = (turns: number): Uint8Array => box("irot", [turns]);

/** 0: top and bottom change places; 1: left and right. */
export const mirrorBox = (axis: number): Uint8Array => box("imir", [axis]);

/** A rectangle cut out of a picture, in whole pixels. */
export function cropBox(
  [width, height]: readonly [number, number],
  { x, y, w, h }: { readonly x: number; readonly y: number; readonly w: number; readonly h: number },
): Uint8Array {
  // From the picture's middle to the rectangle's, in halves of a pixel.
  const [across, down] = [2 * x + w - width, 2 * y + h - height];
  return box("clap", ...[w, 1, h, 1, across, 2, down, 2].map(u32));
}

/** The item that says how tiles make a picture. */
export const gridData = (rows: number, columns: number, width: number, height: number): Uint8Array =>
  joined([0, 0, rows - 1, columns - 1], u16(width), u16(height));

export const u16 = (value: number): Uint8Array => Uint8Array.of(value >> 8, value);
export const u32 = (value: number): Uint8Array => joined(u16(value >>> 16), u16(value));
export const text = (value: string): Uint8Array => new Uint8Array(Buffer.from(value, "latin1"));
export const joined = (...parts: readonly Bytes[]): Uint8Array =>
  new Uint8Array(Buffer.concat(parts.map((each) => Uint8Array.from(each))));

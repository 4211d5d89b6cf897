/**
 * AVIF: what decoding it will take, before anything is decoded, and how its pixels become the picture: the decoder gives them as they
 * are coded, and the file says what is cut off of them, and how they are turned and mirrored (HEIF, 6.5.9 to 6.5.12).
 *
 * What EXIF says of the camera is not looked at, as HEIF asks: who wrote the file has said it as a turn.
 */
import { MAX_SIZE } from "../core/sizes.ts";
import { av1Frames } from "./av1-frames.ts";
import { type AvifFile, type AvifItem, damaged, otherKind, readAvifFile } from "./avif-file.ts";
import { isNumbers, writeAvif } from "./avif-writer.ts";
import { type Box, BoxReader } from "./isobmff.ts";
import { orientPixels } from "./orient-pixels.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";
import { checkPixels } from "./picture-header.ts";

/** Of all frames, alpha's too. A picture has one, and a layered one some: far from what a short file could ask for. */
const MOST_PIXELS = 4 * MAX_SIZE * MAX_SIZE;
/** What a frame takes beside its pixels, as pixels. */
const FRAME = 256 * 256;

/** EXIF's number for so many quarter turns against the clock, by how the picture is mirrored thereafter. */
const ORIENTATIONS = {
  none: [1, 8, 3, 6],
  topToBottom: [4, 5, 2, 7],
  leftToRight: [2, 7, 4, 5],
} as const;

/** What is done to the decoded picture. */
const LAST: readonly string[] = ["clap", "irot", "imir"];

interface AvifHeader extends RawHeader {
  readonly file: AvifFile;
  readonly coded: Size;
  readonly crop: Rectangle;
  /** As EXIF says it. */
  readonly turn: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

interface Rectangle extends Size {
  readonly x: number;
  readonly y: number;
}

/**
 * Its size is that of the picture, cut and turned, and its orientation upright. Throws a PictureFault where the picture cannot be
 * used, a RangeError where the file ends too early.
 */
export function readAvifHeader(bytes: Uint8Array): RawHeader {
  const { width, height, orientation } = readWhole(bytes);
  return { width, height, orientation };
}

/**
 * The file with what the picture needs alone. Throws as `readAvifHeader`.
 *
 * @param profile The box of its colour profile; null where its colours are sRGB's, or told by numbers.
 */
export function cleanAvif(bytes: Uint8Array, profile: Uint8Array | null): Uint8Array<ArrayBuffer> {
  const { items, references } = readWhole(bytes).file;
  const [picture, ...others] = items;
  if (picture === undefined) throw damaged();
  const had = picture.properties.some(isProfile);
  const properties = had && profile === null ? picture.properties.map(asSrgb) : picture.properties;
  return writeAvif({ items: [{ ...picture, properties }, ...others], references }, profile);
}

const isProfile = ({ type, content }: Box): boolean => type === "colr" && !isNumbers(content);

/** A profile goes before the numbers: they hold from now on, and must not say of sRGB what it did not. */
function asSrgb(property: Box): Box {
  const { type, content, whole } = property;
  if (type !== "colr" || !isNumbers(content)) return property;
  const changed = whole.slice();
  changed.set([0, 1, 0, 13], whole.length - content.length + 4);
  return { type, content: changed.subarray(whole.length - content.length), whole: changed };
}

/** Decodes by `decode`, which gives the pixels as they are coded. Throws as `readAvifHeader`. */
export async function decodeAvif(
  bytes: Uint8Array,
  decode: (bytes: Uint8Array) => Promise<ImageData>,
): Promise<Pick<ImageData, "data">> {
  const { file, coded, crop, turn } = readWhole(bytes);
  const { data, width, height } = await decode(writeAvif(asCoded(file)));
  if (width !== coded.width || height !== coded.height) throw damaged();
  // A picture without alpha is opaque, unless its colours could not be made RGB.
  if (!file.items.some(hasAlpha) && data[3] !== 255) throw damaged();
  const pixels = new Uint8Array(data.buffer, data.byteOffset, data.byteLength) as Uint8Array<ArrayBuffer>;
  const { rgba } = orientPixels(cut(pixels, width, crop), crop.width, crop.height, turn);
  return { data: new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.byteLength) };
}

/** It would refuse some pictures that are cut, which it does not do by itself. */
const asCoded = ({ items, references }: AvifFile): AvifFile => ({
  items: items.map((item) => ({ ...item, properties: item.properties.filter(({ type }) => !LAST.includes(type)) })),
  references,
});

const hasAlpha = ({ properties }: AvifItem): boolean => properties.some(({ type }) => type === "auxC");

function readWhole(bytes: Uint8Array): AvifHeader {
  const file = readAvifFile(bytes);
  try {
    return describe(file);
  } catch (error) {
    throw error instanceof RangeError ? damaged() : error;
  }
}

function describe(file: AvifFile): AvifHeader {
  for (const item of file.items) {
    checkSize(item);
    checkColours(item);
  }
  checkFrames(file.items);
  const [picture] = file.items;
  const coded = picture && sizeOf(picture);
  if (coded === undefined) throw damaged();
  const crop = cropOf(picture, coded);
  const turn = turnOf(picture);
  const [width, height] = turn >= 5 ? [crop.height, crop.width] : [crop.width, crop.height];
  return { file, coded, crop, turn, width, height, orientation: 1 };
}

const property = ({ properties }: AvifItem, name: string): BoxReader | undefined => {
  const found = properties.find(({ type }) => type === name);
  return found && new BoxReader(found.content);
};

function sizeOf(item: AvifItem): Size {
  const reader = property(item, "ispe");
  if (reader === undefined) throw new PictureFault("damaged", "its size is missing");
  reader.uint(4);
  return { width: reader.uint(4), height: reader.uint(4) };
}

function checkSize(item: AvifItem): void {
  const size = sizeOf(item);
  checkPixels(size);
  if (item.type === "av01") return;
  const grid = new BoxReader(item.data);
  grid.uint(1);
  const bytes = grid.uint(1) & 1 ? 4 : 2;
  grid.uint(2);
  if (grid.uint(bytes) !== size.width || grid.uint(bytes) !== size.height) throw damaged();
}

/** Of ITU-T H.273, those that the decoder turns into RGB. Of others it says nothing, and gives what its memory held. */
const MATRICES: readonly number[] = [0, 1, 2, 4, 5, 6, 7, 8, 9, 12];

function checkColours({ properties }: AvifItem): void {
  for (const { type, content } of properties) {
    const reader = new BoxReader(content);
    if (type !== "colr" || reader.type() !== "nclx") continue;
    reader.uint(4);
    const matrix = reader.uint(2);
    if (!MATRICES.includes(matrix)) throw otherKind(`its colours are of system ${matrix}`);
  }
}

function checkFrames(items: readonly AvifItem[]): void {
  let [frames, pixels] = [0, 0];
  for (const { type, data } of items) {
    if (type !== "av01") continue;
    const found = av1Frames(data);
    checkPixels(found);
    frames += found.frames;
    // A frame without a size of its own is as large as one before it.
    pixels = Math.max(pixels, FRAME, found.width * found.height);
  }
  if (frames * pixels <= MOST_PIXELS) return;
  throw new PictureFault("frames", `it has ${frames} frames, where a picture has one`);
}

/** The rectangle, from the picture's middle and in fractions, in whole pixels. */
function cropOf(item: AvifItem, { width, height }: Size): Rectangle {
  const reader = property(item, "clap");
  if (reader === undefined) return { x: 0, y: 0, width, height };
  const fraction = (): number => reader.int32() / reader.int32();
  const [across, down, x, y] = [fraction(), fraction(), fraction(), fraction()];
  const crop = { x: (width - across) / 2 + x, y: (height - down) / 2 + y, width: across, height: down };
  const isInside = crop.x >= 0 && crop.y >= 0 && crop.x + across <= width && crop.y + down <= height;
  if (!isInside || across < 1 || down < 1 || !Object.values(crop).every(Number.isInteger)) throw damaged();
  return crop;
}

function turnOf(item: AvifItem): number {
  const turns = (property(item, "irot")?.uint(1) ?? 0) & 3;
  const axis = property(item, "imir")?.uint(1);
  const mirrored = axis === undefined ? "none" : axis & 1 ? "leftToRight" : "topToBottom";
  return ORIENTATIONS[mirrored][turns] ?? 1;
}

function cut(
  rgba: Uint8Array<ArrayBuffer>,
  stride: number,
  { x, y, width, height }: Rectangle,
): Uint8Array<ArrayBuffer> {
  if (rgba.length === width * height * 4) return rgba;
  const rows = new Uint8Array(width * height * 4);
  for (let row = 0; row < height; row++) {
    const from = ((y + row) * stride + x) * 4;
    rows.set(rgba.subarray(from, from + width * 4), row * width * 4);
  }
  return rows;
}

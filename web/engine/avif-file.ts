/**
 * An AVIF file (AV1 Image File Format 1.1, on HEIF, ISO/IEC 23008-12, and MIAF, ISO/IEC 23000-22) as the items that its picture is
 * made of. All else of the file is not looked at: films, thumbnails, depth, EXIF, XMP.
 */
import { type Box, BoxReader, boxesIn, versioned } from "./isobmff.ts";
import { joinBytes } from "./join-bytes.ts";
import { PictureFault } from "./picture-fault.ts";

export interface AvifItem {
  readonly id: number;
  readonly type: "av01" | "grid";
  /** One that has its tiles' bytes in the same place as another has the same array. */
  readonly data: Uint8Array;
  /** Of those that the picture needs. */
  readonly properties: readonly Box[];
}

export interface AvifReference {
  /** "dimg": of what tiles it is made; "auxl": whose alpha it is; "prem": by what alpha its colours are multiplied. */
  readonly type: string;
  readonly from: number;
  readonly to: readonly number[];
}

export interface AvifFile {
  /** The picture itself first. */
  readonly items: readonly AvifItem[];
  /** Of the items to one another. */
  readonly references: readonly AvifReference[];
}

/** More than 8192 pixels along a side take in tiles of 256, with as many of alpha. */
const MOST_PARTS = 4096;
const NEEDED: readonly string[] = [
  "ispe",
  "pixi",
  "av1C",
  "colr",
  "auxC",
  "clap",
  "irot",
  "imir",
  "a1op",
  "a1lx",
  "lsel",
];
const ALPHA = /^urn:mpeg:(mpegB:cicp:systems:auxiliary:alpha|hevc:2015:auxid:1)\0/;

/** Throws a PictureFault where the picture cannot be used, a RangeError where the file ends too early. */
export function readAvifFile(bytes: Uint8Array): AvifFile {
  const meta = findMeta(bytes);
  try {
    return pictureOf(readMeta(meta), bytes);
  } catch (error) {
    if (error instanceof RangeError) throw damaged();
    throw error;
  }
}

export const damaged = (): PictureFault => new PictureFault("damaged", "its AVIF data is damaged");

export const otherKind = (what: string): PictureFault =>
  new PictureFault("avif-kind", `it is an AVIF picture of another kind than can be read: ${what}`);

/** What follows a whole `meta` box may be cut short: whether the picture's own bytes are there is seen by their places. */
function findMeta(bytes: Uint8Array): Uint8Array {
  for (const { type, content } of boxesIn(bytes)) {
    if (type === "ftyp") checkBrands(content);
    if (type === "meta") return content;
  }
  throw new PictureFault("no-pixels", "it holds no pixels");
}

function checkBrands(content: Uint8Array): void {
  const brands = (String.fromCharCode(...content.subarray(0, 4096)).match(/.{4}/gs) ?? []).filter((_, i) => i !== 1);
  if (brands[0] === "avis") {
    throw new PictureFault("animated", "it is animated", "Save one frame of it as a still picture.");
  }
  if (brands.includes("avif")) return;
  const isHeic = brands.some((brand) => /^(hei[cmsx]|hev[cmsx]|mif1|msf1)$/.test(brand));
  throw isHeic ? new PictureFault("heic", "it is a HEIC picture") : new PictureFault("film", "it is a film");
}

interface Meta {
  readonly primary: number;
  readonly types: ReadonlyMap<number, string>;
  readonly places: ReadonlyMap<number, Place>;
  readonly references: readonly AvifReference[];
  readonly properties: ReadonlyMap<number, readonly Property[]>;
  /** Where items lie that do not lie in the file itself. */
  readonly inside: Uint8Array;
}

/** The pieces of an item, one behind the other. */
interface Place {
  readonly isInside: boolean;
  readonly pieces: readonly { readonly offset: number; readonly length: number }[];
}

interface Property extends Box {
  /** The item must not be read by who does not know the property. */
  readonly isEssential: boolean;
}

const NONE = new Uint8Array();

function readMeta(meta: Uint8Array): Meta {
  const { reader } = versioned(meta);
  const boxes = onceEach(reader.take(reader.left));
  const content = (type: string): Uint8Array => {
    const found = boxes.get(type);
    if (found === undefined) throw damaged();
    return found;
  };
  const { version, reader: primary } = versioned(content("pitm"));
  return {
    primary: primary.uint(version === 0 ? 2 : 4),
    types: readTypes(content("iinf")),
    places: readPlaces(content("iloc")),
    references: boxes.has("iref") ? readReferences(content("iref")) : [],
    properties: readProperties(content("iprp")),
    inside: boxes.get("idat") ?? NONE,
  };
}

const ONCE: ReadonlySet<string> = new Set(["pitm", "iinf", "iloc", "iref", "iprp", "idat", "ipco"]);

function onceEach(bytes: Uint8Array): Map<string, Uint8Array> {
  const found = new Map<string, Uint8Array>();
  for (const { type, content } of boxesIn(bytes)) {
    if (!ONCE.has(type)) continue;
    if (found.has(type)) throw damaged();
    found.set(type, content);
  }
  return found;
}

/** Numbers of what takes time or room, which need not take bytes of the file. */
function bounded(count: number): number {
  if (count > MOST_PARTS) throw otherKind(`it is in more than ${MOST_PARTS} parts`);
  return count;
}

function readTypes(iinf: Uint8Array): Map<number, string> {
  const { version, reader } = versioned(iinf);
  bounded(reader.uint(version === 0 ? 2 : 4));
  const types = new Map<number, string>();
  for (const { type, content } of boxesIn(reader.take(reader.left))) {
    const { version: form, reader: entry } = versioned(content);
    // Older entries say no type.
    if (type !== "infe" || form < 2) continue;
    const id = entry.uint(form === 2 ? 2 : 4);
    entry.uint(2);
    types.set(id, entry.type());
  }
  return types;
}

function readPlaces(iloc: Uint8Array): Map<number, Place> {
  const { version, reader } = versioned(iloc);
  if (version > 2) throw damaged();
  const sizes = reader.uint(2);
  const [offsetSize, lengthSize, baseSize] = [sizes >> 12, (sizes >> 8) & 15, (sizes >> 4) & 15];
  const indexSize = version === 0 ? 0 : sizes & 15;
  const count = bounded(reader.uint(version < 2 ? 2 : 4));
  let all = 0;
  const places = new Map<number, Place>();
  for (let i = 0; i < count; i++) {
    const id = reader.uint(version < 2 ? 2 : 4);
    const method = version === 0 ? 0 : reader.uint(2) & 15;
    // In another file, or in another item.
    const isElsewhere = reader.uint(2) !== 0 || method > 1;
    const base = reader.uint(baseSize);
    const length = reader.uint(2);
    all = bounded(all + length);
    const pieces = Array.from({ length }, () => {
      reader.uint(indexSize);
      return { offset: base + reader.uint(offsetSize), length: reader.uint(lengthSize) };
    });
    if (!isElsewhere) places.set(id, { isInside: method === 1, pieces });
  }
  return places;
}

function readReferences(iref: Uint8Array): AvifReference[] {
  const { version, reader } = versioned(iref);
  const size = version === 0 ? 2 : 4;
  const boxes = [...boxesIn(reader.take(reader.left))];
  bounded(boxes.length);
  return boxes.map(({ type, content }) => {
    const each = new BoxReader(content);
    const from = each.uint(size);
    return { type, from, to: Array.from({ length: each.uint(2) }, () => each.uint(size)) };
  });
}

function readProperties(iprp: Uint8Array): Map<number, Property[]> {
  const listed = [...boxesIn(onceEach(iprp).get("ipco") ?? NONE)];
  const properties = new Map<number, Property[]>();
  for (const { type, content } of boxesIn(iprp)) {
    if (type !== "ipma") continue;
    const { version, flags, reader } = versioned(content);
    const isLong = (flags & 1) !== 0;
    const count = bounded(reader.uint(4));
    for (let i = 0; i < count; i++) {
      const id = reader.uint(version === 0 ? 2 : 4);
      if (properties.has(id)) throw damaged();
      const own = Array.from({ length: reader.uint(1) }, () => {
        const link = reader.uint(isLong ? 2 : 1);
        const essential = isLong ? 0x8000 : 0x80;
        const property = listed[(link & (essential - 1)) - 1];
        return property && { ...property, isEssential: (link & essential) !== 0 };
      });
      properties.set(
        id,
        own.filter((property) => property !== undefined),
      );
    }
  }
  return properties;
}

function pictureOf(meta: Meta, bytes: Uint8Array): AvifFile {
  const tilesOf = (id: number): readonly number[] =>
    meta.types.get(id) === "grid"
      ? meta.references.filter(({ type, from }) => type === "dimg" && from === id).flatMap(({ to }) => to)
      : [];
  const colours = new Set([meta.primary, ...tilesOf(meta.primary)]);
  const alphas = new Set(
    meta.references
      .filter(({ type, from, to }) => type === "auxl" && isAlpha(meta, from) && to.some((id) => colours.has(id)))
      .map(({ from }) => from),
  );
  const ids = new Set([...colours, ...alphas, ...[...alphas].flatMap(tilesOf)]);
  bounded(ids.size);
  const data = new Pieces(bytes, meta.inside);
  const items = [...ids].map((id): AvifItem => {
    const type = meta.types.get(id);
    if (type !== "av01" && (type !== "grid" || !(id === meta.primary || alphas.has(id)))) {
      throw otherKind(type === undefined ? "a part of it is missing" : `it is made of “${type}”`);
    }
    const said = meta.properties.get(id) ?? [];
    const strange = said.find((property) => property.isEssential && !NEEDED.includes(property.type));
    if (strange) throw otherKind(`it needs “${strange.type}”`);
    const properties = said.filter((property) => NEEDED.includes(property.type));
    return { id, type, data: data.of(meta.places.get(id)), properties };
  });
  const references = meta.references
    .filter(({ type, from }) => ["dimg", "auxl", "prem"].includes(type) && ids.has(from))
    .map(({ type, from, to }) => ({ type, from, to: to.filter((id) => ids.has(id)) }));
  return { items, references };
}

const isAlpha = ({ properties }: Meta, id: number): boolean =>
  (properties.get(id) ?? []).some(
    ({ type, content }) => type === "auxC" && ALPHA.test(String.fromCharCode(...content.subarray(4, 64))),
  );

/** The bytes of items. Those of more than one piece are joined, all together no more than the file has. */
class Pieces {
  readonly #bytes: Uint8Array;
  readonly #inside: Uint8Array;
  readonly #known = new Map<string, Uint8Array>();
  #joined = 0;

  constructor(bytes: Uint8Array, inside: Uint8Array) {
    this.#bytes = bytes;
    this.#inside = inside;
  }

  of(place: Place | undefined): Uint8Array {
    if (place === undefined) throw new PictureFault("no-pixels", "it holds no pixels");
    const { isInside, pieces } = place;
    const key = `${isInside} ${pieces.map(({ offset, length }) => `${offset}+${length}`)}`;
    const known = this.#known.get(key);
    if (known !== undefined) return known;
    const from = isInside ? this.#inside : this.#bytes;
    const parts = pieces.map(({ offset, length }) => {
      if (offset + length > from.length) {
        throw new PictureFault("cut-short", "it was cut short", "Copy or download it again.");
      }
      return from.subarray(offset, offset + length);
    });
    const [first = NONE] = parts;
    if (parts.length > 1) this.#joined += parts.reduce((sum, { length }) => sum + length, 0);
    if (this.#joined > this.#bytes.length) throw damaged();
    const whole = parts.length > 1 ? joinBytes(parts) : first;
    this.#known.set(key, whole);
    return whole;
  }
}

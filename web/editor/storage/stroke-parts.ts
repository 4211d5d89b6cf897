/**
 * Strokes that follow each other in a paint layer, kept once under the name of what they hold: a save then writes the newest
 * strokes, and not again all that were painted before. A long session's text is tens of megabytes, and each step is saved.
 */
import { nextTurn } from "../../engine/event-loop.ts";
import type { Design, StrokeLayer } from "../document/index.ts";
import { flattenLayers } from "../document/layer-tree.ts";
import { forgetText, layerText, serialiseDesign } from "../document/serialise-design.ts";
import { contentHash } from "./content-hash.ts";

/** Characters of JSON: what a save writes of strokes beside the parts, at most, for each paint layer. */
const PART_LENGTH = 1 << 18;
/** Before a part's name in a design's text. JSON text never holds this character. */
const MARK = "\0";

export interface StrokePart {
  readonly hash: string;
  readonly strokes: readonly StrokeLayer[];
  /** Bytes. */
  readonly size: number;
}

/** By their first strokes. */
const PARTS = new WeakMap<StrokeLayer, StrokePart>();
/** The parts that a design was packed or read with. */
const PARTS_OF = new WeakMap<Design, ReadonlySet<string>>();

/** Of the part, as it is kept: strokes of a JSON list. */
export const partBytes = ({ strokes }: StrokePart): Uint8Array =>
  new TextEncoder().encode(strokes.map((stroke) => layerText(stroke, "")).join(","));

/** The part that stands at a place of the list. */
function partAt(strokes: readonly StrokeLayer[], at: number): StrokePart | undefined {
  const part = PARTS.get(strokes[at] as StrokeLayer);
  return part?.strokes.every((stroke, index) => stroke === strokes[at + index]) ? part : undefined;
}

/** Makes parts of all that is long enough and in none yet. */
export async function gatherParts(design: Design): Promise<void> {
  for (const layer of flattenLayers(design, { masks: false, strokes: false })) {
    if (layer.type !== "paint") continue;
    let open: StrokeLayer[] = [];
    let length = 0;
    for (let at = 0; at < layer.strokes.length; ) {
      const stroke = layer.strokes[at] as StrokeLayer;
      const part = partAt(layer.strokes, at);
      at += part?.strokes.length ?? 1;
      if (part === undefined) {
        open.push(stroke);
        length += layerText(stroke, "").length;
      }
      if (length >= PART_LENGTH) {
        await makePart(open);
        // The hash may come at once, and thousands of strokes together, as those of a copied layer, take a phone seconds.
        await nextTurn();
      }
      if (part !== undefined || length >= PART_LENGTH) {
        open = [];
        length = 0;
      }
    }
  }
}

async function makePart(strokes: readonly StrokeLayer[]): Promise<void> {
  const part = { hash: "", strokes, size: 0 };
  const bytes = partBytes(part);
  PARTS.set(strokes[0] as StrokeLayer, { ...part, hash: await contentHash(bytes), size: bytes.length });
  strokes.forEach(forgetText);
}

/** The design's text with parts by their names, as far as `allowed` has them; `used` is told of these. */
export function printParts(design: Design, used: (part: StrokePart) => void, allowed?: ReadonlySet<string>): string {
  return serialiseDesign(design, (strokes) => {
    const texts: (() => string)[] = [];
    for (let at = 0; at < strokes.length; ) {
      const stroke = strokes[at] as StrokeLayer;
      const part = partAt(strokes, at);
      if (part === undefined || allowed?.has(part.hash) === false) {
        texts.push(() => layerText(stroke, ""));
        at += 1;
        continue;
      }
      texts.push(() => MARK + part.hash);
      used(part);
      at += part.strokes.length;
    }
    return texts;
  });
}

export const partsOf = (design: Design): ReadonlySet<string> => PARTS_OF.get(design) ?? new Set();
export const noteParts = (design: Design, hashes: ReadonlySet<string>): void => void PARTS_OF.set(design, hashes);

interface PlacedPart {
  readonly hash: string;
  readonly at: number;
  readonly count: number;
  readonly size: number;
}

/** Plain data of a text with parts, and where these stand in each paint layer, bottom to top. */
export function joinParts(
  text: string,
  bytesOf: (hash: string) => Uint8Array,
): { readonly data: unknown; readonly places: readonly (readonly PlacedPart[])[] } {
  const places: PlacedPart[][] = [];
  const decoder = new TextDecoder();
  const named = text.replace(/\0(\w+)/g, '"$1"');
  const data: unknown = JSON.parse(named, (key, value: unknown) => {
    if (key !== "strokes" || !Array.isArray(value)) return value;
    const found: PlacedPart[] = [];
    const strokes: unknown[] = [];
    for (const item of value) {
      const bytes = typeof item === "string" ? bytesOf(item) : null;
      const held: unknown[] = bytes ? JSON.parse(`[${decoder.decode(bytes)}]`) : [item];
      if (bytes) found.push({ hash: item, at: strokes.length, count: held.length, size: bytes.length });
      for (const stroke of held) strokes.push(stroke);
    }
    places.push(found);
    return strokes;
  });
  return { data, places };
}

export const hasParts = (text: string): boolean => text.includes(MARK);

/** Knows the parts of a design again that was read with them. */
export function knowParts(design: Design, places: readonly (readonly PlacedPart[])[]): void {
  const paints = flattenLayers(design, { masks: false, strokes: false }).filter((layer) => layer.type === "paint");
  for (const [index, { strokes }] of paints.entries()) {
    for (const { hash, at, count, size } of places[index] ?? []) {
      PARTS.set(strokes[at] as StrokeLayer, { hash, strokes: strokes.slice(at, at + count), size });
    }
  }
  noteParts(design, new Set(places.flat().map(({ hash }) => hash)));
}

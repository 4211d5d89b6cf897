/**
 * Strokes that follow each other in a paint layer or a mask, kept once under the name of what they hold: a save then writes
 * the newest strokes, and not again all that were painted before. A long session's text is tens of megabytes, and each step
 * is saved.
 */
import { nextTurn } from "../../engine/event-loop.ts";
import type { Design, DesignLayer, StrokeLayer } from "../document/index.ts";
import { childLists } from "../document/layer-tree.ts";
import { forgetText, layerText, serialiseDesign } from "../document/serialise-design.ts";
import { contentHash } from "./content-hash.ts";

/** Characters of JSON: what a save writes of strokes beside the parts, at most, for each list of layers. */
const PART_LENGTH = 1 << 18;
/** Before a part's name in a design's text. JSON text never holds this character. */
const MARK = "\0";
const NAMED = /\0(\w+)/g;
/** The fields that hold layers. */
const LISTS: ReadonlySet<string> = new Set(["layers", "strokes"]);

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
function partAt(layers: readonly DesignLayer[], at: number): StrokePart | undefined {
  const part = PARTS.get(layers[at] as StrokeLayer);
  return part?.strokes.every((stroke, index) => stroke === layers[at + index]) ? part : undefined;
}

/** The list and all lists that its layers hold, masks among them. */
function* listsIn(layers: readonly DesignLayer[]): Generator<readonly DesignLayer[]> {
  yield layers;
  for (const layer of layers) for (const held of childLists(layer)) yield* listsIn(held.layers);
}

/** Makes parts of all that is long enough and in none yet. */
export async function gatherParts(design: Design): Promise<void> {
  for (const layers of listsIn(design.layers)) {
    let open: StrokeLayer[] = [];
    let length = 0;
    for (let at = 0; at < layers.length; ) {
      const layer = layers[at] as DesignLayer;
      const part = partAt(layers, at);
      at += part?.strokes.length ?? 1;
      const isOpen = part === undefined && layer.type === "stroke";
      if (isOpen) {
        open.push(layer);
        length += layerText(layer, "").length;
      }
      if (length >= PART_LENGTH) {
        await makePart(open);
        // The hash may come at once, and thousands of strokes together, as those of a copied layer, take a phone seconds.
        await nextTurn();
      }
      if (!isOpen || length >= PART_LENGTH) {
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
  return serialiseDesign(design, (layers, at) => {
    const part = partAt(layers, at);
    if (part === undefined || allowed?.has(part.hash) === false) return undefined;
    used(part);
    return { text: MARK + part.hash, count: part.strokes.length };
  });
}

export const partsOf = (design: Design): ReadonlySet<string> => PARTS_OF.get(design) ?? new Set();
export const noteParts = (design: Design, hashes: ReadonlySet<string>): void => void PARTS_OF.set(design, hashes);

interface ReadPart {
  readonly hash: string;
  readonly count: number;
  readonly size: number;
}
/** By the ids of their first strokes. */
type ReadParts = ReadonlyMap<string, ReadPart>;

/**
 * Plain data of a text with parts, and where these stand. Each part is read in a turn of its own: all that a long session
 * holds takes a phone a second.
 */
export async function joinParts(
  text: string,
  bytesOf: (hash: string) => Uint8Array,
): Promise<{ readonly data: unknown; readonly parts: ReadParts }> {
  const held = new Map<string, readonly StrokeLayer[]>();
  const parts = new Map<string, ReadPart>();
  const decoder = new TextDecoder();
  for (const [, hash = ""] of text.matchAll(NAMED)) {
    const bytes = bytesOf(hash);
    const strokes: readonly StrokeLayer[] = JSON.parse(`[${decoder.decode(bytes)}]`);
    held.set(hash, strokes);
    if (strokes[0]) parts.set(strokes[0].id, { hash, count: strokes.length, size: bytes.length });
    await nextTurn();
  }
  const join = (key: string, value: unknown): unknown =>
    LISTS.has(key) && Array.isArray(value)
      ? value.flatMap((item) => (typeof item === "string" ? (held.get(item) ?? item) : item))
      : value;
  return { data: JSON.parse(text.replace(NAMED, '"$1"'), join), parts };
}

export const hasParts = (text: string): boolean => text.includes(MARK);

/** Knows the parts of a design again that was read with them. */
export function knowParts(design: Design, parts: ReadParts): void {
  for (const layers of listsIn(design.layers)) {
    for (const [at, layer] of layers.entries()) {
      if (layer.type !== "stroke") continue;
      const part = parts.get(layer.id);
      if (part === undefined) continue;
      const strokes = layers.slice(at, at + part.count) as StrokeLayer[];
      PARTS.set(layer, { hash: part.hash, strokes, size: part.size });
    }
  }
  noteParts(design, new Set([...parts.values()].map(({ hash }) => hash)));
}

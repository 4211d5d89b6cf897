/** What an SVG may grow to before it is refused. */
import { badPicture } from "./picture-header.ts";
import { growthOf } from "./svg-growth.ts";
import { drawingIn } from "./svg-inside.ts";

/** Characters that entities may grow to; drawing programs name a few namespaces with them. */
const MAX_ENTITY_GROWTH = 2 ** 20;
/** Characters that it may grow to by what it reuses, and by its words. */
const MAX_LENGTH = 64 * 2 ** 20;
/** Elements, by all that asks for them. */
const MAX_VISITS = 1e7;
/** Of rules of style with elements, of letters, and the like: some five seconds each time that it is read. */
const MAX_COMPARISONS = 2e9;
const HINT = "Open it in a drawing program and save it again as plain SVG.";

/**
 * Throws "bad-picture" naming the file where it grows beyond all measure, by entities or what it reuses, or would take too
 * long to read; and where a drawing inside is packed. What is inside counts with the rest.
 */
export function checkGrowth(svg: string, name: string): void {
  const whole = growthOf(withEntities(svg, name));
  const inside = whole.inside.flatMap((address) => drawingIn(address, name) ?? []);
  let [length, visits, comparisons] = [0, 0, 0];
  for (const growth of [whole, ...inside.map((inner) => growthOf(withEntities(inner, name)))]) {
    length += growth.length;
    visits += growth.visits;
    comparisons += growth.comparisons;
  }
  if (length > MAX_LENGTH || visits > MAX_VISITS) {
    throw badPicture(
      name,
      "too-slow",
      "with all that it reuses, and its words, it grows beyond all measure",
      "Make it simpler.",
    );
  }
  if (comparisons > MAX_COMPARISONS) {
    throw badPicture(
      name,
      "too-slow",
      "it would take too long to read: too much in it is styled, reused or written on paths",
      HINT,
    );
  }
}

/** The document with what its entities stand for in their places. */
function withEntities(svg: string, name: string): string {
  const entities = new Map<string, string>();
  for (const [, entity = "", , value = ""] of svg.matchAll(/<!ENTITY\s+([^\s"'>]+)\s+(["'])(.*?)\2/gs)) {
    if (/&[^#]/.test(value))
      throw badPicture(name, "entities", `its entity “${entity}” is made of other entities`, HINT);
    if (!entities.has(entity)) entities.set(entity, value);
  }
  if (entities.size === 0) return svg;
  let growth = 0;
  return svg.replace(/&([^\s&;#]+);/g, (reference, entity: string) => {
    const value = entities.get(entity) ?? reference;
    growth += value.length;
    if (growth > MAX_ENTITY_GROWTH) throw badPicture(name, "entities", "its entities grow beyond all measure", HINT);
    return value;
  });
}

/**
 * What an SVG grows to once all that it reuses is copied, told before it is read: a few bytes can ask for more memory or time
 * than there is, and the renderer does not recover from the one.
 */
import { AskedParts, WHOLE } from "./asked-parts.ts";
import { SetWords } from "./svg-words.ts";
import { tagsOf, type XmlTag } from "./xml-tags.ts";

export interface SvgGrowth {
  /** Characters, with what is reused copied, and words as outlines. */
  readonly length: number;
  /** Elements, those of gradients, patterns and masks wherever they are asked for. */
  readonly visits: number;
  /** Of one thing with another, as the reader of SVG makes them: of rules of style with elements, of letters, and others. */
  readonly comparisons: number;
  /** Addresses with data that are none of a picture's, and may be drawings inside. */
  readonly inside: readonly string[];
}

interface OpenTag {
  readonly name: string;
  /** The element with an id that it is or is part of, as "#id". */
  readonly part: string;
  readonly isText: boolean;
  /** What it asks for or inherits; null outside of markers, where any style may ask for any. */
  readonly markers: Markers | null;
}

/** The ids of a path's markers by where they stand: "", "-start", "-mid" or "-end". */
type Markers = ReadonlyMap<string, string>;

/** Parts that stand for all markers that any path may have at its ends, and on all of its points. */
const ON_ENDS = "markers on ends";
const ON_POINTS = "markers on points";
const ADDRESS = /url\(\s*["']?#([^"')]*)/g;
const MARKER = /\bmarker(-\w+)?\s*[:=]\s*["']?\s*url\(\s*["']?#([^"')]*)/g;
/** Characters that the outline of one takes. */
const GLYPH = 600;
const PICTURE = /^data:image\/(?!svg)/i;
const PATHS: ReadonlySet<string> = new Set(["path", "line", "polyline", "polygon", "rect", "circle", "ellipse"]);
/** Characters of a path for each of its points, at the least. */
const POINT = 4;
/** Measured, of the time that an element takes to be passed by on the way to one that is reused. */
const RULE = 10;
const DECLARATION = 3;
const STOP = 0.25;
const OTHER = 0.1;

/** What the rules of style that end in a name ask for. */
interface Style {
  readonly asked: Set<string>;
  declarations: number;
}

/** @param svg its entities written out */
export function growthOf(svg: string): SvgGrowth {
  const text = spelledOut(svg);
  const dashes = longestDashes(text);
  const styles = stylesIn(text);
  const copied = new AskedParts();
  const visited = new AskedParts();
  const set = new AskedParts();
  const words = new SetWords();
  for (const [, where = "", id = ""] of text.matchAll(MARKER)) {
    copied.ask(isOnPoints(where) ? ON_POINTS : ON_ENDS, `#${id}`, 1);
  }
  const open: OpenTag[] = [];
  const stops = new Map<string, number>();
  const inside: string[] = [];
  let [rules, elements, reuses, squares] = [0, 0, 0, 0];
  for (const tag of tagsOf(text)) {
    const around = open.at(-1);
    squares += OTHER * tag.others ** 2;
    if (around?.name === "style") rules += tag.text.split(/[{,]/).length - 1;
    if (around?.isText) {
      copied.grow(around.part, tag.text.replace(/\s+/g, "").length * GLYPH);
      words.add(tag.text);
      set.grow(around.part, words.part(tag));
    }
    if (tag.kind === "end") {
      open.pop();
      continue;
    }
    elements += 1;
    const element = openTag(tag, around);
    const { part } = element;
    const outer = around?.part ?? WHOLE;
    const reused = tag.attributes.get("href");
    for (const [parts, size] of [
      [copied, tag.length],
      [visited, 1],
      [set, 0],
    ] as const) {
      parts.grow(part, size);
      if (part !== outer) parts.ask(outer, part, 1);
      if (reused?.startsWith("#")) parts.ask(part, reused, 1);
    }
    if (reused?.startsWith("#")) reuses += 1;
    else if (reused?.startsWith("data:") && !PICTURE.test(reused)) inside.push(reused);
    if (tag.name === "stop") stops.set(part, (stops.get(part) ?? 0) + 1);
    const { asked, declarations } = styleOf(tag, styles);
    for (const id of asked) {
      visited.ask(part, id, 1);
      set.ask(part, id, 1);
    }
    squares += DECLARATION * declarations ** 2;
    if (PATHS.has(tag.name)) {
      copied.grow(part, dashes);
      for (const [markers, count] of markersOf(element, tag)) copied.ask(part, markers, count);
    }
    if (tag.kind === "start") open.push(element);
  }
  for (const count of stops.values()) squares += STOP * count ** 2;
  const comparisons = (RULE * rules + reuses) * elements + squares + set.total();
  return { length: copied.total(), visits: visited.total(), comparisons, inside };
}

function openTag({ name, attributes }: XmlTag, around: OpenTag | undefined): OpenTag {
  const id = attributes.get("id");
  const inherited = name === "marker" ? new Map<string, string>() : (around?.markers ?? null);
  return {
    name,
    part: id === undefined ? (around?.part ?? WHOLE) : `#${id}`,
    isText: around?.isText === true || name === "text",
    markers: inherited && withMarkers(inherited, attributes),
  };
}

function withMarkers(inherited: Markers, attributes: ReadonlyMap<string, string>): Markers {
  const markers = new Map(inherited);
  for (const [name, value] of attributes) {
    const asked = name === "style" ? value : name.startsWith("marker") ? `${name}=${value}` : "";
    for (const [, where = "", id = ""] of asked.matchAll(MARKER)) markers.set(where, id);
  }
  return markers;
}

/** The markers of a path, and how often each is copied. */
function markersOf({ markers }: OpenTag, { attributes }: XmlTag): (readonly [part: string, count: number])[] {
  const points = Math.ceil((attributes.get("d") ?? attributes.get("points") ?? "").length / POINT) + 2;
  // Whoever asks for them, they are inherited: any path may have them.
  if (markers === null) {
    return [
      [ON_ENDS, 2],
      [ON_POINTS, points],
    ];
  }
  return [...markers].map(([where, id]) => [`#${id}`, isOnPoints(where) ? points : 2]);
}

const isOnPoints = (where: string): boolean => where === "" || where === "-mid";

/** By the last name of their selectors: ".class", "#id", an element's, or "*". */
function stylesIn(text: string): Map<string, Style> {
  const styles = new Map<string, Style>();
  if (!text.includes("style>") && !text.includes("style ")) return styles;
  let name = "";
  for (const tag of tagsOf(text)) {
    const rules = name === "style" ? tag.text.split("}") : [];
    name = tag.kind === "start" ? tag.name : "";
    for (const rule of rules) {
      const [selectors = "", ...declared] = rule.split("{");
      const declarations = declared.join("{");
      for (const selector of selectors.split(",")) {
        const last = lastNameOf(selector);
        const style = styles.get(last) ?? { asked: new Set(), declarations: 0 };
        for (const [, id] of declarations.matchAll(ADDRESS)) style.asked.add(`#${id}`);
        style.declarations += declarations.split(";").length;
        styles.set(last, style);
      }
    }
  }
  return styles;
}

/** A selector's end tells what it matches; the rest only where. */
function lastNameOf(selector: string): string {
  const end = selector.slice(-200).replace(/\[[^[\]]*\]|:[\w-]+/g, "");
  return /[.#]?[\w-]+(?=[^\w-]*$)/.exec(end.trim())?.[0] ?? "*";
}

/** What an element asks for by itself and by rules of style, and how many declarations that takes. */
function styleOf({ name, attributes }: XmlTag, styles: ReadonlyMap<string, Style>): Style {
  const asked = new Set<string>();
  for (const value of attributes.values()) for (const [, id] of value.matchAll(ADDRESS)) asked.add(`#${id}`);
  let declarations = attributes.size + (attributes.get("style") ?? "").split(";").length;
  if (styles.size === 0) return { asked, declarations };
  const classes = (attributes.get("class") ?? "").split(/\s+/).map((each) => `.${each}`);
  for (const each of new Set(["*", name, `#${attributes.get("id")}`, ...classes])) {
    const style = styles.get(each);
    for (const id of style?.asked ?? []) asked.add(id);
    declarations += style?.declarations ?? 0;
  }
  return { asked, declarations };
}

/** They are inherited too. */
function longestDashes(text: string): number {
  let most = 0;
  for (const [, dashes = ""] of text.matchAll(/stroke-dasharray\s*[:=]\s*["']?([^"';}]*)/g)) {
    most = Math.max(most, dashes.length);
  }
  return most;
}

/** References may spell any word; those to what would be markup stay. */
function spelledOut(svg: string): string {
  return svg.replace(/&#(?:x([0-9a-f]+)|(\d+));/gi, (reference, hex?: string, decimal?: string) => {
    const code = hex === undefined ? Number(decimal) : Number.parseInt(hex, 16);
    const character = code >= 0x20 && code < 0x7f ? String.fromCharCode(code) : "<";
    return `"'&<>`.includes(character) ? reference : character;
  });
}

/**
 * Drawings that are kept and handed on. Our own renderer runs nothing and fetches nothing, but a shop may show the file itself
 * some day: one that would then run something is not taken in the first place.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { badPicture } from "./picture-header.ts";
import { encodingOf } from "./svg-start.ts";
import { endOfOther, unquoted } from "./xml-tags.ts";

const HINT = "Open it in a drawing program and save it again as plain SVG, or save it as PNG.";

type Rule = readonly [pattern: RegExp, what: string];

/** What a document must not have, and how it is called. */
const MARKUP: readonly Rule[] = [
  [/<(?:[^\s<>/:]+:)?(?:script|handler|listener)\b/i, "a script"],
  [/<(?:[^\s<>/:]+:)?(?:iframe|object|embed|frame|form|base|link|meta)\b/i, "a part of a web page"],
  // Anywhere, since a quoted ">" would hide the tag's end.
  [/[\s"'/]on[a-z]{3,}\s*=\s*["']/i, "an event handler"],
  [/\battributeName\s*=\s*["']?\s*on/i, "an event handler"],
  [/<\?xml-stylesheet\b/i, "a style sheet of its own"],
  // No XML has them; some encodings switch by them, and they vanish from amid a word.
  // biome-ignore lint/suspicious/noControlCharactersInRegex: these are what is looked for.
  [/[\0-\x08\v\f\x0e-\x1f]/, "a control character"],
];
/** Browsers pass over blanks in these. */
const ADDRESSES: readonly Rule[] = [
  [/(?:javascript|vbscript|livescript):/i, "an address that runs a script"],
  [/data:(?:text\/html|text\/xml|application\/x?html)/i, "a web page"],
];
const METADATA = /^<(\/?)metadata(?:\s[\s\S]*?)?(\/?)>$/;
/** What a document's type may declare, and a comment: an attribute's default value would be one that no tag shows. */
const DECLARATION =
  /\s+|<!--[\s\S]*?-->|<!ELEMENT\s[^<>"'%]*>|<!ENTITY\s+([^\s%<>&;"']+)\s+(?:"([^"<%]*)"|'([^'<%]*)')\s*>/y;
/** Characters that entities may add: styles that old drawing programs write so stay far below. */
const MOST_SPELLED_OUT = 2 ** 24;

/** Values by names, spelled out themselves. */
type Entities = Map<string, string>;

/**
 * The drawing without comments and metadata, as UTF-8; a clean one gives itself. Throws "unsafe-file" naming the file where it
 * has scripts or what may lead to some, "bad-picture" where it is no text.
 */
export function cleanSvg(bytes: Uint8Array, name: string): Uint8Array<ArrayBuffer> {
  const svg = decode(bytes, name).replace(/^(<\?xml[^>]*?)\sencoding\s*=\s*(["'])[^"']*\2/, "$1");
  const entities: Entities = new Map();
  const clean = withoutAsides(svg, name, entities);
  // What is handed on is looked at, not what came, where a comment may part a word; as it is written, and as a browser reads it.
  const read = withoutReferences(spelledOut(clean, name, entities));
  for (const [pattern, what] of MARKUP) if (pattern.test(clean) || pattern.test(read)) throw unsafe(name, what);
  const addresses = read.replace(/[\s\0]+/g, "");
  for (const [pattern, what] of ADDRESSES) if (pattern.test(addresses)) throw unsafe(name, what);
  return new TextEncoder().encode(clean);
}

/**
 * Piece by piece, as XML is read, in linear time whatever the text is. Only whole pieces are left out, and no tag holds a "<": what
 * stood around them makes no new ones.
 * @param entities where those that are declared go
 */
function withoutAsides(svg: string, name: string, entities: Entities): string {
  const kept: string[] = [];
  /** Of metadata that has not ended: how many pieces were kept before. */
  const begun: number[] = [];
  let from = 0;
  const cut = (start: number, end: number): void => {
    kept.push(svg.slice(from, start));
    from = end;
  };
  for (let at = 0; ; ) {
    const start = svg.indexOf("<", at);
    if (start < 0) return kept.join("") + svg.slice(from);
    const next = svg[start + 1];
    const other = next === "!" || next === "?" ? endOfOther(svg, start) : null;
    at = other ?? (unquoted(svg, start, ">") + 1 || svg.length);
    if (other === null) {
      const inner = svg.indexOf("<", start + 1);
      if (inner > 0 && inner < at) throw unsafe(name, "a tag that another begins in");
      const [, ends, isEmpty] = isMetadata(svg, start) ? (METADATA.exec(svg.slice(start, at)) ?? []) : [];
      if (ends === undefined) continue;
      cut(start, isEmpty ? at : start);
      if (isEmpty) continue;
      if (ends === "") begun.push(kept.length);
      else if (begun.length > 0) {
        kept.length = begun.pop() ?? 0;
        from = at;
      }
    } else if (svg.startsWith("<!--", start)) cut(start, at);
    else if (next === "!" && svg[start + 2] !== "[") {
      cut(start, at);
      kept.push(declare(svg.slice(start, at), name, entities));
    }
  }
}

const isMetadata = (svg: string, start: number): boolean =>
  svg.startsWith("metadata", start + 1) || svg.startsWith("/metadata", start + 1);

/** A document's type without comments. */
function declare(type: string, name: string, entities: Entities): string {
  const opened = unquoted(type, 0, "[>") + 1 || type.length;
  let kept = type.slice(0, opened);
  if (!kept.endsWith("[")) return kept;
  for (let at = opened; ; at = DECLARATION.lastIndex) {
    DECLARATION.lastIndex = at;
    const [declaration, entity, value, otherValue] = DECLARATION.exec(type) ?? [];
    if (declaration === undefined) {
      const rest = type.slice(at);
      if (/^\]\s*>$/.test(rest)) return kept + rest;
      if (rest.startsWith("<!ENTITY")) throw unsafe(name, "an entity that stands for markup or another file");
      throw unsafe(name, "a document's type that declares more than entities");
    }
    if (!declaration.startsWith("<!--")) kept += declaration;
    if (entity === undefined) continue;
    const text = withoutReferences(value ?? otherValue ?? "");
    if (/[<&]/.test(text)) throw unsafe(name, "an entity that stands for markup or another file");
    // The first one of a name counts.
    if (!entities.has(entity)) entities.set(entity, text);
  }
}

function spelledOut(svg: string, name: string, entities: Entities): string {
  let spare = MOST_SPELLED_OUT;
  return svg.replace(/&([^\s&;<>"']+);/g, (reference, entity: string) => {
    const value = entities.get(entity);
    if (value === undefined) return reference;
    spare -= value.length;
    if (spare < 0) throw unsafe(name, "entities that stand for too much");
    return value;
  });
}

function decode(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder(encodingOf(bytes), { fatal: true }).decode(bytes);
  } catch (cause) {
    throw badPicture(name, "encoding", "its text is neither UTF-8 nor UTF-16", HINT, cause);
  }
}

const NAMED: Readonly<Record<string, string>> = { colon: ":", Tab: "\t", NewLine: "\n", lpar: "(", rpar: ")" };

function withoutReferences(svg: string): string {
  return svg.replace(
    /&(?:#x([0-9a-f]{1,6})|#(\d{1,7})|(\w+));?/gi,
    (whole, hex?: string, decimal?: string, named = "") => {
      const code = hex ? Number.parseInt(hex, 16) : Number(decimal ?? Number.NaN);
      if (Number.isNaN(code)) return Object.hasOwn(NAMED, named) ? (NAMED[named] ?? whole) : whole;
      return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
    },
  );
}

const unsafe = (name: string, what: string): TexelcastError =>
  new TexelcastError("unsafe-file", `The drawing “${name}” is not taken: it holds ${what}.`, {
    subject: name,
    hint: HINT,
  });

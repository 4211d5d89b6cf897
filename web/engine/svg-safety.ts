/**
 * Drawings that are kept and handed on. Our own renderer runs nothing and fetches nothing, but a shop may show the file itself
 * some day: one that would then run something is not taken in the first place.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { badPicture } from "./picture-header.ts";
import { encodingOf } from "./svg-start.ts";

const HINT = "Open it in a drawing program and save it again as plain SVG, or save it as PNG.";

type Rule = readonly [pattern: RegExp, what: string];

/** What a document must not have, and how it is called. */
const MARKUP: readonly Rule[] = [
  [/<(?:[\w-]+:)?(?:script|handler|listener)\b/i, "a script"],
  [/<(?:[\w-]+:)?(?:iframe|object|embed|frame|form|base|link|meta)\b/i, "a part of a web page"],
  // Anywhere, since a quoted ">" would hide the tag's end.
  [/[\s"'/]on[a-z]{3,}\s*=\s*["']/i, "an event handler"],
  [/\battributeName\s*=\s*["']?\s*on/i, "an event handler"],
  [/<\?xml-stylesheet\b/i, "a style sheet of its own"],
];
const ENTITY = /SYSTEM|PUBLIC|["'][^"'>]*</i;
/** Browsers pass over blanks in these. */
const ADDRESSES: readonly Rule[] = [
  [/(?:javascript|vbscript|livescript):/i, "an address that runs a script"],
  [/data:(?:text\/html|text\/xml|application\/x?html)/i, "a web page"],
];

/**
 * The drawing without comments and metadata, as UTF-8; a clean one gives itself. Throws "unsafe-file" naming the file where it
 * has scripts or what may lead to some, "bad-picture" where it is no text.
 */
export function cleanSvg(bytes: Uint8Array, name: string): Uint8Array<ArrayBuffer> {
  const svg = decode(bytes, name);
  // A scanner is misled by what it leaves out: nothing is looked at before it is read as a browser would read it.
  const read = withoutReferences(svg);
  for (const [pattern, what] of MARKUP) if (pattern.test(svg) || pattern.test(read)) throw unsafe(name, what);
  if (hasUnsafeEntity(svg) || hasUnsafeEntity(read))
    throw unsafe(name, "an entity that stands for markup or another file");
  const addresses = read.replace(/[\s\0]+/g, "");
  for (const [pattern, what] of ADDRESSES) if (pattern.test(addresses)) throw unsafe(name, what);
  const plain = svg.replace(/^\ufeff/, "").replace(/^(<\?xml[^>]*?)\sencoding\s*=\s*(["'])[^"']*\2/, "$1");
  const clean = withoutMetadata(plain);
  return new TextEncoder().encode(clean.includes("<![CDATA[") ? clean : withoutComments(clean));
}

type Search = (from: number) => RegExpExecArray | null;

/** Looks for a pattern from places that only grow: a hostile text takes no longer than another one of its length. */
function forward(text: string, pattern: RegExp): Search {
  let found: RegExpExecArray | null | undefined;
  return (from) => {
    if (found === undefined || (found !== null && found.index < from)) {
      pattern.lastIndex = from;
      found = pattern.exec(text);
    }
    return found;
  };
}

const endOf = (found: RegExpExecArray | null): number => (found === null ? -1 : found.index + found[0].length);

function hasUnsafeEntity(text: string): boolean {
  const nextEntity = forward(text, /<!ENTITY\s/gi);
  const nextEnd = forward(text, />/g);
  for (let entity = nextEntity(0); entity !== null; ) {
    const end = nextEnd(entity.index)?.index ?? text.length;
    if (ENTITY.test(text.slice(entity.index, end))) return true;
    entity = nextEntity(end);
  }
  return false;
}

function withoutMetadata(svg: string): string {
  const nextEnd = forward(svg, />/g);
  const nextClose = forward(svg, /<\/metadata\s*>/g);
  return without(svg, /<metadata\b/g, (start) => {
    const end = endOf(nextEnd(start));
    return end < 0 || svg[end - 2] === "/" ? end : endOf(nextClose(end));
  });
}

function withoutComments(svg: string): string {
  const nextClose = forward(svg, /-->/g);
  return without(svg, /<!--/g, (start) => endOf(nextClose(start)));
}

/** @param endFrom where what begins at a place ends; -1 where it does not */
function without(text: string, pattern: RegExp, endFrom: (start: number) => number): string {
  let kept = "";
  let from = 0;
  for (const { index } of text.matchAll(pattern)) {
    const end = index < from ? -1 : endFrom(index);
    if (end < 0) continue;
    kept += text.slice(from, index);
    from = end;
  }
  return kept + text.slice(from);
}

function decode(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder(encodingOf(bytes), { fatal: true }).decode(bytes);
  } catch (cause) {
    throw badPicture(name, "its text is neither UTF-8 nor UTF-16", HINT, cause);
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

/**
 * A line of text cut into runs of one direction, one script and one font, in the order in which the eye meets them from
 * left to right. Directions by the Unicode Bidirectional Algorithm (UAX 9).
 */
import bidiFactory from "bidi-js";
import { EMOJI, shippedFontAddress, standIn } from "./shipped-fonts.ts";
import { isEmoji, joinsEmoji } from "./text-emoji.ts";
import type { FontShelf, TextFont } from "./text-fonts.ts";
import { isInvisible, isMark, scriptOf } from "./text-script.ts";

export interface TextRun {
  readonly text: string;
  readonly font: TextFont;
  readonly script: string;
  readonly rightToLeft: boolean;
}

const bidi = bidiFactory();

/**
 * Unicode's composed form, which most fonts have; tabs as spaces, other control characters left out. Latin ligatures that are one
 * character, as text copied from a PDF has them, are their letters: few fonts have the character, and those that join the letters
 * do so by themselves.
 */
export const cleanText = (text: string): string =>
  text
    .normalize("NFC")
    .replace(/[\ufb00-\ufb06]/g, (ligature) => ligature.normalize("NFKC"))
    .replace(/\r\n?|[\u2028\u2029]/g, "\n")
    .replaceAll("\t", " ")
    .replace(/[^\P{Cc}\n]/gu, "");

/**
 * The keys of the fonts that a text may need: its own, and those that stand in for characters that its own lacks. Only when
 * the text's own font is on the shelf is the answer whole.
 */
export function fontsFor(text: string, key: string, shelf: FontShelf): string[] {
  const own = shelf.get(key);
  if (own === undefined) return [key];
  const keys = new Set([key]);
  for (const { standIns } of clustersOf(cleanText(text), own)) for (const font of standIns) keys.add(font);
  return [...keys];
}

/** The characters that neither the font nor one that stands in for it has, each once. The fonts must be on the shelf. */
export function missingCharacters(text: string, key: string, shelf: FontShelf): string[] {
  const own = shelf.get(key);
  if (own === undefined) return [];
  const missing = new Set<string>();
  for (const { text: cluster, standIns } of clustersOf(cleanText(text), own)) {
    const used = fontOf(cluster, standIns, own, shelf);
    for (const character of cluster) if (!isInvisible(character) && !hasGlyph(used, character)) missing.add(character);
  }
  return [...missing];
}

/** The runs of one line, left to right. The fonts that `fontsFor` names must be on the shelf. */
export function runsOf(line: string, key: string, shelf: FontShelf): TextRun[] {
  const own = shelf.get(key);
  if (own === undefined || line === "") return [];
  const embedding = bidi.getEmbeddingLevels(inSingleUnits(line));
  const runs: (TextRun & { readonly start: number; readonly level: number })[] = [];
  let at = 0;
  for (const { text, script, standIns } of clustersOf(line, own)) {
    const font = fontOf(text, standIns, own, shelf);
    const level = embedding.levels[at] ?? 0;
    const last = runs.at(-1);
    if (last && last.level === level && last.font === font && last.script === script) {
      runs[runs.length - 1] = { ...last, text: last.text + text };
    } else runs.push({ text, font, script, level, start: at, rightToLeft: level % 2 === 1 });
    at += text.length;
  }
  return inVisualOrder(runs);
}

/** One character of each of Unicode's directions that characters beyond U+FFFF have; "L" is what is left. */
const OF_DIRECTION: Readonly<Record<string, string>> = {
  R: "\u05d0",
  AL: "\u0627",
  EN: "1",
  AN: "\u0660",
  ET: "#",
  NSM: "\u0300",
  BN: "\u00ad",
  ON: "!",
};

/**
 * The line with each character that takes two UTF-16 units as two characters of its direction. bidi-js looks at unit by unit, and
 * takes half an emoji for a Latin letter: a line in Arabic that begins with one would be set from left to right.
 */
const inSingleUnits = (line: string): string =>
  line.replace(/[\u{10000}-\u{10ffff}]/gu, (character) =>
    (OF_DIRECTION[bidi.getBidiCharTypeName(character)] ?? "A").repeat(2),
  );

/** UAX 9, rule L2, on whole runs: what lies at a level or above is turned round, from the highest level down. */
function inVisualOrder<Run extends { readonly level: number }>(runs: readonly Run[]): Run[] {
  const order = [...runs];
  const highest = Math.max(0, ...order.map(({ level }) => level));
  for (let level = highest; level > 0; level--) {
    for (let start = 0; start < order.length; start++) {
      let end = start;
      while (end < order.length && (order[end]?.level ?? 0) >= level) end++;
      if (end > start) {
        order.splice(start, end - start, ...order.slice(start, end).reverse());
        start = end;
      }
    }
  }
  return order;
}

interface Cluster {
  /** A character and the marks on it, or an emoji of several. */
  readonly text: string;
  readonly script: string;
  /** Keys of the fonts that may stand in, the first of them before the next; none: the text's own has it. */
  readonly standIns: readonly string[];
}

/** The first that has all of it; where none has, the first. */
function fontOf(cluster: string, standIns: readonly string[], own: TextFont, shelf: FontShelf): TextFont {
  const fonts = standIns.map((key) => shelf.get(key) ?? own);
  return fonts.find((font) => !lacks(font, cluster)) ?? fonts[0] ?? own;
}

/** What all scripts share (spaces, marks, digits) goes with the letters before it, at a line's beginning with those after. */
function* clustersOf(text: string, own: TextFont): Iterable<Cluster> {
  const clusters: string[] = [];
  for (const character of text) {
    const last = clusters.length - 1;
    if (last >= 0 && (isMark(character) || joinsEmoji(clusters[last] ?? "", character))) clusters[last] += character;
    else clusters.push(character);
  }
  let script = clusters.map(firstScript).find((tag) => tag !== null) ?? "Latn";
  for (const cluster of clusters) {
    const ownScript = firstScript(cluster);
    script = ownScript ?? script;
    const isLacking = lacks(own, cluster);
    const written = isLacking && isEmoji(cluster) ? EMOJI : script;
    // What all scripts share, their own fonts may lack as well: hearts, arrows, fractions.
    const scripts = !isLacking ? [] : ownScript === null && written !== EMOJI ? [written, "Latn"] : [written];
    yield {
      text: cluster,
      script: written,
      standIns: scripts.map((tag) => shippedFontAddress(standIn(tag, own.weight))),
    };
  }
}

function firstScript(cluster: string): string | null {
  for (const character of cluster) {
    const script = scriptOf(character);
    if (script !== null) return script;
  }
  return null;
}

const lacks = (font: TextFont, cluster: string): boolean =>
  [...cluster].some((character) => !isInvisible(character) && !hasGlyph(font, character));

const hasGlyph = (font: TextFont, character: string): boolean => font.covers(character.codePointAt(0) ?? 0);

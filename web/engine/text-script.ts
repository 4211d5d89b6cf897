/** Which script a character is written in, and what follows from that for setting it. */

/** ISO 15924, and how Unicode names it in regular expressions. Latin is what is left. */
const SCRIPTS: readonly (readonly [tag: string, pattern: RegExp])[] = [
  ["Latn", /\p{Script=Latin}/u],
  ["Grek", /\p{Script=Greek}/u],
  ["Cyrl", /\p{Script=Cyrillic}/u],
  ["Arab", /\p{Script=Arabic}/u],
  ["Hebr", /\p{Script=Hebrew}/u],
  ["Deva", /\p{Script=Devanagari}/u],
  ["Syrc", /\p{Script=Syriac}/u],
  ["Thaa", /\p{Script=Thaana}/u],
  ["Nkoo", /\p{Script=Nko}/u],
  ["Beng", /\p{Script=Bengali}/u],
  ["Guru", /\p{Script=Gurmukhi}/u],
  ["Gujr", /\p{Script=Gujarati}/u],
  ["Orya", /\p{Script=Oriya}/u],
  ["Taml", /\p{Script=Tamil}/u],
  ["Telu", /\p{Script=Telugu}/u],
  ["Knda", /\p{Script=Kannada}/u],
  ["Mlym", /\p{Script=Malayalam}/u],
  ["Sinh", /\p{Script=Sinhala}/u],
  ["Thai", /\p{Script=Thai}/u],
  ["Laoo", /\p{Script=Lao}/u],
  ["Tibt", /\p{Script=Tibetan}/u],
  ["Mymr", /\p{Script=Myanmar}/u],
  ["Khmr", /\p{Script=Khmer}/u],
  ["Mong", /\p{Script=Mongolian}/u],
  ["Geor", /\p{Script=Georgian}/u],
  ["Armn", /\p{Script=Armenian}/u],
  ["Ethi", /\p{Script=Ethiopic}/u],
  ["Hang", /\p{Script=Hangul}/u],
  ["Hira", /\p{Script=Hiragana}/u],
  ["Kana", /\p{Script=Katakana}/u],
  ["Hani", /\p{Script=Han}/u],
];

/** Scripts whose letters hang together: space between them would tear words apart (CSS Text 3 asks the same). */
const JOINED = new Set(["Arab", "Syrc", "Nkoo", "Mong", "Deva", "Beng", "Guru"]);

/** The script's ISO 15924 tag; null for what all scripts share (spaces, digits, marks). */
export function scriptOf(character: string): string | null {
  return SCRIPTS.find(([, pattern]) => pattern.test(character))?.[0] ?? null;
}

/** Whether letters of the script may be set apart. */
export const takesSpacing = (script: string): boolean => !JOINED.has(script);

/**
 * A character that is written onto the one before it, or that only says how it joins (U+200D): in a font of its own it would part
 * the letters on either side. Hangul's fillers stand for letters, and a direction's marks have directions of their own.
 */
export const isMark = (character: string): boolean =>
  /(?![\p{Script=Hangul}\p{Bidi_Control}])[\p{Mark}\p{Default_Ignorable_Code_Point}]/u.test(character);

/** A character that no font needs a picture for. */
export const isInvisible = (character: string): boolean => /[\p{Default_Ignorable_Code_Point}\s]/u.test(character);

/**
 * Emoji among the characters of a text (Unicode Technical Standard 51), by a list of our own: an engine's tables grow with each
 * version of Unicode, and the same words must be set alike in old and new browsers.
 */

/**
 * The emoji that Inter lacks. Between them are characters that neither Inter nor the emoji font has, never one that Inter has: ©, ♥, ★
 * and others that were signs of type before they were emoji are left to it.
 */
const PICTURE =
  /[\u2139\u231a\u231b\u2328\u23e9-\u23fa\u25ab\u25fb-\u25fe\u2601-\u2604\u260e-\u263a\u2640-\u2660\u2663\u2666-\u269c\u26a1-\u2712\u2714-\u2716\u271d-\u2755\u2757-\u2763\u2795-\u27bf\u2934\u2935\u2b05\u2b07\u2b1b\u2b50-\u2b55\u3030-\u303d\u3297-\u3299\u{1f004}\u{1f0cf}\u{1f170}-\u{1f7ff}\u{1f900}-\u{1faff}]/u;
const KEYCAP = "\u20e3";
const JOINER = "\u200d";
const FLAG = /^[\u{1f1e6}-\u{1f1ff}]{2}$/u;
const TONE = /[\u{1f3fb}-\u{1f3ff}]/u;
const TAKES_TONE = new RegExp(`${PICTURE.source}\\ufe0f?$`, "u");
/** A heart and two arrows, signs of type by themselves, are joined too. */
const PART = new RegExp(`^(?:${PICTURE.source}|[\\u2194\\u2195\\u2764])`, "u");

/** Whether a character and its marks are an emoji that fonts of letters lack; a digit in a keycap is one. */
export const isEmoji = (cluster: string): boolean => PICTURE.test(cluster) || cluster.endsWith(KEYCAP);

/** Whether a character goes on with the emoji before it: a flag's second letter, a tone of skin, what a joiner joins. */
export function joinsEmoji(before: string, character: string): boolean {
  if (!PART.test(character)) return false;
  return (
    FLAG.test(before + character) ||
    (TONE.test(character) && TAKES_TONE.test(before)) ||
    (before.endsWith(JOINER) && PART.test(before))
  );
}

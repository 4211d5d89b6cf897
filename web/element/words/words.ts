/** Which language an element speaks. Each element has its own; German and a shop's own words come when they are first asked for. */
import { english, type Words, type WordsLanguage } from "./english.ts";

export type { Words, WordsLanguage } from "./english.ts";
export { english } from "./english.ts";

/** The first wish that is spoken here, by its first part ("de-AT" is German); English where none is. */
export function languageOf(wishes: readonly unknown[]): WordsLanguage {
  for (const wish of wishes) {
    const spoken = typeof wish === "string" && wish.toLowerCase().split(/[-_]/)[0];
    if (spoken === "en" || spoken === "de") return spoken;
  }
  return "en";
}

/**
 * English where a language's words cannot be loaded, and no words of the shop's own where what reads them cannot.
 *
 * @param wording a shop's own words, or their address; null: none.
 * @param told hears of those of them that cannot be taken.
 */
export async function wordsIn(
  language: WordsLanguage,
  wording: unknown,
  told: (error: unknown) => void,
): Promise<Words> {
  const words: Words =
    language === "en"
      ? english
      : await import("./german.ts").then(
          ({ german }) => german,
          () => english,
        );
  if (!wording) return words;
  try {
    return await (await import("./worded.ts")).worded(words, wording, told);
  } catch (thrown) {
    told(thrown);
    return words;
  }
}

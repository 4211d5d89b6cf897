/** Which language an element speaks. Each element has its own; German comes when it is first asked for. */
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

/** English where a language's words cannot be loaded. */
export async function wordsIn(language: WordsLanguage): Promise<Words> {
  if (language === "en") return english;
  return await import("./german.ts").then(
    ({ german }) => german,
    () => english,
  );
}

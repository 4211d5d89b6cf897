/** What is said of putting something on the product, apart from the words that every product is shown with. */
import type { WordsLanguage } from "./english.ts";

export const PLACING_WORDS: Readonly<Record<WordsLanguage, { readonly message: string; readonly hint: string }>> = {
  en: { message: "There is no surface to put it on.", hint: "Turn the product so that it can be seen." },
  de: { message: "Es gibt keine Fläche dafür.", hint: "Dreh das Produkt so, dass man sie sieht." },
};

/** What is said of putting something on the product, apart from the words that every product is shown with. */
import type { WordsLanguage } from "./english.ts";

interface Said {
  readonly message: string;
  readonly hint: string;
}

interface PlacingWords {
  readonly nowhere: Said;
  /** Of new words as of those that are changed. */
  readonly noFont: Said;
}

export const PLACING_WORDS: Readonly<Record<WordsLanguage, PlacingWords>> = {
  en: {
    nowhere: { message: "There is no surface to put it on.", hint: "Turn the product so that it can be seen." },
    noFont: {
      message: "The font for this could not be loaded, so nothing was changed.",
      hint: "Check your connection and try again, or choose another font.",
    },
  },
  de: {
    nowhere: { message: "Es gibt keine Fläche dafür.", hint: "Dreh das Produkt so, dass man sie sieht." },
    noFont: {
      message: "Die Schrift dafür ließ sich nicht laden, deshalb bleibt alles, wie es war.",
      hint: "Prüf die Verbindung und versuch es noch einmal, oder nimm eine andere Schrift.",
    },
  },
};

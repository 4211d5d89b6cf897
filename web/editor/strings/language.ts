/** Which language an editor speaks; of a page, what its address asks for, else what was chosen before, else the first that the browser prefers. */
import { keepChoice, keptChoice } from "../storage/kept-choice.ts";

export const LANGUAGES = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof LANGUAGES;

const KEPT = "texelcast-language";

export interface LanguageWishes {
  /** The address's query, "?lang=de". */
  readonly search: string;
  readonly kept: string | null;
  readonly preferred: readonly string[];
}

/** English where none of the wishes is spoken here. */
export function languageFor({ search, kept, preferred }: LanguageWishes): Language {
  const wishes = [new URLSearchParams(search).get("lang"), kept, ...preferred];
  const spoken = wishes.map((wish) => wish?.toLowerCase().split("-")[0]).find((wish) => isLanguage(wish));
  return isLanguage(spoken) ? spoken : "en";
}

/** What the page is asked to speak; English outside a page. An element in a page of somebody else's has its own language. */
export const pageLanguage: Language =
  typeof document === "undefined"
    ? "en"
    : languageFor({ search: location.search, kept: keptChoice(KEPT), preferred: navigator.languages });

/** Speaks another language from now on: the page is loaded again. */
export function speak(chosen: Language): void {
  // A browser that keeps nothing is told by the address.
  keepChoice(KEPT, chosen);
  const address = new URL(location.href);
  address.searchParams.set("lang", chosen);
  location.assign(address);
}

/** Tells the document its language and its direction; `?dir=rtl` mirrors the page, to see that its layout holds. */
export function applyLanguage(root: HTMLElement): void {
  root.lang = pageLanguage;
  root.dir = new URLSearchParams(location.search).get("dir") === "rtl" ? "rtl" : "ltr";
}

function isLanguage(code: string | null | undefined): code is Language {
  return typeof code === "string" && Object.hasOwn(LANGUAGES, code);
}

/** Numbers and times as a language writes them. */
import type { Language } from "./language.ts";

/** The page's English is British. */
const LOCALES: Readonly<Record<Language, string>> = { en: "en-GB", de: "de" };

export interface NumberWords {
  /** "3,428,621", "3.428.621". */
  readonly whole: (value: number) => string;
  /** "81.7", "81,7". */
  readonly tenths: (value: number) => string;
  /** "0.32", "0,32". */
  readonly hundredths: (value: number) => string;
  /** `time`: milliseconds since 1970, as `Date.now` has them. */
  readonly moment: (time: number) => string;
}

export function numbersIn(language: Language): NumberWords {
  const locale = LOCALES[language];
  const decimals = (digits: number): Intl.NumberFormat =>
    new Intl.NumberFormat(locale, { minimumFractionDigits: digits, maximumFractionDigits: digits });
  const [whole, one, two] = [new Intl.NumberFormat(locale), decimals(1), decimals(2)];
  const dateAndTime = new Intl.DateTimeFormat(locale, { dateStyle: "medium", timeStyle: "short" });
  return {
    whole: (value) => whole.format(value),
    tenths: (value) => one.format(value),
    hundredths: (value) => two.format(value),
    moment: (time) => dateAndTime.format(time),
  };
}

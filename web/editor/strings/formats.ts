/** Numbers and times as the page's language writes them. */
import { type Language, language } from "./language.ts";

/** The page's English is British. */
const LOCALES: Readonly<Record<Language, string>> = { en: "en-GB", de: "de" };
const locale = LOCALES[language];

const whole = new Intl.NumberFormat(locale);
const oneDecimal = new Intl.NumberFormat(locale, { minimumFractionDigits: 1, maximumFractionDigits: 1 });
const twoDecimals = new Intl.NumberFormat(locale, { minimumFractionDigits: 2, maximumFractionDigits: 2 });
const dateAndTime = new Intl.DateTimeFormat(locale, { dateStyle: "medium", timeStyle: "short" });

/** What stands before the decimals: "." or ",". */
export const DECIMAL_MARK = oneDecimal.formatToParts(0.5).find(({ type }) => type === "decimal")?.value ?? ".";

/** "3,428,621", "3.428.621". */
export const wholeNumber = (value: number): string => whole.format(value);

/** "81.7", "81,7". */
export const tenths = (value: number): string => oneDecimal.format(value);

/** "0.32", "0,32". */
export const hundredths = (value: number): string => twoDecimals.format(value);

/** @param time Milliseconds since 1970, as `Date.now` has them. */
export const momentOf = (time: number): string => dateAndTime.format(time);

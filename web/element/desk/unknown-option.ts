/**
 * An option that there is not, told in the element's words, which are here and not among the others: only a page's own slip of
 * the pen asks for them.
 */
import { ToldError } from "../../editor/strings/told-error.ts";
import type { Words } from "../words/words.ts";

const TOLD = {
  en: { message: (name: string) => `There is no option “${name}”.`, hint: (known: string) => `There are ${known}.` },
  de: {
    message: (name: string) => `Die Option „${name}“ gibt es nicht.`,
    hint: (known: string) => `Es gibt ${known}.`,
  },
};

/** "bad-argument", with the option, what stands there, and the options that there are. */
export function unknownOption(field: string, value: unknown, known: string, { language }: Words): ToldError {
  const { message, hint } = TOLD[language];
  return new ToldError("bad-argument", message(field), { field, value: String(value).slice(0, 80), hint: hint(known) });
}

/** Throws the error for the first option that is said and not among the known. */
export function checkNames(options: object, known: readonly string[], words: Words): void {
  for (const [name, value] of Object.entries(options)) {
    if (value !== undefined && !known.includes(name)) throw unknownOption(name, value, known.join(", "), words);
  }
}

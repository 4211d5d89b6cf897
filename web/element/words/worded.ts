/** Puts a shop's own words (`EditorWording`) in place of the element's. Loaded by the first element that has any. */
import { TexelcastError, type TexelcastErrorJson } from "../../core/texelcast-error.ts";
import type { ErrorWords } from "../../editor/strings/error-words.ts";
import type { PrintFinding } from "../../engine/print-report.ts";
import { addressOf, fetchBytes } from "../desk/read-model.ts";
import type { Words } from "./english.ts";
import type { EditorWording, Told } from "./wording.ts";

/** Places of the templates, in the order of what the element's own words are called with. */
const PLACES: Readonly<Record<string, readonly string[]>> = {
  full: ["most"],
  remove: ["name"],
  printIssues: ["count"],
  dpi: ["value"],
  area: ["value"],
  "announce.added": ["name"],
  "announce.removed": ["name"],
  "announce.selected": ["name"],
  "errors.unreachable": ["address"],
  "errors.tooMany": ["most"],
  "errors.refused": ["name"],
  "errors.zoneMaterial": ["zone", "material"],
  "errors.zoneMaterialHint": ["materials"],
  "errors.badOption": ["name"],
};
const FINDING_PLACES = ["value", "limit", "zone", "characters"] as const;
const ERROR_PLACES = ["name", "value"] as const;

/**
 * @param given An `EditorWording`, or the address of one.
 * @param told Hears of each word that cannot be taken ("bad-argument" with its path in `field`), and of an address that cannot be read;
 *   the element's own word then stays.
 */
export async function worded(base: Words, given: unknown, told: (error: unknown) => void): Promise<Words> {
  try {
    return new Wording(base, told).apply(typeof given === "string" ? await fetched(given, base) : given);
  } catch (error) {
    told(error);
    return base;
  }
}

async function fetched(address: string, words: Words): Promise<unknown> {
  const url = addressOf(address, document.baseURI, words);
  const bytes = await fetchBytes(url, { words, signal: new AbortController().signal });
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch (cause) {
    throw new TexelcastError("missing-file", `The words at “${url.href}” could not be read.`, {
      subject: url.href,
      hint: "Check that they are JSON.",
      cause,
    });
  }
}

type Values = Readonly<Record<string, unknown>>;

const isPlainObject = (value: unknown): value is Values =>
  typeof value === "object" && value !== null && !Array.isArray(value);

class Wording {
  readonly #base: Words;
  readonly #told: (error: unknown) => void;
  #lang = "";
  #decimal = ".";

  constructor(base: Words, told: (error: unknown) => void) {
    this.#base = base;
    this.#told = told;
  }

  apply(given: unknown): Words {
    if (!isPlainObject(given)) {
      this.#wrong("", given, "an object of words");
      return this.#base;
    }
    const { lang, nowhere, noFont, noGraphics, ways, findings, told, ...words } = given as EditorWording;
    this.#lang = this.#languageTag(lang) ?? this.#base.lang;
    this.#decimal =
      new Intl.NumberFormat(this.#lang).formatToParts(0.5).find(({ type }) => type === "decimal")?.value ?? ".";
    return {
      ...(this.#section(this.#base, words, "") as Words),
      lang: this.#lang,
      finding: this.#findings(findings),
      told: this.#errors(told),
      own: {
        ...(nowhere !== undefined && { nowhere: this.#checked(nowhere, "nowhere", []) }),
        ...(noFont !== undefined && { noFont: this.#checked(noFont, "noFont", []) }),
        ...(noGraphics !== undefined && { noGraphics: this.#checked(noGraphics, "noGraphics", []) }),
        ...(ways !== undefined && this.#areWays(ways) && { ways }),
      },
    };
  }

  #wrong(path: string, value: unknown, hint: string): void {
    const field = path ? `wording.${path}` : "wording";
    const details = { field, value: typeof value === "object" ? "object" : String(value), hint: `It is ${hint}.` };
    this.#told(new TexelcastError("bad-argument", this.#base.errors.badOption(field), details));
  }

  #languageTag(lang: unknown): string | undefined {
    if (lang === undefined) return undefined;
    try {
      return Intl.getCanonicalLocales(lang as string)[0];
    } catch {
      this.#wrong("lang", lang, 'a language tag, as "fr" or "pt-BR"');
      return undefined;
    }
  }

  /** The element's words with those that are given in their places. */
  #section(base: Values, given: Values, path: string): Values {
    const words: Record<string, unknown> = { ...base };
    for (const [key, value] of Object.entries(given)) {
      const own = Object.hasOwn(base, key) ? base[key] : undefined;
      const at = path + key;
      if (value === undefined) continue;
      if (typeof own === "string" && !FIXED.has(at)) words[key] = this.#text(value, at, []) ?? own;
      else if (typeof own === "function" && !FIXED.has(at)) words[key] = this.#template(value, at) ?? own;
      else if (isPlainObject(own) && isPlainObject(value)) words[key] = this.#section(own, value, `${at}.`);
      else
        this.#wrong(
          at,
          value,
          isPlainObject(own)
            ? "an object of words"
            : `one of: ${[...Object.keys(base).filter((each) => !FIXED.has(each)), ...(path ? [] : APART)].join(", ")}`,
        );
    }
    return words;
  }

  /** Undefined for what is no text, or has a place in braces that nothing is told in. */
  #text(value: unknown, path: string, places: readonly string[]): string | undefined {
    if (typeof value !== "string") {
      this.#wrong(path, value, "a text");
      return undefined;
    }
    const strange = [...value.matchAll(PLACE)].find(([, place = ""]) => places.length > 0 && !places.includes(place));
    if (strange) this.#wrong(path, value, `a text with the places ${places.map((place) => `{${place}}`).join(", ")}`);
    return strange ? undefined : value;
  }

  #template(value: unknown, path: string): ((...values: unknown[]) => string) | undefined {
    const places = PLACES[path] ?? [];
    if (!isPlainObject(value)) {
      const text = this.#text(value, path, places);
      return text === undefined ? undefined : (...values) => this.#fill(text, places, values);
    }
    const forms: Record<string, string | undefined> = {};
    for (const [category, form] of Object.entries(value))
      forms[category] = this.#text(form, `${path}.${category}`, places);
    const { other } = forms;
    if (other === undefined) {
      this.#wrong(path, value, 'a text, or texts by plural with "other" among them');
      return undefined;
    }
    const rules = new Intl.PluralRules(this.#lang);
    return (...values) => this.#fill(forms[rules.select(Number(values[0]))] ?? other, places, values);
  }

  #fill(text: string, places: readonly string[], values: readonly unknown[]): string {
    return text.replace(PLACE, (whole, place: string) => {
      const index = places.indexOf(place);
      return index < 0 ? whole : this.#written(values[index]);
    });
  }

  /** Numbers with the language's decimal sign. */
  #written(value: unknown): string {
    const text = String(value ?? "");
    return /^-?\d+\.\d+$/.test(text) ? text.replace(".", this.#decimal) : text;
  }

  #checked(given: unknown, path: string, places: readonly string[]): Told {
    if (!isPlainObject(given)) {
      this.#wrong(path, given, "an object with message and hint");
      return {};
    }
    const part = (key: "message" | "hint"): Told => {
      const text = given[key] === undefined ? undefined : this.#text(given[key], `${path}.${key}`, places);
      return text === undefined ? {} : { [key]: text };
    };
    return { ...part("message"), ...part("hint") };
  }

  #areWays(ways: unknown): boolean {
    const are = Array.isArray(ways) && ways.length === 4 && ways.every((way) => typeof way === "string");
    if (!are) this.#wrong("ways", ways, "four texts: left, right, down, up");
    return are;
  }

  #table(given: unknown, path: string, places: readonly string[], inner?: string): Map<string, Told> {
    const table = new Map<string, Told>();
    if (given === undefined) return table;
    if (!isPlainObject(given)) this.#wrong(path, given, "an object by codes");
    else {
      for (const [code, each] of Object.entries(given)) {
        table.set(code, this.#checked(each, `${path}.${code}`, places));
        const more = inner !== undefined && isPlainObject(each) ? each[inner] : undefined;
        if (more !== undefined) table.set(`${code}/${inner}`, this.#checked(more, `${path}.${code}.${inner}`, places));
      }
    }
    return table;
  }

  #findings(given: unknown): Words["finding"] {
    const table = this.#table(given, "findings", FINDING_PLACES, "grave");
    return (finding: PrintFinding, grave: boolean): ErrorWords => {
      const own = this.#base.finding(finding, grave);
      const { value, limit, zone, characters = [] } = finding;
      const said = [table.get(finding.code), grave ? table.get(`${finding.code}/grave`) : undefined];
      return this.#filled(own, said, FINDING_PLACES, [value, limit, zone, characters.join(" ")]);
    };
  }

  #errors(given: unknown): Words["told"] {
    const table = this.#table(given, "told", ERROR_PLACES);
    return (error: TexelcastErrorJson): ErrorWords => {
      const own = this.#base.told(error);
      const said = [table.get(error.code), table.get(`${error.code}/${error.reason}`)];
      return this.#filled(own, said, ERROR_PLACES, [error.subject, error.value]);
    };
  }

  /** The last that says something goes first. */
  #filled(
    own: ErrorWords,
    said: readonly (Told | undefined)[],
    places: readonly string[],
    values: unknown[],
  ): ErrorWords {
    const texts: Told = Object.assign({}, ...said);
    const filled = (text: string | undefined, otherwise: string): string =>
      text === undefined ? otherwise : this.#fill(text, places, values);
    if (texts.message === undefined && texts.hint === undefined) return own;
    return { message: filled(texts.message, own.message), hint: filled(texts.hint, own.hint) };
  }
}

const PLACE = /\{(\w+)\}/g;

/** What a wording has beside the element's own words, or in another form. */
const APART = [
  "lang",
  "findings",
  "told",
  "nowhere",
  "noFont",
  "noGraphics",
  "ways",
] as const satisfies (keyof EditorWording)[];

/** What has words of another form, or none. */
const FIXED: ReadonlySet<string> = new Set(["language", "lang", "told", "finding", "own"]);

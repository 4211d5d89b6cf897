/** Words of a shop's own in place of the element's. */
import { readdirSync, readFileSync } from "node:fs";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { english, type Words } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";
import { worded } from "../../web/element/words/worded.ts";
import type { PrintFinding } from "../../web/engine/print-report.ts";

const FOLDER = "web/element/wording";
const SHIPPED = readdirSync(FOLDER).map((file) => file.slice(0, -".json".length));
const shipped = (language: string): Record<string, unknown> =>
  JSON.parse(readFileSync(`${FOLDER}/${language}.json`, "utf8"));

interface Result {
  readonly words: Words;
  /** What could not be taken: "field: value". */
  readonly faults: string[];
}

async function applied(given: unknown, base: Words = english): Promise<Result> {
  const faults: string[] = [];
  const words = await worded(base, given, (error) => {
    const { code, field, subject, value } = error as TexelcastError;
    faults.push(code === "bad-argument" ? `${field}: ${value}` : `${code}: ${subject}`);
  });
  return { words, faults };
}

const finding = (code: string, value = 80): PrintFinding =>
  ({
    code,
    value,
    limit: 150,
    zone: "front",
    layer: "a",
    message: "English.",
    hint: "Do.",
    characters: ["ю"],
  }) as PrintFinding;

/** Every word of an object of words, by its path: texts as they are, others by their results for made-up values. */
function told(words: object, path = ""): [string, string][] {
  return Object.entries(words).flatMap(([key, value]): [string, string][] => {
    if (["language", "lang", "told", "finding", "own"].includes(key)) return [];
    if (typeof value === "string") return [[path + key, value]];
    if (typeof value === "function") return [[path + key, value("7", "9")]];
    return told(value, `${path}${key}.`);
  });
}

describe("a shop's own words", () => {
  it("stand in the places of the element's, and the others stay", async () => {
    const { words, faults } = await applied({ submit: "Add to cart", kinds: { decal: "Photo" } });
    expect(faults).toEqual([]);
    expect(words).toMatchObject({ submit: "Add to cart", kinds: { decal: "Photo", text: "Text" }, undo: "Undo" });
    expect(words.full(3)).toBe(english.full(3));
  });

  it("stand in the places of another language's likewise", async () => {
    const { words } = await applied({ submit: "In den Korb" }, german);
    expect([words.submit, words.undo, words.lang]).toEqual(["In den Korb", "Rückgängig", "de"]);
  });

  it("have what is told in their places, in any order", async () => {
    const { words } = await applied({ remove: "{name}: weg", errors: { zoneMaterial: "{material} fehlt „{zone}“" } });
    expect([words.remove("Logo"), words.errors.zoneMaterial("front", 3)]).toEqual(["Logo: weg", "3 fehlt „front“"]);
    // What is told is not looked through for places once more.
    expect(words.remove("{name}")).toBe("{name}: weg");
  });

  it("are counted by the plurals of their language", async () => {
    const forms = { one: "{count} rzecz", few: "{count} rzeczy", many: "{count} spraw", other: "{count} sprawy" };
    const { words } = await applied({ lang: "pl", printIssues: forms });
    expect([1, 3, 5].map((count) => words.printIssues(count))).toEqual(["1 rzecz", "3 rzeczy", "5 spraw"]);
  });

  it("have the decimal sign of their language", async () => {
    const { words } = await applied({ lang: "fr", area: "{value} cm²" });
    expect([words.area("12.5"), words.lang]).toEqual(["12,5 cm²", "fr"]);
    expect((await applied({ area: "{value} cm²" })).words.area("12.5")).toBe("12.5 cm²");
  });

  it("say what the printer would, where it is grave otherwise if that is given", async () => {
    const { words } = await applied({
      findings: {
        "low-dpi": { message: "{value} de {limit}", hint: "Plus grand.", grave: { message: "Flou à {value}" } },
        "missing-characters": { message: "{characters} manque" },
      },
    });
    expect(words.finding(finding("low-dpi"), false)).toEqual({ message: "80 de 150", hint: "Plus grand." });
    expect(words.finding(finding("low-dpi"), true)).toEqual({ message: "Flou à 80", hint: "Plus grand." });
    expect(words.finding(finding("missing-characters"), true)).toEqual({ message: "ю manque", hint: "Do." });
    expect(words.finding(finding("hidden"), true)).toEqual({ message: "English.", hint: "Do." });
  });

  it("say what went wrong by its code, and by its reason first", async () => {
    const { words } = await applied({
      told: {
        "bad-picture": { message: "Pas d’image : {name}", hint: "PNG." },
        "bad-picture/cmyk": { message: "CMJN : {name}" },
      },
    });
    const error = (reason: string) =>
      new TexelcastError("bad-picture", "English.", { subject: "a.png", reason, hint: "Do." }).toJSON();
    expect(words.told(error("gif"))).toEqual({ message: "Pas d’image : a.png", hint: "PNG." });
    expect(words.told(error("cmyk"))).toEqual({ message: "CMJN : a.png", hint: "PNG." });
    expect(words.told(new TexelcastError("too-large", "English.").toJSON()).message).toBe("English.");
  });

  it.each<[string, object, string]>([
    ["is not known", { sumbit: "x" }, "wording.sumbit: x"],
    ["is not known, deeper", { announce: { wow: "x" } }, "wording.announce.wow: x"],
    ["is no text", { submit: 3 }, "wording.submit: 3"],
    ["has a place that nothing is told in", { remove: "{nmae}" }, "wording.remove: {nmae}"],
    ["has a plural without the general one", { full: { one: "x" } }, "wording.full: object"],
    ["is a plural of no text", { full: { one: 1, other: "x" } }, "wording.full.one: 1"],
    ["is one text for several", { announce: "x" }, "wording.announce: x"],
    ["is several for one text", { submit: { a: "x" } }, "wording.submit: object"],
    ["is in no language", { lang: "no language" }, "wording.lang: no language"],
    ["is a finding of no texts", { findings: { hidden: "x" } }, "wording.findings.hidden: x"],
    ["is a table of none", { told: ["x"] }, "wording.told: object"],
    ["has three ways", { ways: ["a", "b", "c"] }, "wording.ways: object"],
    ["is the element's own affair", { language: "de" }, "wording.language: de"],
    ["is inherited by all objects", JSON.parse('{"__proto__": "x", "constructor": "x"}'), "wording.__proto__: x"],
  ])("of which one %s are told of it by its path, and the others are taken", async (_, wrong, fault) => {
    const { words, faults } = await applied({ undo: "Zurück", ...wrong });
    expect(faults[0]).toBe(fault);
    expect([words.undo, words.submit, words.announce.undone]).toEqual(["Zurück", "Done", "Undone"]);
    expect(words.remove("a")).toBe(english.remove("a"));
  });

  it("of which one is not known are told with all that there are", async () => {
    const hints: unknown[] = [];
    await worded(english, { sumbit: "x" }, (error) => hints.push((error as TexelcastError).hint));
    const own = new Set(Object.keys(english));
    for (const fixed of ["language", "finding"]) own.delete(fixed);
    for (const more of ["lang", "findings", "told", "nowhere", "noFont", "noGraphics", "ways"]) own.add(more);
    expect(hints).toHaveLength(1);
    expect(
      new Set(
        String(hints[0])
          .replace(/^It is one of: |\.$/g, "")
          .split(", "),
      ),
    ).toEqual(own);
  });

  it.each([3, [], null, "nowhere.json"])("that are none (%j) are told, and the element's stay", async (given) => {
    vi.stubGlobal("fetch", () => Promise.reject(new TypeError("Failed to fetch")));
    const { words, faults } = await applied(given);
    expect(words).toBe(english);
    expect(faults).toHaveLength(1);
  });

  it.each<[string, Response]>([
    ["is not there", new Response("", { status: 404 })],
    ["is no JSON", new Response("<html>")],
  ])("at an address where it %s are told, and the element's stay", async (_, response) => {
    vi.stubGlobal("fetch", () => Promise.resolve(response));
    expect(await applied("/fr.json")).toEqual({ words: english, faults: ["missing-file: http://shop/fr.json"] });
  });

  it("are read from their address", async () => {
    vi.stubGlobal("fetch", () => Promise.resolve(Response.json({ submit: "Fertig" })));
    expect((await applied("/own.json")).words.submit).toBe("Fertig");
  });

  beforeEach(() => {
    vi.stubGlobal("document", { baseURI: "http://shop/" });
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });
});

describe.each(SHIPPED)("the words in %s that come along", (language) => {
  it("are taken, every one", async () => {
    const { words, faults } = await applied(shipped(language));
    expect(faults).toEqual([]);
    expect(words.lang).toBe(language);
    const own = told(words);
    // Signs are the same in all of these languages, and a few words are.
    const same = own.filter(([path, word]) => word === new Map(told(english)).get(path)).map(([, word]) => word);
    expect(same.filter((word) => word.length > 5)).toEqual([]);
    expect(own.map(([path]) => path)).toEqual(told(english).map(([path]) => path));
    // What is told is told in each.
    const places = (word: string): string => [...word.matchAll(/[79]/g)].sort().join();
    expect(own.map(([path, word]) => [path, places(word)])).toEqual(
      told(english).map(([path, word]) => [path, places(word)]),
    );
  });

  it("say all that a printer and the reader of a file may find", async () => {
    const { words } = await applied(shipped(language));
    const source = readFileSync("web/engine/print-report.ts", "utf8");
    const codes = [
      ...source.slice(0, source.indexOf("export interface PrintFinding ")).matchAll(/^ {2}\| "([a-z-]+)"/gm),
    ];
    expect(codes.length).toBeGreaterThan(10);
    for (const [, code = ""] of codes) {
      for (const grave of [false, true]) {
        const { message, hint } = words.finding(finding(code), grave);
        expect([code, message, hint].join()).not.toMatch(/English|Do\./);
      }
    }
    for (const code of [
      "bad-picture",
      "bad-font",
      "too-large",
      "unsafe-file",
      "missing-file",
      "unsupported",
      "internal",
    ]) {
      expect(words.told(new TexelcastError(code, "English.").toJSON()).message).not.toMatch(/English/);
    }
    const { nowhere, noFont, noGraphics, ways } = words.own ?? {};
    expect([nowhere?.message, noFont?.message, noGraphics?.message, ...(ways ?? [])].filter(Boolean)).toHaveLength(7);
  });
});

import { describe, expect, it } from "vitest";
import { languageFor } from "../../web/editor/strings/language.ts";
import { german } from "../../web/editor/strings.de.ts";
import { stringsIn } from "../../web/editor/strings.ts";

const strings = stringsIn("en");

describe("the page's language", () => {
  const wishes = { search: "", kept: null, preferred: [] };

  it("is what the address asks for, else what was chosen, else the first that the browser prefers and the page speaks", () => {
    expect(languageFor({ search: "?lang=de", kept: "en", preferred: ["en-GB"] })).toBe("de");
    expect(languageFor({ ...wishes, kept: "de", preferred: ["en"] })).toBe("de");
    expect(languageFor({ ...wishes, preferred: ["fr-FR", "de-AT", "en"] })).toBe("de");
  });

  it("is English where none of the wishes is spoken, whatever they are called", () => {
    expect(languageFor({ search: "?lang=toString", kept: "constructor", preferred: ["fr"] })).toBe("en");
    expect(languageFor(wishes)).toBe("en");
  });

  it("German writes sizes with a comma", () => {
    expect([german.history.megabytes("0.2"), german.projects.megabytes("12")]).toEqual(["0,2 MB", "12 MB"]);
  });

  it("German lists as many keys and first steps as English, and leaves no text empty that English has", () => {
    const counts = ({ help }: typeof strings): number[] => help.keyGroups.map(({ keys }) => keys.length);
    expect(counts(german)).toEqual(counts(strings));
    expect(german.hint.steps).toHaveLength(strings.hint.steps.length);
    const empty = (words: object, path: string): string[] =>
      Object.entries(words).flatMap(([key, value]) =>
        typeof value === "object" ? empty(value, `${path}.${key}`) : value === "" ? [`${path}.${key}`] : [],
      );
    expect(empty(german, "")).toEqual(empty(strings, ""));
  });
});

import { describe, expect, it } from "vitest";
import type { TexelcastError } from "../../web/core/texelcast-error.ts";
import { exportAsAsked } from "../../web/element/desk/check-print.ts";
import { exportModel } from "../../web/element/desk/export-model.ts";
import { addPicture } from "../../web/element/desk/placing.ts";
import { takeSnapshots } from "../../web/element/desk/snapshots.ts";
import { Texts } from "../../web/element/desk/texts.ts";
import type { AtDesk } from "../../web/element/mode.ts";
import { english } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";

const materials = [
  { index: 0, refusal: null },
  { index: 1, refusal: { code: "NO_UVS", message: "" } },
];
const zones = { zones: [{ id: "front", material: 0 }] };

/** A desk whose engine gives back what it is asked to print. */
function deskIn(words = english, more: object = { zones }): AtDesk {
  const desk = {
    material: 0,
    settings: { words, size: 512 },
    store: { state: { model: { info: { materials } } } },
    engine: { exportPrint: async (options: unknown) => options },
    checkRoom: () => undefined,
    ...more,
  };
  return { desk, idle: async () => undefined } as unknown as AtDesk;
}

const wrong: [what: string, options: unknown, field: string, value: string, hint: RegExp][] = [
  ["no options", null, "options", "null", /size/],
  ["a size in options' place", 64, "options", "64", /size/],
  ["a size of text", { size: "64" }, "size", '"64"', /1 – 16384/],
  ["a size of half texels", { size: 10.5 }, "size", "10.5", /1 – 16384/],
  ["a size of three sides", { size: [1, 2, 3] }, "size", "[1, 2, 3]", /\[2048, 1024\]/],
  ["a size of one side as text", { size: [64, "64"] }, "size", '[64, "64"]', /\[2048, 1024\]/],
  ["a size that is no number", { size: Number.NaN }, "size", "NaN", /1 – 16384/],
  ["DPI of text", { dpi: "300" }, "dpi", '"300"', /1 – 10000/],
  ["a material by name", { material: "body" }, "material", '"body"', /0/],
  ["a material that is not there", { material: 7 }, "material", "7", /0/],
  ["a material that cannot be painted", { material: 1 }, "material", "1", /0/],
  ["flattening by a word", { zone: "front", flattened: "yes" }, "flattened", '"yes"', /true, false/],
  ["a zone that is not there", { zone: "back" }, "zone", '"back"', /"front"/],
  ["flat art of no zone", { flattened: true }, "flattened", "true", /"front"/],
  ["another base", { base: "white" }, "base", '"white"', /"none"/],
];
const typos: [what: string, options: object, field: string, value: string][] = [
  ["a slip of the pen", { dip: 300 }, "dip", "300"],
  ["a format that is not to be chosen", { format: "jpeg" }, "format", '"jpeg"'],
  ["a function", { done: () => undefined }, "done", "a function"],
  ["what objects have of their own", { toString: 1 }, "toString", "1"],
];

describe("a print that a page asks the element for", () => {
  it.each(wrong)("is refused for %s, in the element's words", async (_what, options, field, value, hint) => {
    for (const words of [english, german]) {
      await expect(exportAsAsked(deskIn(words), options as object)).rejects.toMatchObject({
        code: "bad-argument",
        message: words.errors.badOption(field),
        ...{ field, value },
        hint: expect.stringMatching(hint),
      });
    }
  });

  it.each(typos)(
    "is refused for %s, which is no option, with those that there are",
    async (_, options, field, value) => {
      for (const words of [english, german]) {
        const error = await exportAsAsked(deskIn(words), options).catch((thrown: unknown) => thrown);
        expect(error).toMatchObject({ code: "bad-argument", field, value });
        const { message, hint } = error as TexelcastError;
        expect(message).toContain(field);
        expect(hint).toMatch(/material, size, dpi, zone, flattened, base/);
        expect(message.startsWith("There is")).toBe(words === english);
      }
    },
  );

  it("is refused for DPI beside a size, and takes both of flat art", async () => {
    for (const words of [english, german]) {
      const both = { size: 64, dpi: 300 };
      const error = await exportAsAsked(deskIn(words), both).catch((thrown: unknown) => thrown);
      expect(error).toMatchObject({ code: "bad-argument", field: "dpi", value: "300" });
      const { message, hint } = error as TexelcastError;
      expect(message).toContain("300 DPI");
      expect(hint).toMatch(/size.*dpi.*flattened/);
      expect(message.startsWith("A print")).toBe(words === english);
      const art = { ...both, zone: "front", flattened: true };
      await expect(exportAsAsked(deskIn(words), art)).resolves.toEqual(art);
    }
  });

  it("names no zone where the product has none", async () => {
    await expect(exportAsAsked(deskIn(english, { zones: null }), { zone: "back" })).rejects.toMatchObject({
      code: "bad-argument",
      field: "zone",
    });
  });

  it("takes of the page's object the options that are said, with what the element says for the others", async () => {
    const options = { size: [64, 32] as const, zone: "front", dpi: undefined, dip: undefined };
    await expect(exportAsAsked(deskIn(), options as object)).resolves.toEqual({ size: [64, 32], zone: "front" });
    await expect(exportAsAsked(deskIn(), {})).resolves.toEqual({ size: 512, material: 0 });
  });
});

describe("a model that a page asks the element for", () => {
  it.each<[string, unknown, string, string]>([
    ["no options", null, "options", "null"],
    ["a format in options' place", "usdz", "options", "usdz"],
    ["a format that there is not", { format: "obj" }, "format", "obj"],
  ])("is refused for %s, in the element's words", async (_what, options, field, value) => {
    for (const words of [english, german]) {
      await expect(exportModel(deskIn(words), options as object)).rejects.toMatchObject({
        code: "bad-argument",
        message: words.errors.badOption(field),
        ...{ field, value },
        hint: expect.stringMatching(/format|usdz/),
      });
    }
  });
});

describe("a snapshot that a page asks the element for", () => {
  it.each<[string, unknown, unknown, string]>([
    ["a width of text", ["front"], { width: "512" }, "width"],
    ["no height", ["front"], { height: 0 }, "height"],
    ["no options", ["front"], null, "options"],
    ["no views", null, {}, "view"],
    ["a view that is a number", [3], {}, "view"],
    ["a side that there is not", ["frnt"], {}, "view"],
  ])("is refused for %s, in the element's words", async (_what, views, options, field) => {
    const mode = {} as Parameters<typeof takeSnapshots>[0];
    await expect(takeSnapshots(mode, views as never, options as never, german)).rejects.toMatchObject({
      code: "bad-argument",
      message: german.errors.badOption(field),
      field,
      hint: expect.stringMatching(/\S/),
    });
  });

  it("is refused for an option that there is not, with those that there are", async () => {
    const asked = takeSnapshots({} as never, ["front"], { widht: 64 } as object, english);
    await expect(asked).rejects.toMatchObject({
      code: "bad-argument",
      field: "widht",
      hint: "There are width, height.",
    });
  });
});

describe("a new picture or text that a page asks the element for", () => {
  const subjects = {
    decal: (options: unknown, words = english) => addPicture(deskIn(words).desk, new Uint8Array(), options as never),
    text: (options: unknown, words = english) => new Texts(deskIn(words).desk).add("Hi", options as never),
  };

  it.each<["decal" | "text", string, unknown, string, string, RegExp]>([
    ["decal", "a slip of the pen", { widht: 0.1 }, "widht", "0.1", /name, projector, position, width, material/],
    ["decal", "a text's option", { color: "#ff0000" }, "color", "#ff0000", /width, material\.$/],
    ["text", "a slip of the pen", { colour: "#ff0000" }, "colour", "#ff0000", /font, color, curve/],
    ["decal", "a width of text", { width: "0.1" }, "width", "0.1", /0\.000001 – 1000000/],
    ["text", "a width of text", { width: "0.1" }, "width", "0.1", /0\.000001 – 1000000/],
    ["decal", "no options", null, "options", "null", /width/],
    ["text", "a font that is a number", { font: 3 }, "font", "3", /inter-700/],
  ])("is refused, a %s, for %s, with what to do about it", async (kind, _what, options, field, value, hint) => {
    for (const words of [english, german]) {
      await expect(subjects[kind](options, words)).rejects.toMatchObject({
        code: "bad-argument",
        message: expect.stringContaining(field),
        ...{ field, value },
        hint: expect.stringMatching(hint),
      });
    }
  });

  it("is refused for what is no picture and for no words, with what to do about it", async () => {
    const { desk } = deskIn();
    const noPicture = addPicture(desk, { width: "0.1" } as never);
    await expect(noPicture).rejects.toMatchObject({ field: "source", hint: expect.stringMatching(/Blob/) });
    for (const text of [" ", undefined, 7]) {
      const noWords = new Texts(desk).add(text as never);
      await expect(noWords).rejects.toMatchObject({ field: "text", value: String(text), hint: "1 – 10000" });
    }
  });
});

import { describe, expect, it } from "vitest";
import { exportAsAsked } from "../../web/element/desk/check-print.ts";
import { takeSnapshots } from "../../web/element/desk/snapshots.ts";
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

  it("names no zone where the product has none", async () => {
    await expect(exportAsAsked(deskIn(english, { zones: null }), { zone: "back" })).rejects.toMatchObject({
      code: "bad-argument",
      field: "zone",
    });
  });

  it("takes of the page's object the options alone, with what the element says for the others", async () => {
    const options = { size: [64, 32] as const, zone: "front", dpi: undefined, done: () => undefined };
    await expect(exportAsAsked(deskIn(), options as object)).resolves.toEqual({ size: [64, 32], zone: "front" });
    await expect(exportAsAsked(deskIn(), {})).resolves.toEqual({ size: 512, material: 0 });
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
});

import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { noticeOf } from "../../web/editor/state/notices.ts";
import { germanError } from "../../web/editor/strings/german-errors.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { typedError } from "../../web/element/element-errors.ts";
import { english } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";

const FLAT = new TexelcastError("no-uvs", "The material has no texture coordinates.", { subject: "fox.glb" });
const BROKEN = new TexelcastError("bad-design", 'layers[0].opacity: must be a number, is "x"', {
  subject: "mug.design.json",
  field: "layers[0].opacity",
  value: '"x"',
});

describe("what the engine reports", () => {
  it("is said in the language of the editor, with file, field and value beside it", () => {
    const { message, where, hint } = noticeOf(1, "mug.design.json ließ sich nicht öffnen", BROKEN, stringsIn("de"));
    expect(message).toMatch(/^„mug\.design\.json“ lässt sich nicht öffnen\. Genauer: layers\[0\]\.opacity/);
    expect(where).toBe('layers[0].opacity · Wert "x"');
    expect(hint).toContain("docs/design-document.md");
    expect(noticeOf(1, "Could not open it", FLAT, stringsIn("en")).message).toBe(FLAT.message);
  });

  it("keeps its own words where a code has none, and where the editor has said it already", () => {
    const rare = new TexelcastError("bad-argument", "The gutter is 99.", { hint: "At most 64." });
    expect(germanError(rare.toJSON())).toEqual({ message: "The gutter is 99.", hint: "At most 64." });
    const said = new TexelcastError("missing-file", "Das Projekt hat kein Modell.", { subject: "x.texelcast" });
    expect(germanError(said.toJSON()).message).toBe("Das Projekt hat kein Modell.");
  });

  it("reaches an element's page in the element's language, once, with its code and the first error as its cause", () => {
    const told = typedError(FLAT, german);
    expect(told).toMatchObject({ code: "no-uvs", subject: "fox.glb", cause: FLAT });
    expect(told.message).toMatch(/^„fox\.glb“ hat keine Texturkoordinaten/);
    expect(typedError(told, german)).toBe(told);
    expect(typedError(FLAT, english)).toBe(FLAT);
    const hidden = { code: "low-dpi", layer: "a", zone: null, message: "Only 31 DPI", hint: "", value: 31, limit: 150 };
    expect(german.finding(hidden as Parameters<typeof german.finding>[0], true).message).toContain("Nur 31 DPI");
  });
});

describe("what comes with the page", () => {
  it("has German names: templates, decals, and the parts that a model's texture names", () => {
    const { named } = stringsIn("de");
    expect(["Mug", "Left arm", "front"].map(named)).toEqual(["Tasse", "Linker Arm", "vorn"]);
    expect(named("My own part")).toBe("My own part");
    expect(named("constructor")).toBe("constructor");
    expect(stringsIn("en").named("Mug")).toBe("Mug");
  });
});

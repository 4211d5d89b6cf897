import { readdirSync, readFileSync } from "node:fs";
import { strToU8, zipSync } from "fflate";
import { describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { readProjectFile } from "../../web/editor/document/project-file.ts";
import { fetchBytes } from "../../web/editor/files/demo-catalogue.ts";
import { noticeOf } from "../../web/editor/state/notices.ts";
import { germanError } from "../../web/editor/strings/german-errors.ts";
import { ARGUMENTS, BROWSERS, FONTS, PICTURES } from "../../web/editor/strings/german-reasons.ts";
import { ToldError } from "../../web/editor/strings/told-error.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { sentence } from "../../web/editor/ui/sentence.ts";
import { typedError } from "../../web/element/element-errors.ts";
import { english } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";
import { readFontHeader } from "../../web/engine/font-file.ts";
import { readPictureHeader } from "../../web/engine/picture-header.ts";
import { unzipModel } from "../../web/engine/zipped-model.ts";
import { brokenOff } from "../support/broken-off.ts";

const FLAT = new TexelcastError("no-uvs", "The material has no texture coordinates.", { subject: "fox.glb" });
const BROKEN = new TexelcastError("bad-design", 'layers[0].opacity: must be a number, is "x"', {
  subject: "mug.design.json",
  field: "layers[0].opacity",
  value: '"x"',
});

const BARE = { field: "zone", value: "front" };

function thrownBy(work: () => unknown): TexelcastError {
  try {
    work();
  } catch (thrown) {
    if (thrown instanceof TexelcastError) return thrown;
  }
  throw new Error("It threw no TexelcastError.");
}

describe("what the engine reports", () => {
  it("tells a project of a newer version from one that is damaged", () => {
    const manifest = strToU8(JSON.stringify({ format: "texelcast-project", version: 2 }));
    const newer = thrownBy(() => readProjectFile(zipSync({ "project.json": manifest }), "cup.texelcast"));
    expect(germanError(newer)).toMatchObject({
      message: "„cup.texelcast“ hat die Version 2, die hier nicht gelesen wird.",
      hint: "Prüfe die Verbindung und lade die Seite neu.",
    });
    const cut = thrownBy(() => readProjectFile(new Uint8Array(9), "cup.texelcast"));
    expect(germanError(cut).message).toBe("„cup.texelcast“ ist beschädigt oder kein Projekt.");
  });

  it("is said in the language of the editor, with file, field and value beside it", () => {
    const { message, where, hint, exact } = noticeOf(
      1,
      "mug.design.json ließ sich nicht öffnen",
      BROKEN,
      stringsIn("de"),
    );
    expect(message).toBe("Im Design „mug.design.json“ steht bei layers[0].opacity nicht, was dort stehen muss.");
    expect(exact).toBe(BROKEN.message);
    expect(where).toBe('layers[0].opacity · Wert "x"');
    expect(hint).toContain("docs/design-document.md");
    expect(noticeOf(1, "Could not open it", FLAT, stringsIn("en")).message).toBe(FLAT.message);
  });

  it("is never said in English beside German, and what the editor says itself is said once", () => {
    const rare = new TexelcastError("bad-argument", "The gutter is 99.", { hint: "At most 64." });
    expect(noticeOf(1, "Es ging nicht", rare, stringsIn("de"))).toMatchObject({
      message: "Das geht hier nicht.",
      hint: "",
      exact: "The gutter is 99.",
    });
    const thrown = noticeOf(1, "Es ging nicht", new TypeError("x is undefined"), stringsIn("de"));
    expect(thrown.message).toBe("In der Seite ist ein Fehler aufgetreten.");
    const noWebGl = new TexelcastError("unsupported", "This browser cannot show 3D.", { reason: "no-webgl" });
    expect(germanError(noWebGl.toJSON()).message).toMatch(/^Dieser Browser kann kein 3D zeigen/);
    const said = new ToldError("missing-file", "Das Projekt hat kein Modell.", { subject: "x.texelcast" });
    expect(noticeOf(1, "Es ging nicht", said, stringsIn("de")).message).toBe("Das Projekt hat kein Modell.");
  });

  it("says in German which of the faults of one code it is, as far as a picture's own bytes", async () => {
    const gif = await readPictureHeader(new TextEncoder().encode("GIF89a"), "cat.gif").then(
      () => new TexelcastError("taken", ""),
      (error: TexelcastError) => error,
    );
    expect(noticeOf(1, "", gif, stringsIn("de"))).toMatchObject({
      message: "„cat.gif“ ist kein Bild, das sich hier verwenden lässt. Es ist ein GIF.",
      hint: "Speichere es als PNG, JPEG, WebP oder AVIF.",
      exact: "",
    });
    expect(germanError(gif.toJSON()).message).toContain("Es ist ein GIF.");
    const which = thrownBy(() =>
      unzipModel({ name: "pack.zip", bytes: zipSync({ "a.glb": new Uint8Array(1), "b.glb": new Uint8Array(1) }) }),
    );
    expect(noticeOf(1, "", which, stringsIn("de"))).toMatchObject({
      message: "„pack.zip“ enthält mehrere Modelle.",
      exact: expect.stringContaining("“a.glb”, “b.glb”"),
    });
    const woff = thrownBy(() => readFontHeader(new TextEncoder().encode("wOF2"), "sans.woff2"));
    expect(noticeOf(1, "", woff, stringsIn("de")).message).toContain("Es ist eine Webschrift (WOFF).");
  });

  it("has German words for every code and every reason that what runs in the page can throw", () => {
    const sourcesOf = (room: string): string[] =>
      readdirSync(`web/${room}`, { encoding: "utf8", recursive: true })
        .filter((file) => file.endsWith(".ts"))
        .map((file) => readFileSync(`web/${room}/${file}`, "utf8"));
    const found = (rooms: readonly string[], pattern: RegExp): Set<string> =>
      new Set(rooms.flatMap(sourcesOf).flatMap((source) => [...source.matchAll(pattern)].map(([, what = ""]) => what)));
    const codes = found(
      ["core", "engine", "viewer", "editor"],
      /TexelcastError(?:\.wrap)?\(\s*(?:[\w.]+,\s*)?"([a-z-]+)"/g,
    );
    const reasons = found(
      ["core", "engine", "viewer", "editor/document"],
      /(?:bad(?:Picture|Font)\(\s*[\w.]+,|PictureFault\(|refusal\(|reason:|\[(?="[a-z0-9-]+", ["`]it ))\s*"([a-z0-9-]+)"(?=,)/g,
    );
    for (const [, name = ""] of readFileSync("wasm/texelcast.h", "utf8").matchAll(/^ +X\(([A-Z_]+), "/gm)) {
      codes.add(name.toLowerCase().replaceAll("_", "-"));
    }
    const told = (code: string, subject?: string): string =>
      noticeOf(1, "", new TexelcastError(code, "English.", subject === undefined ? {} : { subject }), stringsIn("de"))
        .message;
    const general = told("internal");
    // Told by no notice, or faults of the page itself, for which there is nothing else to say.
    const untold = ["ok", "pending", "stale-handle", "not-baked", "internal", "unexpected", "cancelled"];
    expect(codes.size).toBeGreaterThan(20);
    expect([...codes].filter((code) => told(code) === general && !untold.includes(code))).toEqual([]);
    expect([...codes].filter((code) => /English/.test(told(code) + told(code, "a.glb")))).toEqual([]);
    expect(reasons.size).toBeGreaterThan(30);
    const known = new Set([
      ...["not-loaded", "no-surface", "which-variant", "newer"],
      ...[PICTURES, FONTS, ARGUMENTS, BROWSERS].flatMap(Object.keys),
    ]);
    expect([...reasons].filter((reason) => !known.has(reason))).toEqual([]);
    expect([...known].filter((reason) => !reasons.has(reason))).toEqual([]);
  });

  it("reaches an element's page in the element's language, once, with its code and the first error as its cause, and in no browser's words", () => {
    const told = typedError(FLAT, german);
    expect(told).toMatchObject({ code: "no-uvs", subject: "fox.glb", cause: FLAT });
    expect(told.message).toMatch(/^„fox\.glb“ hat keine Texturkoordinaten/);
    expect(typedError(told, german)).toBe(told);
    expect(typedError(FLAT, english)).toBe(FLAT);
    const rare = new TexelcastError("bad-argument", "The gutter is 99.", { field: "gutter", hint: "At most 64." });
    expect(typedError(rare, german)).toMatchObject({ message: "Das geht hier nicht.", hint: "", field: "gutter" });
    const lost = new TypeError("Failed to fetch dynamically imported module: https://shop.example/assets/bench.js");
    for (const words of [english, german]) {
      const { message, hint = "", value } = typedError(lost, words);
      expect(message + hint).not.toContain("assets");
      expect(value).toBe(String(lost));
    }
    expect(typedError(lost, english).message).toBe("Something went wrong. Try again, or reload the page.");
    const own = new ToldError("bad-argument", german.errors.badOption("width"));
    expect(typedError(own, german)).toBe(own);
    const bare = new TexelcastError("bad-zones", "It has no surface.", { ...BARE, reason: "no-surface" });
    expect(typedError(bare, german).message).toBe("Die Zone „front“ hat keine Fläche zum Bedrucken.");
    const hidden = { code: "low-dpi", layer: "a", zone: null, message: "Only 31 DPI", hint: "", value: 31, limit: 150 };
    expect(german.finding(hidden as Parameters<typeof german.finding>[0], true).message).toContain("Nur 31 DPI");
  });
});

describe("a part of the page that cannot be fetched", () => {
  const GONE = [
    "Failed to fetch dynamically imported module: http://localhost/assets/png-encoder.js",
    "error loading dynamically imported module: http://localhost/assets/png-encoder.js",
    "Importing a module script failed.",
  ].map((words) => new TypeError(words));
  const inEngine = (error: Error): TexelcastError => new TexelcastError("internal", `The engine failed: ${error}`);

  it("is told in plain words, with what to do, whether the page or its engine asked for it", () => {
    for (const language of ["en", "de"] as const) {
      const { partMissing: message, partMissingHint: hint } = stringsIn(language).errors;
      for (const thrown of GONE.flatMap((error) => [error, inEngine(error)])) {
        const told = noticeOf(1, "", thrown, stringsIn(language));
        expect(told).toMatchObject({ code: "missing-file", message, hint, exact: "" });
      }
    }
  });

  it.each([
    ["could not be fetched", () => Promise.reject(new TypeError("Failed to fetch"))],
    ["broke off on its way", async () => brokenOff()],
  ])("has what to do beside it where it is an example that %s, too", async (_what, fetched) => {
    vi.stubGlobal("fetch", fetched);
    const thrown = await fetchBytes("demo/mug.glb", "http://localhost/").catch((error: unknown) => error);
    vi.unstubAllGlobals();
    expect(noticeOf(1, "", thrown, stringsIn("en"))).toMatchObject({
      message: "demo/mug.glb could not be fetched.",
      hint: stringsIn("en").errors.partMissingHint,
    });
  });

  it("is not what other faults are", () => {
    const { code, message } = noticeOf(1, "", inEngine(new TypeError("x is undefined")), stringsIn("en"));
    expect([code, message]).toEqual(["internal", "The engine failed: TypeError: x is undefined"]);
  });
});

describe("a sentence in a notice", () => {
  it("begins with a capital letter and ends with a full stop, but a file keeps its name", () => {
    expect(sentence("it was cut short")).toBe("It was cut short.");
    const { unknownFile } = stringsIn("en").errors;
    for (const name of ["i", "logo", "my logo", "i.txt"]) {
      expect(sentence(unknownFile(name), name)).toBe(unknownFile(name));
    }
  });

  it("knows the file that its notice is about", () => {
    const error = new ToldError("unsupported", stringsIn("en").errors.unknownFile("i"), { subject: "i" });
    expect(noticeOf(1, "Could not open i", error, stringsIn("en")).subject).toBe("i");
  });
});

describe("what the printer would say", () => {
  it("is said in German, whatever it is", () => {
    const source = readFileSync("web/engine/print-report.ts", "utf8");
    const union = /type PrintFindingCode =([\s\S]*?);\n/.exec(source)?.[1] ?? "";
    const codes = [...union.matchAll(/\| "([a-z-]+)"/g)].map(([, code]) => code);
    expect(codes).toHaveLength(12);
    for (const code of codes) {
      const finding = { code, layer: "a", zone: "front", message: "English", hint: "English", value: 1, limit: 2 };
      const { message, hint } = german.finding(finding as Parameters<typeof german.finding>[0], false);
      expect(message + hint).not.toContain("English");
    }
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

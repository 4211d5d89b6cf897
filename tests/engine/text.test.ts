import { beforeAll, describe, expect, it } from "vitest";
import type { EngineText, Picture } from "../../web/engine/engine-api.ts";
import { readFontHeader } from "../../web/engine/font-file.ts";
import { readShippedFont, SHIPPED_FONTS, type ShippedFontId } from "../../web/engine/shipped-fonts.ts";
import { renderSvg, startSvgRenderer } from "../../web/engine/svg-renderer.ts";
import { drawText, measureText } from "../../web/engine/text-drawing.ts";
import { FontShelf } from "../../web/engine/text-fonts.ts";
import { layOutText } from "../../web/engine/text-layout.ts";
import { fontsFor } from "../../web/engine/text-runs.ts";
import { compositeFont } from "../support/composite-font.ts";

const shelf = new FontShelf();

function words(text: string, more: Partial<EngineText> = {}): EngineText {
  return {
    text,
    font: "texelcast:fonts/inter-700",
    fontSize: 1,
    letterSpacing: 0,
    align: "center",
    curve: 0,
    color: [0, 0, 0, 1],
    outline: null,
    ...more,
  };
}

async function ready(text: EngineText): Promise<EngineText> {
  await shelf.load(text.font);
  for (const key of fontsFor(text.text, text.font, shelf)) await shelf.load(key);
  return text;
}

const pathOf = async (text: string, more: Partial<EngineText> = {}): Promise<string> =>
  layOutText(await ready(words(text, more)), shelf).path;

const measure = async (text: string, more: Partial<EngineText> = {}) =>
  measureText(await ready(words(text, more)), shelf);

async function draw(text: string, more: Partial<EngineText> = {}, width = 256, height = 128): Promise<Picture> {
  return renderSvg(drawText(await ready(words(text, more)), shelf, width, height, width / height), width);
}

/** The share of the pixels between two places across the picture (0 to 1) that are painted at all. */
function ink({ width, height, rgba }: Picture, from = 0, to = 1): number {
  let painted = 0;
  for (let y = 0; y < height; y++) {
    for (let x = Math.round(from * width); x < Math.round(to * width); x++) {
      if ((rgba[4 * (y * width + x) + 3] ?? 0) > 127) painted++;
    }
  }
  return painted / (width * height * (to - from));
}

beforeAll(startSvgRenderer);

describe("setting text", () => {
  it("puts a run of Hebrew from right to left, and Latin from left to right", async () => {
    // A wide letter beside a narrow one: the wide one's ink tells on which side it stands.
    const latin = await draw("Wl");
    expect(ink(latin, 0, 0.5)).toBeGreaterThan(ink(latin, 0.5, 1));
    const hebrew = await draw("שי");
    expect(ink(hebrew, 0.5, 1)).toBeGreaterThan(ink(hebrew, 0, 0.5));
  });

  it("orders a line that mixes both as the Unicode Bidirectional Algorithm asks", async () => {
    // Each part by itself has the outlines that it has in the whole, moved along: compared by their shapes, left to right.
    const shapes = (path: string): string[] => path.split("M").slice(1).map(shapeOf);
    const whole = shapes(await pathOf("אב, ab"));
    const [hebrew, latin] = [shapes(await pathOf("אב")), shapes(await pathOf("ab"))];
    expect(whole.slice(0, latin.length)).toEqual(latin);
    expect(whole.slice(-hebrew.length)).toEqual(hebrew);
  });

  it("does not take an emoji for a Latin letter: a line that begins with one goes as its words go", async () => {
    // Each letter here has another number of corners.
    const of = async (text: string): Promise<number[]> =>
      (await pathOf(text))
        .split("M")
        .slice(1)
        .map((contour) => shapeOf(contour).split(" ").length);
    const [smile, alef, bet, digits] = [await of("😀"), await of("א"), await of("ב"), await of("12")];
    expect(alef).not.toEqual(bet);
    // Right to left: the emoji that comes first stands on the right.
    expect(await of("😀 א")).toEqual([...alef, ...smile]);
    // And between two words of a direction it has that direction, as a space has.
    expect(await of("א 😀 12")).toEqual([...digits, ...smile, ...alef]);
    expect(await of("a א 😀 ב")).toEqual([...(await of("a")), ...bet, ...smile, ...alef]);
    // Flags are made of letters.
    expect(await of("🇩🇪 א")).toEqual([...(await of("🇩🇪")), ...alef]);
  });

  it("joins Arabic letters: two together are no longer the two apart", async () => {
    const joined = await measure("بب");
    const apart = await measure("ب ب");
    const one = await measure("ب");
    expect(joined.width).toBeLessThan(2 * one.width);
    expect(apart.width).toBeGreaterThan(2 * one.width);
    expect(await pathOf("بب")).not.toBe("");
  });

  it("writes é the same, be it one character or an e and a combining accent", async () => {
    expect(await pathOf("Caf\u0065\u0301")).toBe(await pathOf("Caf\u00e9"));
    // A mark for which there is no composed character sits on its letter and takes no room of its own.
    expect((await measure("x\u0301")).width).toBe((await measure("x")).width);
    expect(await pathOf("x\u0301")).not.toBe(await pathOf("x"));
  });

  it("shapes Devanagari: the vowel sign i stands before its letter, and conjuncts are one sign", async () => {
    expect((await measure("क्ष")).width).toBeLessThan((await measure("कष")).width);
    expect((await measure("क्षत्रिय")).missing).toEqual([]);
  });

  it.each([
    ["Marathi's eyelash ra", "र\u094d\u200dय", "noto-sans-devanagari-700"],
    ["a half letter before another", "क\u094d\u200dष", "noto-sans-devanagari-700"],
    ["an initial letter that stands alone", "ه\u200d", "noto-sans-arabic-700"],
    ["a word with a soft hyphen inside", "بب\u00adبب", "noto-sans-arabic-700"],
  ])("keeps %s as its joiners ask, be its font named or one that stands in", async (_, text, own) => {
    expect(await pathOf(text)).toBe(await pathOf(text, { font: `texelcast:fonts/${own}` }));
  });

  it("parts two numbers where a mark of direction stands between them", async () => {
    const font = "texelcast:fonts/noto-sans-hebrew-700";
    // Right to left the first number stands on the right; without the mark they are one number.
    const shapes = (path: string): string[] => path.split("M").slice(1).map(shapeOf);
    const apart = shapes(await pathOf("א 1\u200f7", { font }));
    const one = shapes(await pathOf("א 17", { font }));
    expect(apart.slice(0, 2)).toEqual(one.slice(0, 2).reverse());
    expect(apart[0]).not.toBe(apart[1]);
  });

  it("writes a ligature that is one character, as copied from a PDF, as the letters that it stands for", async () => {
    expect((await measure("ﬁne oﬀ")).missing).toEqual([]);
    for (const font of ["texelcast:fonts/inter-700", "texelcast:fonts/source-serif-4-400"]) {
      expect(await pathOf("ﬁ ﬂ ﬀ ﬃ ﬄ ﬆ", { font })).toBe(await pathOf("fi fl ff ffi ffl st", { font }));
    }
  });

  it.each([
    ["noto-sans-arabic-700", "أحمد ♥ سارة"],
    ["lobster-400", "مرحبا → ½"],
    ["noto-sans-hebrew-400", "★ № שלום"],
    ["noto-sans-devanagari-700", "नमस्ते ± ❤️"],
  ])(
    "has signs that all scripts share from Inter where neither the font nor its script's has them: %s, %s",
    async (font, text) => {
      expect((await measure(text, { font: `texelcast:fonts/${font}` })).missing).toEqual([]);
    },
  );

  it("names the characters that no font has, each once, and draws a sign for them", async () => {
    expect((await measure("a𓀀b𓀀漢")).missing).toEqual(["𓀀", "漢"]);
    expect((await measure("Ada\u200d \u00a0")).missing).toEqual([]);
    expect((await measure("a𓀀")).width).toBeGreaterThan((await measure("a")).width);
  });

  it("has a picture in one colour for every emoji, as large as letters", async () => {
    for (const text of ["😀", "🎂", "☃", "⚽", "1️⃣", "🇩🇪", "👍🏽", "👩‍🚀", "🏳️‍🌈", "❤️‍🔥", "🏴󠁧󠁢󠁳󠁣󠁴󠁿"]) {
      const { missing, width } = await measure(text, { font: "texelcast:fonts/lobster-400" });
      expect(missing, text).toEqual([]);
      expect(width, text).toBeGreaterThan(0.8);
      expect(width, text).toBeLessThan(1.6);
    }
    const { rgba } = await draw("🎂", { color: [1, 0, 0, 1] });
    for (let i = 0; i < rgba.length; i += 4) expect([rgba[i + 1], rgba[i + 2]]).toEqual([0, 0]);
  });

  it.each([
    ["a flag's two letters", "🇫🇷"],
    ["a keycap", "#️⃣"],
    ["a profession", "👩‍🚒"],
    ["a family that hearts join", "👩‍❤️‍👩"],
    ["a tone of skin", "👋🏿"],
    ["a heart on fire", "❤️‍🔥"],
  ])("makes one sign of %s, also between letters and from right to left", async (_, text) => {
    expect((await measure(text)).width).toBeLessThan(1.6);
    // Twice: two signs, and not one of all.
    expect((await measure(text + text)).width).toBeCloseTo(2 * (await measure(text)).width, 6);
    for (const around of ["ab", "אב"]) {
      const [alone, within] = [await measure(text), await measure(around + text)];
      expect(within.width).toBeLessThan((await measure(around)).width + alone.width + 0.2);
      expect(within.missing).toEqual([]);
    }
  });

  it("leaves signs that letters' fonts have to them, be they emoji too", async () => {
    const [inter, lobster] = ["texelcast:fonts/inter-400", "texelcast:fonts/lobster-400"];
    for (const font of [inter, lobster]) await shelf.load(font);
    for (const text of ["©", "♥", "★", "❤️", "☀", "7"]) {
      expect(fontsFor(text, inter, shelf), text).toEqual([inter]);
      expect(fontsFor(text, lobster, shelf), text).not.toContain("texelcast:fonts/noto-emoji-400");
    }
    // Where the text's own font lacks them, Inter stands in.
    expect(fontsFor("★", lobster, shelf)).toContain(inter);
  });

  it("sets letters apart, but not those that hang together, and no space behind the last", async () => {
    const [tight, wide] = [await measure("AB"), await measure("AB", { letterSpacing: 0.5 })];
    expect(wide.width - tight.width).toBeCloseTo(0.5, 2);
    expect((await measure("ببب", { letterSpacing: 0.5 })).width).toBe((await measure("ببب")).width);
  });

  it("stacks lines, and aligns the shorter ones", async () => {
    const one = await measure("wide line");
    const two = await measure("wide line\ni");
    expect(two.width).toBe(one.width);
    expect(two.height).toBeGreaterThan(1.8 * one.height);
    const [left, right] = [await draw("WWW\nWl", { align: "left" }), await draw("WWW\nWl", { align: "right" })];
    expect(left.rgba).not.toEqual(right.rgba);
    // Windows' and old Mac's line ends count as one.
    expect(await pathOf("a\r\nb")).toBe(await pathOf("a\nb"));
  });

  it("bends a line up into an arch and down into a bowl", async () => {
    const straight = await measure("curved text");
    const arch = await measure("curved text", { curve: 180 });
    expect(arch.width).toBeLessThan(straight.width);
    expect(arch.height).toBeGreaterThan(1.8 * straight.height);
    const [up, down] = [await draw("curved text", { curve: 150 }), await draw("curved text", { curve: -150 })];
    const lowerHalf = ({ width, height, rgba }: Picture): Picture => ({
      width,
      height: height / 2,
      rgba: rgba.subarray(2 * width * height),
    });
    // The middle of an arch lies high, that of a bowl low.
    expect(ink(lowerHalf(up), 0.45, 0.55)).toBe(0);
    expect(ink(lowerHalf(down), 0.45, 0.55)).toBeGreaterThan(0);
  });

  it("draws an outline round the letters, and makes room for it", async () => {
    const outline = { color: [1, 0, 0, 1], width: 0.1 } as const;
    const [plain, lined] = [await measure("Ada"), await measure("Ada", { outline })];
    expect(lined.width - plain.width).toBeCloseTo(0.2, 6);
    const { rgba } = await draw("Ada", { outline });
    let red = 0;
    let black = 0;
    for (let i = 0; i < rgba.length; i += 4) {
      if (rgba[i + 3] !== 255) continue;
      if (rgba[i] === 255) red++;
      if (rgba[i] === 0) black++;
    }
    expect(red).toBeGreaterThan(100);
    expect(black).toBeGreaterThan(100);
  });

  it("stays within its box: what would not fit is made smaller, and never pressed", async () => {
    const long = await draw("A very long name", { fontSize: 1 });
    expect(ink(long, 0, 1 / 256)).toBeLessThan(0.2);
    expect(ink(long)).toBeGreaterThan(0);
    const short = await draw("A", { fontSize: 0.5, align: "left" });
    expect(ink(short, 0.5, 1)).toBe(0);
  });

  it("takes characters that mean something in SVG as characters", async () => {
    const text = "<script>&amp;\"'</script>]]>";
    expect((await measure(text)).missing).toEqual([]);
    expect(ink(await draw(text))).toBeGreaterThan(0);
  });

  it("draws nothing for no words, without complaint", async () => {
    for (const text of ["", " ", "\n\n", "\u200d", "\u0007"]) expect(ink(await draw(text))).toBe(0);
  });

  it.each(Object.keys(SHIPPED_FONTS) as ShippedFontId[])("ships %s as a whole font file", async (id) => {
    const bytes = await readShippedFont(id);
    expect(readFontHeader(bytes, id).format).toBe("ttf");
    expect(ink(await draw("Aa", { font: `texelcast:fonts/${id}` }))).toBeGreaterThan(0);
  });
});

/** A contour's coordinates relative to its first point, rounded. */
function shapeOf(contour: string): string {
  const numbers = (contour.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);
  return numbers.map((value, index) => Math.round(value - (numbers[index % 2] ?? 0))).join(" ");
}

describe("fonts of the user's", () => {
  const refusal = async (bytes: Uint8Array) =>
    await new FontShelf().add("f", bytes, "my.ttf").then(
      () => undefined,
      (error: unknown) => error,
    );
  const ascii = (text: string): Uint8Array => new TextEncoder().encode(text.padEnd(64, "."));

  it("are taken in by what they hold, and tell their name", async () => {
    const own = new FontShelf();
    expect(await own.add("f", await readShippedFont("lobster-400"), "upload.bin")).toEqual({ name: "Lobster Regular" });
    expect(own.get("f")?.unitsPerEm).toBe(1000);
  });

  it.each([
    ["an empty file", new Uint8Array(0), "it is empty"],
    ["a web font", ascii("wOF2"), "it is a web font (WOFF)"],
    ["a collection", ascii("ttcf"), "it is a collection of several fonts"],
    ["a picture", ascii("\x89PNG"), "it is neither TrueType nor OpenType"],
    ["a header alone", ascii("OTTO"), "it ends too early, so it was cut short"],
  ])("are refused by name: %s", async (_what, bytes, problem) => {
    expect(await refusal(bytes)).toMatchObject({
      code: "bad-font",
      subject: "my.ttf",
      message: `The font “my.ttf” cannot be used: ${problem}.`,
    });
  });

  it("are refused when they were cut short", async () => {
    const whole = await readShippedFont("bebas-neue-400");
    expect(await refusal(whole.slice(0, whole.length - 100))).toMatchObject({ code: "bad-font" });
  });

  // Without “loca” nobody knows where an outline begins: every letter was drawn as nothing.
  it.each(["cmap", "loca", "glyf"])("are refused by name when they lack the table %s", async (table) => {
    const renamed = (await readShippedFont("inter-400")).slice();
    const at = new TextDecoder("latin1").decode(renamed.subarray(0, 400)).indexOf(table);
    renamed.set([0x78], at);
    expect(await refusal(renamed)).toMatchObject({
      code: "bad-font",
      message: `The font “my.ttf” cannot be used: it lacks the table “${table}”.`,
    });
  });

  it("whose letters are made of very many parts do not bring the engine down", async () => {
    const own = new FontShelf();
    await own.add("f", compositeFont(4, 10), "parts.ttf");
    await own.load("texelcast:fonts/inter-400");
    expect(layOutText(words("A", { font: "f" }), own).path.length).toBeGreaterThan(100_000);
    for (const measured of [layOutText, measureText]) {
      const tooMany = (): unknown => measured(words("A".repeat(10_000), { font: "f" }), own);
      expect(tooMany).toThrow(expect.objectContaining({ code: "bad-font" }));
      expect(tooMany).toThrow(/^“A{40}…” cannot be drawn: its letters have too many points/);
    }
  });

  it("that are damaged inside do not bring the engine down", async () => {
    const whole = await readShippedFont("bebas-neue-400");
    for (let seed = 1; seed <= 12; seed++) {
      const broken = whole.slice();
      for (let i = 0; i < 400; i++) broken[300 + ((i * 7919 * seed) % (broken.length - 300))] = (i * seed * 31) & 255;
      const own = new FontShelf();
      try {
        await own.add("f", broken, "broken.ttf");
      } catch (error) {
        expect(error).toMatchObject({ code: "bad-font" });
        continue;
      }
      await own.load("texelcast:fonts/inter-400");
      expect(layOutText(words("Ada", { font: "f" }), own).path.length).toBeLessThan(1e7);
    }
  });
});

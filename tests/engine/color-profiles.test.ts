import { deflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { power } from "../../web/engine/exact-power.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { readPictureHeader } from "../../web/engine/picture-header.ts";
import { checkUpload } from "../../web/engine/upload-check.ts";
import { type AvifPart, avifFile, box, gridData, makeAvif, partsOf, sizeBox } from "../support/avif-file.ts";
import { jpegOf, webpOf } from "../support/encoded-pictures.ts";
import {
  curves,
  greyProfile,
  iccChunk,
  jpegWith,
  makeProfile,
  PRIMARIES,
  rgbProfile,
  rowPng,
  SRGB_FORMULA,
  webpWith,
} from "../support/icc-profile.ts";
import { makePng } from "../support/png-file.ts";

const DISPLAY_P3 = rgbProfile(PRIMARIES.displayP3, SRGB_FORMULA, "Color LCD of Jane, serial 4711");
const ADOBE_RGB = rgbProfile(PRIMARIES.adobeRgb, curves.gamma(2.19921875));

/** sRGB's red, green, blue, a grey and white, as 8-bit numbers of Display P3 (CSS Color 4's own samples, rounded). */
const IN_P3 = [
  [234, 51, 35],
  [117, 251, 76],
  [0, 0, 245],
  [128, 128, 128],
  [255, 255, 255],
];
const PLAIN = [
  [255, 0, 0],
  [0, 255, 0],
  [0, 0, 255],
  [128, 128, 128],
  [255, 255, 255],
];

async function seen(bytes: Uint8Array): Promise<number[][]> {
  const { rgba } = await decodePicture(bytes, "photo", { asSeen: true });
  return Array.from({ length: rgba.length / 4 }, (_, i) => [...rgba.subarray(i * 4, i * 4 + 3)]);
}

/** A number of 8 bits stands for a colour to half a step, which in the dark comes to some steps of another channel. */
function expectNear(actual: number[][], expected: number[][], within = 1): void {
  const worst = Math.max(...actual.flat().map((value, i) => Math.abs(value - (expected.flat()[i] as number))));
  expect(worst, JSON.stringify(actual)).toBeLessThanOrEqual(within);
  expect(actual.length).toBe(expected.length);
}

const GREYS = Array.from({ length: 256 }, (_, i) => [i, i, i]);

describe("a picture with a colour profile", () => {
  it("of Display P3 is shown in the colours that were seen on the phone", async () => {
    expectNear(await seen(rowPng(IN_P3, [iccChunk(DISPLAY_P3)])), PLAIN, 3);
  });

  it("has colours beyond sRGB at its edge", async () => {
    const wide = [
      [255, 0, 0],
      [0, 255, 0],
      [0, 0, 255],
    ];
    expect(await seen(rowPng(wide, [iccChunk(DISPLAY_P3)]))).toEqual(wide);
  });

  it("of Adobe RGB is brightened to what it was", async () => {
    const inAdobe = [
      [219, 0, 0],
      [144, 255, 60],
      [127, 127, 127],
    ];
    const plain = [
      [255, 0, 0],
      [0, 255, 0],
      [128, 128, 128],
    ];
    expectNear(await seen(rowPng(inAdobe, [iccChunk(ADOBE_RGB)])), plain, 2);
  });

  it("keeps greys grey, and every grey of sRGB's curve as it is", async () => {
    expect(await seen(rowPng(GREYS, [iccChunk(DISPLAY_P3)]))).toEqual(GREYS);
  });

  it("keeps its alpha", async () => {
    const rows = [[234, 51, 35, 7, 234, 51, 35, 200]];
    const png = makePng({ width: 2, height: 1, bitDepth: 8, colorType: 6, rows, extra: [iccChunk(DISPLAY_P3)] });
    const { rgba } = await decodePicture(png, "p", { asSeen: true });
    expect([rgba[3], rgba[7], rgba[0]]).toEqual([7, 200, 255]);
  });

  it.each([
    ["a formula", SRGB_FORMULA],
    ["a table", curves.table(Array.from({ length: 1024 }, (_, i) => light(i / 1023)))],
  ])("of sRGB, its curve %s, keeps its numbers to the bit", async (_, curve) => {
    const colors = Array.from({ length: 500 }, (__, i) => [(i * 37) % 256, (i * 91) % 256, (i * 151) % 256]);
    const profile = rgbProfile(PRIMARIES.srgb, curve);
    expect(await seen(rowPng(colors, [iccChunk(profile)]))).toEqual(colors);
  });

  it.each<[string, number[], (step: number) => number]>([
    ["no formula", curves.linear, (x) => x],
    ["a power", curves.gamma(1.8), (x) => x ** (Math.round(1.8 * 256) / 256)],
    ["a table of two", curves.table([0, 1]), (x) => x],
    ["a formula of 1 number", curves.formula(0, 2.5), (x) => x ** 2.5],
    ["a formula of 3", curves.formula(1, 2, 1.25, -0.25), (x) => Math.max(1.25 * x - 0.25, 0) ** 2],
    ["a formula of 4", curves.formula(2, 2, 0.75, 0, 0.25), (x) => (0.75 * x) ** 2 + 0.25],
    [
      "a formula of 4, below its start",
      curves.formula(2, 2, 1.125, -0.25, 0.125),
      (x) => Math.max(1.125 * x - 0.25, 0) ** 2 + 0.125,
    ],
    ["a formula of 5", curves.formula(3, 3, 1, 0, 0.25, 0.5), (x) => (x >= 0.5 ? x ** 3 : 0.25 * x)],
    ["a formula of 7", curves.formula(4, 2, 0.5, 0, 0, 0, 0.25, 0), (x) => (0.5 * x) ** 2 + 0.25],
    [
      "a formula of 7, its line and its curve apart",
      curves.formula(4, 2, 0.75, 0.125, 0.25, 0.5, 0.125, 0.0625),
      (x) => (x >= 0.5 ? (0.75 * x + 0.125) ** 2 + 0.125 : 0.25 * x + 0.0625),
    ],
  ])("whose curve is %s is followed", async (_, curve, toLight) => {
    const shown = await seen(rowPng(GREYS, [iccChunk(rgbProfile(PRIMARIES.srgb, curve))]));
    const expected = GREYS.map(([step = 0]) => Math.round(encoded(toLight(step / 255)) * 255));
    // A fixed-point number of the profile is not quite the one of the formula.
    expectNear(
      shown,
      expected.map((step) => [step, step, step]),
    );
  });

  it("of grey is followed where the picture is grey", async () => {
    const profile = iccChunk(greyProfile(curves.gamma(1.8)));
    const [, , dark] = await seen(rowPng(GREYS.slice(98, 101), [profile]));
    expect(dark).toEqual(new Array(3).fill(Math.round(encoded((100 / 255) ** (461 / 256)) * 255)));
    expect(await seen(rowPng([[1, 2, 3], ...GREYS], [profile]))).toEqual([[1, 2, 3], ...GREYS]);
  });

  it("gives the same colours in JPEG, in one piece or several, as in PNG", async () => {
    const flat = new Uint8Array(16 * 16 * 4).map((_, i) => [234, 51, 35, 255][i % 4] as number);
    const jpeg = await jpegOf({ rgba: flat, width: 16, height: 16 }, 100);
    expectNear((await seen(jpeg)).slice(0, 1), [[234, 51, 35]], 2);
    for (const piece of [65_000, 100])
      expectNear((await seen(jpegWith(jpeg, DISPLAY_P3, piece))).slice(0, 1), [[255, 0, 0]], 8);
    // One piece of several is missing.
    const broken = jpegWith(jpeg, DISPLAY_P3, 100);
    broken[2 + 4 + 12] = 9;
    expect(await seen(broken)).toEqual(await seen(jpeg));
  });

  it("gives the same colours in WebP", async () => {
    const rgba = Uint8Array.from(IN_P3.flatMap((color) => [...color, 255]));
    const webp = await webpOf({ rgba, width: 5, height: 1 });
    const profiled = webpWith(webp, DISPLAY_P3, 5, 1);
    expect(await seen(webp)).toEqual(IN_P3);
    expectNear(await seen(profiled), PLAIN, 3);
    const { bytes } = await checkUpload("p.webp", profiled);
    expect(await seen(bytes)).toEqual(await seen(profiled));
    expect((await checkUpload("p.webp", bytes)).bytes).toEqual(bytes);
  });

  it("keeps it in an AVIF, of one picture and of tiles, and loses the screen's name", async () => {
    const rgba = Uint8Array.from(IN_P3.flatMap((color) => [...color, 255]));
    const [part] = partsOf(await avifFile({ width: 5, height: 1, rgba })) as [AvifPart];
    const green = Uint8Array.from({ length: 64 * 64 * 4 }, (_, i) => [40, 220, 90, 255][i % 4] ?? 0);
    const [tile] = partsOf(await avifFile({ width: 64, height: 64, rgba: green })) as [AvifPart];
    const profile = (icc: Uint8Array): Uint8Array => box("colr", Buffer.from("prof"), icc);
    const having = ({ properties = [], ...more }: AvifPart, ...boxes: Uint8Array[]): AvifPart => ({
      ...more,
      properties: [...properties, ...boxes],
    });
    const grid = {
      type: "grid",
      data: gridData(1, 1, 64, 64),
      references: { dimg: [2] },
      properties: [sizeBox(64, 64)],
    };
    for (const avif of [
      makeAvif({ parts: [having(part, profile(DISPLAY_P3))] }),
      makeAvif({ parts: [having(grid, profile(ADOBE_RGB)), tile] }),
    ]) {
      const { bytes } = await checkUpload("p.avif", avif);
      expect(Buffer.from(bytes).toString("latin1")).not.toMatch(/Jane|4711/);
      expect(await seen(bytes)).toEqual(await seen(avif));
      expect(textOf(bytes)).toContain("rXYZ");
      expect((await checkUpload("p.avif", bytes)).bytes).toEqual(bytes);
    }
    // A profile of sRGB goes before numbers that say otherwise, and they go with it.
    const srgb = makeAvif({
      parts: [
        having(
          { ...part, properties: (part.properties ?? []).filter((each) => textOf(each).slice(4, 8) !== "colr") },
          profile(rgbProfile(PRIMARIES.srgb, SRGB_FORMULA)),
          box("colr", Buffer.from("nclx"), [0, 12, 0, 13, 0, 0, 0x80]),
        ),
      ],
    });
    expect(await seen(srgb)).toEqual(IN_P3);
    const { bytes } = await checkUpload("p.avif", srgb);
    expect(textOf(bytes)).not.toContain("rXYZ");
    expect(await seen(bytes)).toEqual(IN_P3);
  });

  it("gives the same colours in AVIF, and by the numbers that it has in place of a profile", async () => {
    const rgba = Uint8Array.from(IN_P3.flatMap((color) => [...color, 255]));
    const [part] = partsOf(await avifFile({ width: 5, height: 1, rgba })) as [AvifPart];
    const having = (colr: Uint8Array): Uint8Array => {
      const others = (part.properties ?? []).filter((each) => Buffer.from(each).toString("latin1", 4, 8) !== "colr");
      return makeAvif({ parts: [{ ...part, properties: [...others, box("colr", colr)] }] });
    };
    const profile = Uint8Array.from([...Buffer.from("prof"), ...DISPLAY_P3]);
    expectNear(await seen(having(profile)), PLAIN, 3);
    const numbers = (primaries: number, curve: number): Uint8Array =>
      Uint8Array.from([...Buffer.from("nclx"), 0, primaries, 0, curve, 0, 0, 0x80]);
    expectNear(await seen(having(numbers(12, 13))), PLAIN, 3);
    expect(await seen(having(numbers(1, 13)))).toEqual(IN_P3);
    // Light of HDR is none that sRGB has.
    expect(await seen(having(numbers(12, 16)))).toEqual(IN_P3);
  });

  it("by PNG's numbers in place of a profile has the same colours, and they go before a profile", async () => {
    const numbers = ["cICP", Uint8Array.of(12, 13, 0, 1)] as const;
    expectNear(await seen(rowPng(IN_P3, [numbers])), PLAIN, 3);
    expect(await seen(rowPng(IN_P3, [numbers, iccChunk(ADOBE_RGB)]))).toEqual(await seen(rowPng(IN_P3, [numbers])));
    expect(await seen(rowPng(IN_P3, [["cICP", Uint8Array.of(1, 13, 0, 1)]]))).toEqual(IN_P3);
    expectNear(await seen(rowPng([[128, 128, 128]], [["cICP", Uint8Array.of(9, 1, 0, 1)]])), [[128, 128, 128]]);
  });

  it("is a texture of a model as it is stored, as glTF asks", async () => {
    const { rgba } = await decodePicture(rowPng(IN_P3, [iccChunk(DISPLAY_P3)]), "texture");
    expect([...rgba].filter((_, i) => i % 4 !== 3)).toEqual(IN_P3.flat());
  });
});

describe("a profile that cannot be followed", () => {
  const curve = curves.gamma(2.2);
  it.each<[string, Uint8Array]>([
    ["is empty", new Uint8Array()],
    ["is cut short", DISPLAY_P3.slice(0, 200)],
    ["is no profile", new Uint8Array(400).fill(7)],
    ["is for presses", makeProfile("CMYK", { A2B0: curve })],
    ["has no curve", makeProfile("RGB ", { rXYZ: curve, gXYZ: curve, bXYZ: curve })],
    ["has a curve of no power", rgbProfile(PRIMARIES.displayP3, curves.gamma(0))],
    [
      "has a curve of a kind that is not known",
      rgbProfile(PRIMARIES.displayP3, curves.formula(9, 1, 1, 1, 1, 1, 1, 1, 1)),
    ],
    ["has a table that is cut short", rgbProfile(PRIMARIES.displayP3, curves.table([0, 0.5, 1]).slice(0, 14))],
    ["says it has more tags than there are", Uint8Array.from(DISPLAY_P3, (value, i) => (i === 128 ? 0xff : value))],
  ])("and %s is as none, at which browsers do not look either", async (_, profile) => {
    const png = rowPng(IN_P3, [iccChunk(profile)]);
    expect(await seen(png)).toEqual(IN_P3);
    expect((await checkUpload("p.png", png)).bytes).toEqual((await checkUpload("p.png", rowPng(IN_P3))).bytes);
  });

  it.each<[string, Uint8Array]>([
    ["grows beyond all profiles", deflateSync(Buffer.concat([DISPLAY_P3, new Uint8Array(64 * 2 ** 20)]))],
    ["is not packed at all", Buffer.from("no zlib")],
  ])("and %s is as none", async (_, packed) => {
    const png = rowPng(IN_P3, [["iCCP", Buffer.concat([Buffer.from("x\0\0"), packed])]]);
    expect(await seen(png)).toEqual(IN_P3);
    expect((await checkUpload("p.png", png)).bytes).toEqual((await checkUpload("p.png", rowPng(IN_P3))).bytes);
  });

  it("but by tables is refused by name, in a design and as an upload", async () => {
    const png = rowPng(IN_P3, [iccChunk(makeProfile("RGB ", { A2B0: curve }))]);
    const refusal = { code: "bad-picture", reason: "profile", subject: "scan.png", hint: "Save it in sRGB colours." };
    await expect(decodePicture(png, "scan.png", { asSeen: true })).rejects.toMatchObject(refusal);
    await expect(checkUpload("scan.png", png)).rejects.toMatchObject(refusal);
  });
});

describe("an upload with a colour profile", () => {
  it("keeps what its colours are made of, and loses the screen's name", async () => {
    const png = rowPng(IN_P3, [iccChunk(DISPLAY_P3)]);
    const { bytes } = await checkUpload("p.png", png);
    // What is kept is stored as it is: a text would be seen.
    expect(Buffer.from(bytes).toString("latin1")).toContain("rXYZ");
    expect(Buffer.from(bytes).toString("latin1")).not.toMatch(/Jane|4711/);
    expect(await seen(bytes)).toEqual(await seen(png));
    expect((await checkUpload("p.png", bytes)).bytes).toEqual(bytes);
    expect(await readPictureHeader(bytes, "p")).toMatchObject({ width: 5, height: 1 });
  });

  it("keeps it in a JPEG, in as many pieces as it takes", async () => {
    const rgba = new Uint8Array(8 * 8 * 4).map((_, i) => (i * 29) % 256);
    const jpeg = await jpegOf({ rgba, width: 8, height: 8 });
    const table = curves.table(Array.from({ length: 20_000 }, (_, i) => (i / 19_999) ** 1.8));
    for (const profile of [DISPLAY_P3, rgbProfile(PRIMARIES.displayP3, table, "Jane's")]) {
      const photo = jpegWith(jpeg, profile);
      const { bytes } = await checkUpload("p.jpg", photo);
      expect(Buffer.from(bytes).toString("latin1")).not.toContain("Jane");
      expect(await seen(bytes)).toEqual(await seen(photo));
      expect(await seen(bytes)).not.toEqual(await seen(jpeg));
      expect((await checkUpload("p.jpg", bytes)).bytes).toEqual(bytes);
    }
  });

  it("loses one of sRGB, and keeps PNG's numbers where they tell more", async () => {
    const plain = (await checkUpload("p.png", rowPng(IN_P3))).bytes;
    const profiled = rowPng(IN_P3, [iccChunk(rgbProfile(PRIMARIES.srgb, SRGB_FORMULA))]);
    expect((await checkUpload("p.png", profiled)).bytes).toEqual(plain);
    expect((await checkUpload("p.png", rowPng(IN_P3, [["cICP", Uint8Array.of(1, 13, 0, 1)]]))).bytes).toEqual(plain);
    const coded = rowPng(IN_P3, [["cICP", Uint8Array.of(12, 13, 0, 1)]]);
    expect((await checkUpload("p.png", coded)).bytes).toEqual(coded);
  });
});

describe("a power", () => {
  it("is that of Math.pow to thirteen digits", () => {
    for (const exponent of [0.1, 1, 1.8, 2.2, 2.4, 10]) {
      for (let i = 0; i <= 1000; i++) {
        const base = i / 1000;
        expect(Math.abs(power(base, exponent) - base ** exponent)).toBeLessThanOrEqual(1e-13 * base ** exponent);
      }
    }
  });
});

const textOf = (bytes: Uint8Array): string => Buffer.from(bytes).toString("latin1");

const light = (step: number): number => (step <= 0.04045 ? step / 12.92 : ((step + 0.055) / 1.055) ** 2.4);
const encoded = (value: number): number => (value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055);

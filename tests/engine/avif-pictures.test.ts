import { createHash } from "node:crypto";
import { beforeAll, describe, expect, it } from "vitest";
import type { Picture } from "../../web/engine/engine-api.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { readPictureHeader } from "../../web/engine/picture-header.ts";
import {
  type AvifPart,
  avifFile,
  box,
  cropBox,
  deepAvifFile,
  fullBox,
  gridData,
  joined,
  makeAvif,
  mirrorBox,
  partsOf,
  sizeBox,
  text,
  turnBox,
  u16,
  u32,
} from "../support/avif-file.ts";
import { seeded } from "../support/seeded.ts";

/** 32 × 16 with every pixel another colour, some of them transparent. */
const CHART: Picture = {
  width: 32,
  height: 16,
  rgba: Uint8Array.from({ length: 32 * 16 * 4 }, (_, i) => (i % 4 === 3 && i % 7 === 0 ? 0 : (i * 37) % 256)),
};
/** Its red says the column, its green the row. */
const ruled = (width: number, height: number, alpha = 255): Picture => ({
  width,
  height,
  rgba: Uint8Array.from({ length: width * height * 4 }, (_, i) => {
    const [column, row] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
    return [column, row, 60, alpha][i % 4] ?? 0;
  }),
});

/** Of 4 × 2 pixels, numbered in their red from 0. */
const NUMBERED: Picture = {
  width: 4,
  height: 2,
  rgba: Uint8Array.from({ length: 32 }, (_, i) => [i >> 2, 0, 0, 255][i % 4] ?? 0),
};

let chart: Uint8Array;
let numbered: AvifPart;
let tile: AvifPart;
beforeAll(async () => {
  chart = await avifFile(CHART);
  numbered = partsOf(await avifFile(NUMBERED))[0] as AvifPart;
  tile = partsOf(await avifFile(ruled(64, 64)))[0] as AvifPart;
});

const having = (part: AvifPart, ...more: Uint8Array[]): AvifPart => ({
  ...part,
  properties: [...(part.properties ?? []), ...more],
});
const without = (part: AvifPart, type: string): AvifPart => ({
  ...part,
  properties: (part.properties ?? []).filter((each) => !Buffer.from(each).subarray(4, 8).equals(Buffer.from(type))),
});
const sized = (part: AvifPart, width: number, height: number): AvifPart =>
  having(without(part, "ispe"), sizeBox(width, height));
const reds = ({ rgba }: Picture): number[] => [...rgba].filter((_, i) => i % 4 === 0);
/** Tiles of 64 pixels along a side. */
const gridOf = (rows: number, columns: number, width: number, height: number, tiles = rows * columns): AvifPart[] => [
  {
    type: "grid",
    data: gridData(rows, columns, width, height),
    properties: [sizeBox(width, height)],
    references: { dimg: Array.from({ length: tiles }, (_, i) => i + 2) },
  },
  ...Array.from({ length: tiles }, () => tile),
];

describe("an AVIF picture", () => {
  it("without loss decodes to the encoded bytes, the colour under zero alpha too", async () => {
    expect(await decodePicture(chart, "chart.avif")).toEqual(CHART);
  });

  it("with loss decodes to the bytes that every release has given: prints must not change", async () => {
    const first = await decodePicture(await avifFile(CHART, 80), "chart.avif");
    expect(first).toMatchObject({ width: 32, height: 16 });
    expect(first).toEqual(await decodePicture(await avifFile(CHART, 80), "chart.avif"));
    expect(createHash("sha256").update(first.rgba).digest("hex").slice(0, 16)).toBe("b0a4b70ff74b32ce");
  });

  it.each([10, 12] as const)("of %i bits a channel is rounded to 8", async (depth) => {
    const most = 2 ** depth - 1;
    const channels = Uint16Array.from({ length: 32 * 32 * 4 }, (_, i) => (i * 41) % (most + 1));
    const { rgba } = await decodePicture(await deepAvifFile({ width: 32, height: 32, channels }, depth), "deep.avif");
    expect([...rgba]).toEqual([...channels].map((value) => Math.round((value * 255) / most)));
  });

  it("is told by its content, whatever the name says, and by its brands, whichever comes first", async () => {
    expect(await readPictureHeader(chart, "photo.png")).toEqual({
      format: "avif",
      width: 32,
      height: 16,
      orientation: 1,
    });
    const file = makeAvif({ brand: "mif1", brands: ["mif1", "avif"], parts: [numbered] });
    expect(await decodePicture(file, "numbered.avif")).toEqual(NUMBERED);
  });

  it("has straight colours where they lie in the file multiplied by alpha", async () => {
    const parts = partsOf(await avifFile({ width: 1, height: 1, rgba: Uint8Array.of(100, 50, 20, 128) }));
    const [colours, alpha] = parts as [AvifPart, AvifPart];
    const file = makeAvif({ parts: [{ ...colours, references: { prem: [2] } }, alpha] });
    expect([...(await decodePicture(file, "p.avif")).rgba]).toEqual([199, 100, 40, 128]);
  });

  it("is read without the box that older programs leave out", async () => {
    expect(await decodePicture(makeAvif({ parts: [without(numbered, "pixi")] }), "old.avif")).toEqual(NUMBERED);
    const [colours, alpha] = partsOf(chart) as [AvifPart, AvifPart];
    const old = makeAvif({ parts: [without(colours, "pixi"), without(alpha, "pixi")] });
    expect(await decodePicture(old, "old.avif")).toEqual(CHART);
  });

  it.each<[string, Uint8Array[], number, number[]]>([
    ["turned by a quarter", [turnBox(1)], 2, [3, 7, 2, 6, 1, 5, 0, 4]],
    ["turned by a half", [turnBox(2)], 4, [7, 6, 5, 4, 3, 2, 1, 0]],
    ["turned by three quarters", [turnBox(3)], 2, [4, 0, 5, 1, 6, 2, 7, 3]],
    ["mirrored, top to bottom", [mirrorBox(0)], 4, [4, 5, 6, 7, 0, 1, 2, 3]],
    ["mirrored, left to right", [mirrorBox(1)], 4, [3, 2, 1, 0, 7, 6, 5, 4]],
    ["turned by a quarter and mirrored, top to bottom", [turnBox(1), mirrorBox(0)], 2, [0, 4, 1, 5, 2, 6, 3, 7]],
    ["turned by a quarter and mirrored, left to right", [turnBox(1), mirrorBox(1)], 2, [7, 3, 6, 2, 5, 1, 4, 0]],
    ["cut", [cropBox([4, 2], { x: 1, y: 1, w: 3, h: 1 })], 3, [5, 6, 7]],
    ["cut and turned", [cropBox([4, 2], { x: 2, y: 0, w: 2, h: 2 }), turnBox(1)], 2, [3, 7, 2, 6]],
    ["cut to a row and turned", [cropBox([4, 2], { x: 0, y: 0, w: 3, h: 1 }), turnBox(1)], 1, [2, 1, 0]],
  ])("that says it is to be %s is, as every program shows it", async (_, boxes, width, expected) => {
    const file = makeAvif({ parts: [having(numbered, ...boxes)] });
    const height = expected.length / width;
    expect(await readPictureHeader(file, "n.avif")).toMatchObject({ width, height, orientation: 1 });
    // Of a texture too: it is how the picture is, and no camera's note.
    for (const asSeen of [true, false]) {
      const picture = await decodePicture(file, "n.avif", { asSeen });
      expect([picture.width, picture.height]).toEqual([width, height]);
      expect(reds(picture)).toEqual(expected);
    }
  });

  it("is not turned by EXIF, whose turn its own stands for", async () => {
    const exif = { type: "Exif", data: joined(u32(0), tiff(6)), references: { cdsc: [1] } };
    const file = makeAvif({ parts: [numbered, exif] });
    expect(await decodePicture(file, "n.avif", { asSeen: true })).toEqual(NUMBERED);
  });

  it("of tiles is put together, and cut where they are too large", async () => {
    const { width, height, rgba } = await decodePicture(makeAvif({ parts: gridOf(2, 2, 100, 90) }), "grid.avif");
    expect([width, height]).toEqual([100, 90]);
    const at = (x: number, y: number) => [...rgba.subarray((y * 100 + x) * 4, (y * 100 + x) * 4 + 4)];
    expect([at(0, 0), at(63, 63), at(64, 0), at(99, 89)]).toEqual([
      [0, 0, 60, 255],
      [63, 63, 60, 255],
      [0, 0, 60, 255],
      [35, 25, 60, 255],
    ]);
  });

  it("is the still one of a file that has a film too", async () => {
    const file = makeAvif({ brands: ["avif", "avis"], parts: [numbered], more: [box("moov", box("trak"))] });
    expect(await decodePicture(file, "n.avif")).toEqual(NUMBERED);
  });
});

describe("an AVIF picture that cannot be used", () => {
  /** A sequence header that says the size with 16 bits each, and nothing that can be decoded. */
  const sequence = (width: number, height: number, frames = 1): Uint8Array => {
    // Profile 0, a still picture, the short header, level 0, 16 bits for the width and for the height.
    const bits = `000${"1"}${"1"}00000${"1111".repeat(2)}${bits16(width - 1)}${bits16(height - 1)}`.padEnd(56, "0");
    const header = bits.match(/.{8}/g)?.map((byte) => Number.parseInt(byte, 2)) ?? [];
    const frame = [0x32, 1, 0];
    return joined([0x0a, header.length, ...header], ...Array.from({ length: frames }, () => frame));
  };
  const bits16 = (value: number): string => value.toString(2).padStart(16, "0");
  const coded = (data: Uint8Array): AvifPart => ({ ...sized(tile, 8, 8), data });

  it.each<[string, string, () => Uint8Array]>([
    ["a HEIC picture", "heic", () => makeAvif({ brand: "heic", parts: [{ type: "hvc1", data: u32(1) }] })],
    ["a film", "film", () => makeAvif({ brand: "isom", brands: ["isom", "mp42"], parts: [numbered] })],
    ["an animated one", "animated", () => makeAvif({ brand: "avis", brands: ["avis", "avif"], parts: [numbered] })],
    ["one of HEVC", "avif-kind", () => makeAvif({ parts: [{ ...numbered, type: "hvc1" }] })],
    ["one laid over others", "avif-kind", () => makeAvif({ parts: [{ ...numbered, type: "iovl" }] })],
    [
      "one that needs what is not known",
      "avif-kind",
      () => makeAvif({ parts: [having(numbered, box("mskC", u32(0)))] }),
    ],
    ["one whose tile is missing", "avif-kind", () => makeAvif({ parts: gridOf(2, 2, 128, 128, 4).slice(0, 4) })],
    ["one of fewer tiles than it says", "damaged", () => makeAvif({ parts: gridOf(2, 2, 128, 128, 3) })],
    ["one without a size", "damaged", () => makeAvif({ parts: [without(numbered, "ispe")] })],
    ["one of no width", "no-pixels", () => makeAvif({ parts: [sized(numbered, 0, 2)] })],
    ["one of another size than its data", "damaged", () => makeAvif({ parts: [sized(numbered, 8, 2)] })],
    [
      "one that is cut beside itself",
      "damaged",
      () => makeAvif({ parts: [having(numbered, cropBox([4, 2], { x: 3, y: 0, w: 3, h: 2 }))] }),
    ],
    [
      "one that is cut to nothing",
      "damaged",
      () => makeAvif({ parts: [having(numbered, box("clap", new Uint8Array(32)))] }),
    ],
    [
      "a grid that lies of its size",
      "damaged",
      () => {
        const [grid, ...tiles] = gridOf(1, 2, 128, 64) as [AvifPart, ...AvifPart[]];
        return makeAvif({ parts: [{ ...grid, data: gridData(1, 2, 8000, 8000) }, ...tiles] });
      },
    ],
    ["one that claims 8193 pixels", "too-many-pixels", () => makeAvif({ parts: [sized(numbered, 8193, 1)] })],
    [
      "one of four thousand million pixels",
      "too-many-pixels",
      () => makeAvif({ parts: [sized(numbered, 65536, 65536)] }),
    ],
    [
      "one whose data is larger than it claims",
      "too-many-pixels",
      () => makeAvif({ parts: [coded(sequence(60_000, 9))] }),
    ],
    [
      "one whose alpha is larger than it claims",
      "too-many-pixels",
      () => {
        const alpha = partsOf(chart)[1] as AvifPart;
        return makeAvif({ parts: [numbered, { ...sized(alpha, 4, 2), data: sequence(9, 60_000) }] });
      },
    ],
    ["one of many large frames", "frames", () => makeAvif({ parts: [coded(sequence(8000, 8000, 5))] })],
    ["one of very many small frames", "frames", () => makeAvif({ parts: [coded(sequence(8, 8, 5000))] })],
    ["one in very many parts", "avif-kind", () => makeAvif({ parts: [numbered, ...extras(5000)] })],
    ["one in pieces without end", "avif-kind", () => withPlaces(joined([0, 0], u16(1), u16(1), u16(0), u16(65535)))],
    [
      "one in pieces that are the whole file",
      "damaged",
      () => {
        const pieces = Array.from({ length: 4000 }, () => joined(u32(0), u32(300)));
        return withPlaces(joined([0x44, 0], u16(1), u16(1), u16(0), u16(pieces.length), ...pieces));
      },
    ],
    [
      "one in another file",
      "no-pixels",
      () => withPlaces(joined([0x44, 0], u16(1), u16(1), u16(7), u16(1), u32(0), u32(9))),
    ],
    ["one said twice", "damaged", () => makeAvif({ parts: [numbered], inMeta: [fullBox("pitm", 0, u16(1))] })],
  ])("such as %s is refused with its name and the reason", async (_, reason, make) => {
    const file = make();
    const error = await decodePicture(file, "shop/logo.avif").catch((thrown: unknown) => thrown);
    expect(error).toMatchObject({ code: "bad-picture", subject: "shop/logo.avif", reason });
    expect((error as { hint: string }).hint).toMatch(/\w/);
  });

  const extras = (count: number): AvifPart[] =>
    Array.from({ length: count }, () => ({ type: "mime", data: text("x") }));
  /** The numbered picture with another list of the places of its data. */
  const withPlaces = (places: Uint8Array): Uint8Array => makeAvif({ parts: [numbered], places });

  it("that ends early is refused by its name, wherever it ends", async () => {
    for (let length = 0; length < chart.length; length += 7) {
      const cut = decodePicture(chart.slice(0, length), "cut.avif");
      await expect(cut, String(length)).rejects.toMatchObject({ code: "bad-picture", subject: "cut.avif" });
    }
    await expect(decodePicture(chart.slice(0, -1), "cut.avif")).rejects.toThrow(/cut short/);
  });

  it("is read or refused by its name, whatever of its bytes is changed, and leaves the decoder fit", async () => {
    const random = seeded(11);
    for (let i = 0; i < 400; i++) {
      const changed = chart.slice();
      const range = i % 2 ? 460 : changed.length;
      for (let k = 0; k < 3; k++) changed[Math.floor(random() * range)] = Math.floor(random() * 256);
      const read = await decodePicture(changed, "changed").catch((error: unknown) => error);
      if (read instanceof Error) expect(read).toMatchObject({ code: "bad-picture", subject: "changed" });
      else expect(read).toMatchObject({ rgba: expect.any(Uint8Array) });
    }
    expect(await decodePicture(chart, "chart.avif")).toEqual(CHART);
  });
});

describe("an AVIF picture whose colours are of a system that the decoder does not know", () => {
  const colours = (matrix: number): Uint8Array => box("colr", text("nclx"), u16(1), u16(13), u16(matrix), [0x80]);
  it.each([3, 10, 11, 13, 14, 127])("(%i) is refused, where it would show what was in memory", async (matrix) => {
    for (const [first, ...others] of [partsOf(chart), [numbered]] as [AvifPart, ...AvifPart[]][]) {
      const file = makeAvif({ parts: [having(without(first, "colr"), colours(matrix)), ...others] });
      const read = decodePicture(file, "odd.avif");
      await expect(read).rejects.toMatchObject({ code: "bad-picture", subject: "odd.avif", reason: "avif-kind" });
    }
  });
});

/** EXIF's block with the orientation alone. */
function tiff(orientation: number): Uint8Array {
  const entry = joined(u16(0x0112), u16(3), u32(1), u16(orientation), u16(0));
  return joined(text("MM"), u16(42), u32(8), u16(1), entry, u32(0));
}

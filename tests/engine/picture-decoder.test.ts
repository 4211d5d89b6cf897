import { createHash } from "node:crypto";
import { beforeAll, describe, expect, it } from "vitest";
import type { Picture } from "../../web/engine/engine-api.ts";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { packGltf } from "../../web/engine/gltf-packer.ts";
import { imageBytes } from "../../web/engine/model-textures.ts";
import { decodePicture, readPictureHeader } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { jpegOf, webpOf } from "../support/encoded-pictures.ts";
import { makePng, paintPng, pngChunk, solidPng } from "../support/png-file.ts";
import { jpegOfScans } from "../support/scanned-jpeg.ts";
import { haveSharedModels, noteSkipped, sharedModel } from "../support/shared-models.ts";

const pixels = async (bytes: Uint8Array): Promise<number[]> => [...(await decodePicture(bytes, "test")).rgba];

/** 32 × 16 with every pixel another colour, some of them transparent. */
const CHART: Picture = {
  width: 32,
  height: 16,
  rgba: Uint8Array.from({ length: 32 * 16 * 4 }, (_, i) => (i % 4 === 3 && i % 7 === 0 ? 0 : (i * 37) % 256)),
};
const OPAQUE: Picture = { ...CHART, rgba: CHART.rgba.map((value, i) => (i % 4 === 3 ? 255 : value)) };

let jpeg: Uint8Array;
let webpLossless: Uint8Array;
let webpLossy: Uint8Array;

beforeAll(async () => {
  jpeg = await jpegOf(OPAQUE, 90);
  webpLossless = await webpOf(CHART);
  webpLossy = await webpOf(CHART, 90);
});

describe("PNG", () => {
  const row = (
    colorType: 0 | 2 | 3 | 4 | 6,
    bitDepth: 1 | 2 | 4 | 8 | 16,
    width: number,
    bytes: number[],
    more = {},
  ): Uint8Array => makePng({ width, height: 1, bitDepth, colorType, rows: [bytes], ...more });
  const palette = [255, 0, 0, 0, 255, 0, 0, 0, 255];

  it.each(["iCCP", "gAMA", "cHRM", "sRGB", "pHYs", "tEXt", "zTXt", "iTXt", "acTL", "fcTL", "fdAT"])(
    "is read where what stands in %s is no such thing, as viewers read it",
    async (type) => {
      for (const data of [[], [7], [255, 255, 255, 255, 255], new Array(40).fill(200)]) {
        const png = row(2, 8, 2, [1, 2, 3, 4, 5, 6], { extra: [[type, Uint8Array.from(data)]] });
        expect(await pixels(png)).toEqual([1, 2, 3, 255, 4, 5, 6, 255]);
        const deep = row(2, 16, 1, [1, 255, 3, 4, 5, 6], { extra: [[type, Uint8Array.from(data)]] });
        expect(await pixels(deep)).toEqual([2, 3, 5, 255]);
      }
    },
  );

  it.each<[string, Uint8Array, number[]]>([
    ["RGBA 8", row(6, 8, 1, [1, 2, 3, 0]), [1, 2, 3, 0]],
    ["RGBA 16", row(6, 16, 1, [1, 255, 3, 4, 5, 6, 7, 200]), [2, 3, 5, 8]],
    ["RGB 8", row(2, 8, 2, [1, 2, 3, 4, 5, 6]), [1, 2, 3, 255, 4, 5, 6, 255]],
    [
      "RGB 8 with one transparent colour",
      row(2, 8, 2, [1, 2, 3, 4, 5, 6], { transparency: [0, 1, 0, 2, 0, 3] }),
      [1, 2, 3, 0, 4, 5, 6, 255],
    ],
    ["RGB 16", row(2, 16, 1, [1, 255, 3, 4, 5, 6]), [2, 3, 5, 255]],
    [
      "RGB 16 with one transparent colour",
      row(2, 16, 2, [1, 255, 3, 4, 5, 6, 1, 254, 3, 4, 5, 6], { transparency: [1, 255, 3, 4, 5, 6] }),
      [2, 3, 5, 0, 2, 3, 5, 255],
    ],
    ["grey 1", row(0, 1, 3, [0b10100000]), [255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255]],
    ["grey 2", row(0, 2, 2, [0b01100000]), [85, 85, 85, 255, 170, 170, 170, 255]],
    ["grey 4", row(0, 4, 2, [0x1f]), [17, 17, 17, 255, 255, 255, 255, 255]],
    ["grey 8", row(0, 8, 2, [1, 2]), [1, 1, 1, 255, 2, 2, 2, 255]],
    ["grey 8 with one transparent value", row(0, 8, 2, [1, 2], { transparency: [0, 2] }), [1, 1, 1, 255, 2, 2, 2, 0]],
    ["grey 16", row(0, 16, 1, [0x12, 0xff]), [19, 19, 19, 255]],
    ["grey and alpha 8", row(4, 8, 1, [7, 9]), [7, 7, 7, 9]],
    ["grey and alpha 16", row(4, 16, 1, [7, 200, 9, 1]), [8, 8, 8, 9]],
    ["palette 8", row(3, 8, 3, [0, 1, 2], { palette }), [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255]],
    [
      "palette 8 with alpha",
      row(3, 8, 3, [0, 1, 2], { palette, transparency: [10, 20] }),
      [255, 0, 0, 10, 0, 255, 0, 20, 0, 0, 255, 255],
    ],
    [
      "palette 1",
      row(3, 1, 3, [0b10100000], { palette: palette.slice(0, 6) }),
      [0, 255, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255],
    ],
    ["palette 2", row(3, 2, 3, [0b00011000], { palette }), [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255]],
    ["palette 4", row(3, 4, 2, [0x21], { palette }), [0, 0, 255, 255, 0, 255, 0, 255]],
  ])("of type %s decodes to straight RGBA", async (_, file, expected) => {
    expect(await pixels(file)).toEqual(expected);
  });

  it("of 16 bits a channel is rounded to the nearest of 8, and widened bytes are themselves", async () => {
    const values = Array.from({ length: 4 * 4096 }, (_, i) => (i * 4099) % 65536);
    const file = row(
      6,
      16,
      4096,
      values.flatMap((value) => [value >> 8, value & 255]),
    );
    expect(await pixels(file)).toEqual(values.map((value) => Math.round((value * 255) / 65535)));
    const bytes = Array.from({ length: 256 }, (_, value) => value);
    const widened = row(
      6,
      16,
      64,
      bytes.flatMap((value) => [value, value]),
    );
    expect(await pixels(widened)).toEqual(bytes);
  });

  it.each([1, 2] as const)("that is interlaced decodes as one that is not, with %i bytes a channel", async (bytes) => {
    const size = 8;
    const rowOf = (y: number, from = 0, step = 1): number[] =>
      Array.from({ length: Math.ceil((size - from) / step) }, (_, i) => {
        const value = (y * size + from + i * step) * 4;
        return bytes === 1 ? [value] : [value, 7];
      }).flat();
    // Adam7: each pass's first column and row, and its steps.
    const passes = [
      [0, 0, 8, 8],
      [4, 0, 8, 8],
      [0, 4, 4, 8],
      [2, 0, 4, 4],
      [0, 2, 2, 4],
      [1, 0, 2, 2],
      [0, 1, 1, 2],
    ] as const;
    const woven = passes.flatMap(([x, y, across, down]) =>
      Array.from({ length: Math.ceil((size - y) / down) }, (_, i) => rowOf(y + i * down, x, across)),
    );
    const parts = { width: size, height: size, bitDepth: bytes === 1 ? 8 : 16, colorType: 0 } as const;
    const plain = makePng({ ...parts, rows: Array.from({ length: size }, (_, y) => rowOf(y)) });
    expect(await pixels(makePng({ ...parts, rows: woven, interlaced: true }))).toEqual(await pixels(plain));
  });

  it("keeps every byte through encoding and decoding, the colour under zero alpha too", async () => {
    const decoded = await decodePicture(await encodePng(CHART), "chart.png");
    expect(decoded).toEqual(CHART);
    expect(
      await pixels(await encodePng({ width: 2, height: 1, rgba: Uint8Array.of(9, 8, 7, 0, 1, 2, 3, 255) })),
    ).toEqual([9, 8, 7, 0, 1, 2, 3, 255]);
  });

  it("is encoded from a view into a larger buffer", async () => {
    const large = new Uint8Array(CHART.rgba.length + 64);
    large.set(CHART.rgba, 32);
    const rgba = large.subarray(32, 32 + CHART.rgba.length);
    expect(await encodePng({ ...CHART, rgba })).toEqual(await encodePng(CHART));
  });

  it("is not encoded from bytes that do not fit the size", async () => {
    await expect(encodePng({ width: 2, height: 2, rgba: new Uint8Array(15) })).rejects.toMatchObject({
      code: "bad-argument",
    });
    await expect(encodePng({ width: 0, height: 0, rgba: new Uint8Array() })).rejects.toMatchObject({
      code: "bad-argument",
    });
  });

  it("ignores its text, its gamma and its other chunks without pixels", async () => {
    const gamma: [string, Uint8Array] = ["gAMA", Uint8Array.of(0, 0, 0xb1, 0x8f)];
    const plain = makePng({ width: 1, height: 1, bitDepth: 8, colorType: 2, rows: [[10, 20, 30]], extra: [gamma] });
    expect(await pixels(plain)).toEqual([10, 20, 30, 255]);
  });
});

describe("JPEG and WebP", () => {
  it("decode JPEG to the very same bytes each time, near the colours that were encoded", async () => {
    const first = await decodePicture(jpeg, "chart.jpg");
    expect(first).toEqual(await decodePicture(jpeg, "chart.jpg"));
    expect(first).toMatchObject({ width: 32, height: 16 });
    expect(first.rgba.filter((_, i) => i % 4 === 3).every((alpha) => alpha === 255)).toBe(true);
  });

  it("decode JPEG to the bytes that every release has given: prints must not change", async () => {
    const { rgba } = await decodePicture(jpeg, "chart.jpg");
    expect(createHash("sha256").update(rgba).digest("hex").slice(0, 16)).toBe("5d0ffd8712b138c0");
  });

  it("decode lossless WebP to the encoded bytes, the colour under zero alpha too", async () => {
    expect(await decodePicture(webpLossless, "chart.webp")).toEqual(CHART);
  });

  it("decode lossy WebP with its alpha", async () => {
    const { rgba, width, height } = await decodePicture(webpLossy, "chart.webp");
    expect([width, height]).toEqual([32, 16]);
    expect([...rgba].filter((_, i) => i % 4 === 3)).toEqual([...CHART.rgba].filter((_, i) => i % 4 === 3));
  });

  it("tell the format by content, whatever the name says", async () => {
    expect((await readPictureHeader(jpeg, "photo.png")).format).toBe("jpeg");
    expect((await readPictureHeader(webpLossy, "photo.png")).format).toBe("webp");
    expect((await decodePicture(webpLossless, "photo.jpg")).width).toBe(32);
  });
});

describe("a photo's EXIF orientation", () => {
  /** EXIF's TIFF block with the orientation alone. */
  const exif = (orientation: number, little = true): Uint8Array => {
    const view = new DataView(new ArrayBuffer(26));
    view.setUint16(0, little ? 0x4949 : 0x4d4d);
    view.setUint16(2, 42, little);
    view.setUint32(4, 8, little);
    view.setUint16(8, 1, little);
    view.setUint16(10, 0x0112, little);
    view.setUint16(12, 3, little);
    view.setUint32(14, 1, little);
    view.setUint16(18, orientation, little);
    return new Uint8Array(view.buffer);
  };
  /** 2 × 3, pixels numbered 1 to 6 in their red. */
  const numbered = (orientation: number): Uint8Array =>
    makePng({
      width: 2,
      height: 3,
      bitDepth: 8,
      colorType: 2,
      rows: [
        [1, 0, 0, 2, 0, 0],
        [3, 0, 0, 4, 0, 0],
        [5, 0, 0, 6, 0, 0],
      ],
      extra: [["eXIf", exif(orientation)]],
    });

  it.each([
    [1, 2, [1, 2, 3, 4, 5, 6]],
    [2, 2, [2, 1, 4, 3, 6, 5]],
    [3, 2, [6, 5, 4, 3, 2, 1]],
    [4, 2, [5, 6, 3, 4, 1, 2]],
    [5, 3, [1, 3, 5, 2, 4, 6]],
    [6, 3, [5, 3, 1, 6, 4, 2]],
    [7, 3, [6, 4, 2, 5, 3, 1]],
    [8, 3, [2, 4, 6, 1, 3, 5]],
  ])("%i is undone when asked", async (orientation, width, expected) => {
    const upright = await decodePicture(numbered(orientation), "photo", { asSeen: true });
    expect(upright.width).toBe(width);
    expect([...upright.rgba].filter((_, i) => i % 4 === 0)).toEqual(expected);
  });

  it("is left alone when not asked, as glTF viewers show textures", async () => {
    expect(await decodePicture(numbered(6), "texture")).toMatchObject({ width: 2, height: 3 });
  });

  it("is found in JPEG files of either byte order", async () => {
    for (const little of [true, false]) {
      const block = [...new TextEncoder().encode("Exif\0\0"), ...exif(6, little)];
      const segment = [0xff, 0xe1, 0, block.length + 2, ...block];
      const photo = Uint8Array.from([...jpeg.subarray(0, 2), ...segment, ...jpeg.subarray(2)]);
      expect(await readPictureHeader(photo, "photo.jpg")).toMatchObject({ width: 32, height: 16, orientation: 6 });
      expect(await decodePicture(photo, "photo.jpg", { asSeen: true })).toMatchObject({ width: 16, height: 32 });
    }
  });

  it("is found in WebP files, with JPEG's mark before it or without", async () => {
    for (const mark of ["Exif\0\0", ""]) {
      const block = [...new TextEncoder().encode(mark), ...exif(6)];
      const size = Buffer.from(Uint32Array.of(block.length).buffer);
      const photo = Buffer.concat([webpLossless, Buffer.from("EXIF"), size, Buffer.from(block)]);
      photo.writeUInt32LE(photo.length - 8, 4);
      expect(await readPictureHeader(photo, "photo.webp")).toMatchObject({ width: 32, height: 16, orientation: 6 });
      expect(await decodePicture(photo, "photo.webp", { asSeen: true })).toMatchObject({ width: 16, height: 32 });
    }
  });

  it("is found where it is written as a long number, as some programs do", async () => {
    for (const little of [true, false]) {
      const block = exif(6, little);
      const view = new DataView(block.buffer);
      view.setUint16(12, 4, little);
      view.setUint32(18, 6, little);
      const extra: [string, Uint8Array][] = [["eXIf", block]];
      const photo = makePng({ width: 1, height: 1, bitDepth: 8, colorType: 0, rows: [[0]], extra });
      expect((await readPictureHeader(photo, "photo.png")).orientation).toBe(6);
    }
  });

  it("counts as upright when the tag is damaged", async () => {
    const damaged = makePng({
      width: 1,
      height: 1,
      bitDepth: 8,
      colorType: 0,
      rows: [[0]],
      extra: [["eXIf", Uint8Array.of(0x49, 0x49, 1)]],
    });
    expect((await readPictureHeader(damaged, "photo.png")).orientation).toBe(1);
  });
});

describe("a picture that cannot be used", () => {
  const huge = (width: number, height: number): Uint8Array => {
    const file = solidPng(1, 1, [0, 0, 0, 0]);
    const header = Buffer.from(file.slice(16, 29));
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    return new Uint8Array(Buffer.concat([file.slice(0, 8), pngChunk("IHDR", header), file.slice(33)]));
  };
  const flipped = (file: Uint8Array, at: number): Uint8Array => file.with(at, (file[at] ?? 0) ^ 1) as Uint8Array;
  /** Where the JPEG's start of frame lies: SOF0 to SOF2. */
  const frameOf = (file: Uint8Array): number =>
    file.findIndex((byte, i) => byte === 0xff && [0xc0, 0xc1, 0xc2].includes(file[i + 1] ?? 0));

  it.each<[string, () => Uint8Array, RegExp]>([
    ["text", () => new TextEncoder().encode("hello"), /neither PNG, JPEG, WebP, AVIF nor SVG/],
    ["nothing", () => new Uint8Array(), /empty/],
    ["a GIF", () => new TextEncoder().encode("GIF89a"), /GIF/],
    ["a PDF", () => new TextEncoder().encode("%PDF-1.7"), /PDF, as Illustrator's/],
    ["an EPS drawing", () => new TextEncoder().encode("%!PS-Adobe-3.0 EPSF-3.0"), /EPS/],
    ["an EPS drawing with a preview", () => Uint8Array.of(0xc5, 0xd0, 0xd3, 0xc6, 30, 0, 0, 0), /EPS/],
    ["a Photoshop document", () => new TextEncoder().encode("8BPS\0\x01"), /Photoshop/],
    ["a JPEG XL picture", () => Uint8Array.of(0xff, 0x0a, 0xfa, 0x7f), /JPEG XL/],
    ["a JPEG XL picture in boxes", () => new TextEncoder().encode("\0\0\0\x0cJXL \r\n"), /JPEG XL/],
    ["a PNG of no width", () => huge(0, 4), /0 × 4/],
    ["a PNG that claims 8193 pixels", () => huge(8193, 1), /8193 × 1/],
    ["a PNG that claims four thousand million pixels", () => huge(65536, 65536), /65536 × 65536/],
    ["a PNG cut short", () => solidPng(4, 4, [1, 2, 3, 4]).slice(0, -14), /cut short/],
    ["a PNG with one bit flipped", () => flipped(solidPng(4, 4, [1, 2, 3, 4]), 45), /damaged/],
    ["a PNG whose size does not fit its data", () => huge(64, 64), /damaged/],
    ["a JPEG cut short", () => jpeg.slice(0, -60), /cut short/],
    ["a JPEG of which little is left", () => jpeg.slice(0, 30), /cut short/],
    ["a CMYK JPEG", () => jpeg.with(frameOf(jpeg) + 9, 4) as Uint8Array, /CMYK/],
    ["a JPEG of arithmetic coding", () => jpeg.with(frameOf(jpeg) + 1, 0xc9) as Uint8Array, /arithmetic coding/],
    ["a progressive one of it", () => jpeg.with(frameOf(jpeg) + 1, 0xca) as Uint8Array, /arithmetic coding/],
    ["a JPEG without losses", () => jpeg.with(frameOf(jpeg) + 1, 0xc3) as Uint8Array, /without losses/],
    ["a JPEG-LS", () => jpeg.with(frameOf(jpeg) + 1, 0xf7) as Uint8Array, /without losses/],
    ["a WebP cut short", () => webpLossless.slice(0, -10), /cut short/],
    ["a WebP with damaged pixels", () => webpLossless.map((byte, i) => (i > 60 ? 0xa5 : byte)), /damaged/],
  ])("such as %s is refused with its name and the reason", async (_, file, message) => {
    const attempt = decodePicture(file(), "shop/logo.png");
    await expect(attempt).rejects.toMatchObject({ code: "bad-picture", subject: "shop/logo.png" });
    await expect(attempt).rejects.toThrow(message);
    await expect(attempt).rejects.toThrow(/logo\.png/);
  });

  it("is a JPEG of very many scans: each goes over the whole picture, however few bytes it has", async () => {
    expect((await decodePicture(jpegOfScans(64, 100), "some.jpg")).width).toBe(64);
    await expect(decodePicture(jpegOfScans(64, 101), "many.jpg")).rejects.toMatchObject({
      code: "bad-picture",
      message: expect.stringMatching(/“many\.jpg”.*it has more than 100 scans/),
    });
  });

  it("does not use the decoder up, however many come", async () => {
    const broken = huge(64, 64);
    for (let i = 0; i < 1000; i++) await decodePicture(broken, "broken.png").catch(() => undefined);
    expect(await pixels(solidPng(1, 1, [1, 2, 3, 4]))).toEqual([1, 2, 3, 4]);
  });

  it("leaves the JPEG decoder fit for the next one", async () => {
    const expected = await pixels(jpeg);
    const broken = jpeg.map((byte, i) => (i > 20 && i < 60 ? 0x11 : byte));
    await decodePicture(broken, "broken.jpg").catch(() => undefined);
    expect(await pixels(jpeg)).toEqual(expected);
  });
});

noteSkipped("an indexed PNG of another program's making decodes to its palette's colours");
describe.runIf(haveSharedModels)("the shared models", () => {
  it("have an indexed PNG in BoxTextured, which decodes to its palette's colours", async () => {
    const { json, binary } = packGltf(readContainer(sharedModel("BoxTextured.glb")));
    const image = imageBytes(json, binary, 0, "BoxTextured.glb");
    const bytes = image?.bytes ?? new Uint8Array();
    expect(bytes[25]).toBe(3);
    const { width, height, rgba } = await decodePicture(bytes, "box");
    expect([width, height]).toEqual([256, 256]);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    let at = 8;
    while (String.fromCharCode(...bytes.subarray(at + 4, at + 8)) !== "PLTE") at += 12 + view.getUint32(at);
    const palette = new Set<number>();
    for (let i = at + 8; i < at + 8 + view.getUint32(at); i += 3) palette.add(view.getUint32(i - 1) & 0xffffff);
    const colours = new Set<number>();
    for (let i = 0; i < rgba.length; i += 4) {
      colours.add(((rgba[i] ?? 0) << 16) | ((rgba[i + 1] ?? 0) << 8) | (rgba[i + 2] ?? 0));
    }
    expect(colours.size).toBeGreaterThan(10);
    expect([...colours].every((colour) => palette.has(colour))).toBe(true);
  });
});

describe("the built pictures of these tests", () => {
  it("are what they say", async () => {
    expect(await pixels(paintPng(2, 1, (x) => [x, 5, 6, 7]))).toEqual([0, 5, 6, 7, 1, 5, 6, 7]);
  });
});

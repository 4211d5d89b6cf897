import { afterEach, describe, expect, it } from "vitest";
import type { EngineText, TargetUpdate } from "../../web/engine/engine-api.ts";
import { footprintTexels, MOST_RASTER_PIXELS, rasterSize } from "../../web/engine/raster-size.ts";
import { readShippedFont } from "../../web/engine/shipped-fonts.ts";
import { isSvg } from "../../web/engine/svg-start.ts";
import { avifFile } from "../support/avif-file.ts";
import { softPicture } from "../support/ktx2-file.ts";
import { decal, FRONT } from "../support/layers.ts";
import { buildGlb } from "../support/model-builder.ts";
import { allTexels, at, endHosts, paintablePlane, SIZE, startHost, texturedPlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const bytesOf = (svg: string): Uint8Array => new TextEncoder().encode(svg);
const svgOf = (body: string, attributes = 'viewBox="0 0 20 10"', before = ""): Uint8Array =>
  bytesOf(`${before}<svg xmlns="http://www.w3.org/2000/svg" ${attributes}>${body}</svg>`);
const RED_HALF = svgOf('<rect width="10" height="10" fill="#ff0000"/>');

const ADA: EngineText = {
  text: "Ada",
  font: "texelcast:fonts/inter-700",
  fontSize: 1,
  letterSpacing: 0,
  align: "center",
  curve: 0,
  color: [1, 0, 0, 1],
  outline: null,
};

async function planeOf(size: number) {
  const engine = startHost();
  const updates: TargetUpdate[] = [];
  const errors: Error[] = [];
  engine.onUpdate((update) => updates.push(update));
  engine.onError((error) => errors.push(error));
  await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
  await engine.openTarget({ material: 0, width: size, height: size, base: [1, 1, 1, 1] });
  return { engine, updates, errors, read: () => engine.readTexels(0, 0, 0, size, size) };
}

describe("SVG files as decals", () => {
  it("that hold an AVIF picture are refused by name, and not drawn with a hole in its place", async () => {
    const avif = Buffer.from(await avifFile(softPicture(8, 8))).toString("base64");
    for (const type of ["avif", "png"]) {
      const bytes = svgOf(`<image width="9" height="9" href="data:image/${type};base64,${avif}"/>`);
      await expect(startHost().setAsset("held", { name: "held.svg", bytes })).rejects.toMatchObject({
        code: "bad-picture",
        reason: "inner-avif",
        subject: "held.svg, picture inside",
      });
    }
  });

  it("that the renderer stops at are told by name, with what to do, and the next is painted", async () => {
    const { engine, errors, read } = await planeOf(64);
    const far = '<g opacity="0.5" transform="translate(300)"><path d="M0 0h9v9z"/></g>';
    const mask = `<mask id="m" maskUnits="userSpaceOnUse" width="999" height="999">${far}</mask>`;
    const bytes = svgOf(`${mask}<path d="M0 0h9v9z" mask="url(#m)"/>`);
    await engine.setAsset("drawing", { name: "far.svg", bytes });
    engine.setLayers([decal("a", "drawing", { projector: { ...FRONT, size: [1, 1, 1] } })], 1);
    await read();
    expect(errors).toMatchObject([{ code: "bad-picture", subject: "far.svg", hint: expect.stringMatching(/PNG/) }]);
    const plain = await read();
    await engine.setAsset("drawing", { name: "half.svg", bytes: RED_HALF });
    expect(await read()).not.toEqual(plain);
  });

  it.each([
    [
      "a part of a web page",
      '<foreignObject width="9" height="9"><p xmlns="http://www.w3.org/1999/xhtml">a</p></foreignObject>',
    ],
    ["a picture elsewhere", '<image width="9" height="9" href="https://example.com/a.png"/>'],
  ])("that hold nothing but %s are refused by name, since nothing of them would be painted", async (_what, body) => {
    const shown = svgOf(`${body}<path d="M0 0h9v9z"/>`);
    await expect(startHost().setAsset("held", { name: "held.svg", bytes: svgOf(body) })).rejects.toMatchObject({
      code: "bad-picture",
      reason: "nothing-drawn",
      subject: "held.svg",
      hint: expect.stringMatching(/PNG/),
    });
    await expect(startHost().setAsset("held", { name: "held.svg", bytes: shown })).resolves.toBeDefined();
    await expect(startHost().setAsset("held", { name: "blank.svg", bytes: svgOf("") })).resolves.toBeDefined();
  });

  it("are painted like pictures, with their own proportions", async () => {
    const { engine, read } = await planeOf(64);
    expect(await engine.setAsset("drawing", { name: "half.svg", bytes: RED_HALF })).toEqual({ width: 20, height: 10 });
    engine.setLayers([decal("a", "drawing", { projector: { ...FRONT, size: [1, 1, 1] } })], 1);
    const texels = await read();
    const at = (x: number, y: number): number[] => [...texels.subarray(4 * (y * 64 + x), 4 * (y * 64 + x) + 4)];
    expect(at(8, 32)).toEqual([255, 0, 0, 255]);
    expect(at(56, 32)).toEqual([255, 255, 255, 255]);
  });

  it.each([
    ['viewBox="0 0 1.4 1"', { width: 1.4, height: 1 }],
    ['viewBox="0 0 0.04 0.03"', { width: 0.04, height: 0.03 }],
    ['width="30.5" height="10.25" viewBox="0 0 10 10"', { width: 30.5, height: 10.25 }],
    ['width="100%" height="50%" viewBox="0 0 20.5 10"', { width: 20.5, height: 5 }],
  ])("have the size that they give, however small and not in whole pixels: %s", async (attributes, size) => {
    const { engine } = await planeOf(16);
    const bytes = svgOf('<rect width="10" height="10"/>', attributes);
    expect(await engine.setAsset("drawing", { name: "small.svg", bytes })).toEqual(size);
  });

  it.each([
    'height="1em" viewBox="0 0 20 10"',
    'width="90" viewBox="0 0 20 10"',
    'width="100%" height="30px" viewBox="0 0 20 10"',
    `width = "2in" height='auto' data-x=' width="3" height="1"' viewBox="0 0 20 10"`,
  ])("keep the viewBox's proportions where they give one length alone, as icons do: %s", async (attributes) => {
    const { engine, read } = await planeOf(64);
    const bytes = svgOf('<rect width="20" height="10" fill="#ff0000"/>', attributes);
    expect(await engine.setAsset("icon", { name: "icon.svg", bytes })).toEqual({ width: 20, height: 10 });
    engine.setLayers([decal("a", "icon", { projector: FRONT })], 1);
    await engine.idle();
    const texels = await read();
    const at = (y: number): number[] => [...texels.subarray(4 * (y * 64 + 32), 4 * (y * 64 + 33))];
    for (const y of [18, 32, 45]) expect(at(y)).toEqual([255, 0, 0, 255]);
  });

  it("are painted on small targets too, however long and thin they are", async () => {
    const { engine, read } = await planeOf(64);
    const bytes = svgOf('<rect width="300" height="1" fill="#ff0000"/>', 'viewBox="0 0 300 1"');
    await engine.setAsset("line", { name: "line.svg", bytes });
    const projector = { ...FRONT, position: [0, 1 / 128, 0] as const, size: [0.6, 0.002, 1] as const };
    engine.setLayers([decal("a", "line", { projector })], 1);
    await engine.idle();
    const green = (await read())[4 * (31 * 64 + 32) + 1] ?? 0;
    const lineInTexels = 0.002 * 64;
    expect(Math.abs(green - 255 * (1 - lineInTexels))).toBeLessThan(4);
  });

  it("have the fonts for their words, be they of another script or emoji", async () => {
    const { engine, read } = await planeOf(64);
    const painted = async (word: string): Promise<Uint8Array> => {
      const bytes = svgOf(`<text x="2" y="9" font-size="9" fill="#ff0000">${word}</text>`);
      await engine.setAsset("drawing", { name: "words.svg", bytes });
      engine.setLayers([decal("a", "drawing", { projector: { ...FRONT, size: [1, 1, 1] } })], 1);
      return await read();
    };
    // Of a character that no font has the renderer draws its sign for that, or nothing.
    const unknown = await painted("漢");
    for (const word of ["א", "🎂", "&#x5d0;", "&#127874;"]) {
      const texels = await painted(word);
      expect(texels, word).not.toEqual(unknown);
      expect(
        texels.some((byte, index) => index % 4 === 1 && byte < 128),
        word,
      ).toBe(true);
    }
  });

  it("are sharp at any size of the target", async () => {
    const { engine, read } = await planeOf(512);
    await engine.setAsset("drawing", { name: "half.svg", bytes: RED_HALF });
    engine.setLayers([decal("a", "drawing", { projector: { ...FRONT, size: [1, 1, 1] } })], 1);
    const texels = await read();
    const mixed = Array.from({ length: 512 }, (_, x) => texels[4 * (256 * 512 + x) + 1] ?? 0);
    // From red to white within three texels: a drawing of 20 pixels' width would smear the edge over twenty.
    expect(mixed.filter((green) => green > 8 && green < 247).length).toBeLessThanOrEqual(3);
  });

  it("take the place of a picture of the same key, and give it back", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(0, 0, 0.5))], 1);
    const before = await allTexels(engine);
    await engine.setAsset("logo", { name: "half.svg", bytes: RED_HALF });
    const drawn = await allTexels(engine);
    expect(drawn).not.toEqual(before);
    await engine.removeAsset("logo");
    const without = await allTexels(engine);
    expect(without).not.toEqual(drawn);
    engine.setLayers([], 2);
    expect(await allTexels(engine)).toEqual(without);
  });

  it("run no scripts and fetch nothing", async () => {
    const { engine, read, errors } = await planeOf(64);
    const body = [
      '<script>throw new Error("ran")</script>',
      '<image href="http://127.0.0.1:9/a.png" width="20" height="10"/>',
      '<image href="file:///etc/hostname" width="20" height="10"/>',
      '<style>@import url("http://127.0.0.1:9/a.css");</style>',
      '<use href="http://127.0.0.1:9/a.svg#b"/>',
      '<foreignObject width="20" height="10"><p xmlns="http://www.w3.org/1999/xhtml">x</p></foreignObject>',
      '<path d="M0 0h20v10z" fill="#fff"/>',
    ].join("");
    await engine.setAsset("drawing", { name: "hostile.svg", bytes: svgOf(body) });
    engine.setLayers([decal("a", "drawing")], 1);
    expect((await read()).every((byte) => byte === 255)).toBe(true);
    expect(errors).toEqual([]);
  });

  const laughs = Array.from({ length: 9 }, (_, i) => `<!ENTITY l${i + 1} "${`&l${i};`.repeat(10)}">`).join("");
  const blowUp = `<!DOCTYPE svg [<!ENTITY a "${"a".repeat(10_000)}">]>`;
  const nested = Array.from({ length: 9 }, (_, i) => `<g id="u${i + 1}">${`<use href="#u${i}"/>`.repeat(10)}</g>`);
  it.each([
    ["that is not well-formed", svgOf("<rect"), "it is not well-formed"],
    ["that was cut short", svgOf("<rect").slice(0, -9), "it is not well-formed"],
    [
      "copied out of a web page",
      new TextEncoder().encode('<svg viewBox="0 0 2 1"><path d="M0 0h2v1z"/></svg>'),
      'it has no xmlns="http://www.w3.org/2000/svg"',
    ],
    ["without a size", svgOf("", 'width="0" height="0"'), "it has no width and height above 0"],
    ["without a height", svgOf("", 'height="0" viewBox="0 0 20 10"'), "it has no width and height above 0"],
    ["a million times as long as wide", svgOf("", 'viewBox="0 0 1 1000000"'), "times as long as wide"],
    [
      "whose entities laugh a billion times",
      svgOf("&l9;", undefined, `<!DOCTYPE svg [<!ENTITY l0 "ha">${laughs}]>`),
      "is made of other entities",
    ],
    ["whose entities blow up", svgOf(`<text>${"&a;".repeat(1000)}</text>`, undefined, blowUp), "grow beyond"],
    [
      "that uses itself a billion times",
      svgOf(`<g id="u0"/>${nested.join("")}<use href="#u9"/>`),
      "beyond all measure",
    ],
    ["nested beyond measure", svgOf("<g>".repeat(50_000) + "</g>".repeat(50_000)), "too many elements"],
    ["that is not text", new Uint8Array([...svgOf(""), 0xff, 0xfe, 0x80]), "neither UTF-8 nor UTF-16"],
  ])("are refused by name: one %s", async (_what, bytes, problem) => {
    const engine = startHost();
    const refused = await engine.setAsset("a", { name: "bad.svg", bytes }).catch((error: unknown) => error);
    expect(refused).toMatchObject({ code: "bad-picture", subject: "bad.svg" });
    expect((refused as Error).message).toContain("“bad.svg”");
    expect((refused as Error).message).toContain(problem);
    // And the next one is read as if nothing had been.
    expect(await engine.setAsset("b", { name: "half.svg", bytes: RED_HALF })).toEqual({ width: 20, height: 10 });
  });

  it("may name namespaces by entities, as drawing programs write them", async () => {
    const doctype = '<?xml version="1.0"?>\n<!-- made by hand -->\n<!DOCTYPE svg [<!ENTITY ns "http://x.example/">]>\n';
    const bytes = svgOf('<rect width="20" height="10"/>', 'xmlns:x="&ns;" viewBox="0 0 20 10"', doctype);
    expect(isSvg(bytes)).toBe(true);
    expect(await startHost().setAsset("a", { name: "a.svg", bytes })).toEqual({ width: 20, height: 10 });
  });

  it("are told from other XML and from words", () => {
    for (const other of ["<html><svg/></html>", "<?xml version='1.0'?><kml/>", "svg", ""])
      expect(isSvg(bytesOf(other))).toBe(false);
  });
});

describe("words as decals", () => {
  it("are painted by fonts that come with Texelcast, whatever was loaded before", async () => {
    const first = await planeOf(128);
    first.engine.setLayers([decal("a", ADA)], 1);
    const texels = await first.read();
    expect(texels.some((byte) => byte === 0)).toBe(true);
    const second = await planeOf(128);
    second.engine.setLayers([decal("a", { ...ADA, text: "Bob" })], 1);
    await second.engine.idle();
    second.engine.setLayers([decal("a", ADA)], 2);
    expect(await second.read()).toEqual(texels);
    expect(first.errors).toEqual([]);
  });

  it("are on a small texture what they are on a large one, seen from afar", async () => {
    const seen = async (size: number): Promise<Uint8Array> => {
      const { engine, read } = await planeOf(size);
      const projector = { ...FRONT, size: [0.8, 0.2, 1] } as const;
      engine.setLayers([decal("a", { ...ADA, text: "Ada Lovelace", color: [0, 0, 0, 1] }, { projector })], 1);
      return read();
    };
    const large = await seen(2048);
    for (const size of [64, 128, 512]) {
      const small = await seen(size);
      const times = 2048 / size;
      let squares = 0;
      let painted = 0;
      for (let texel = 0; texel < size * size; texel++) {
        const first = (Math.floor(texel / size) * 2048 + (texel % size)) * times;
        let sum = 0;
        for (let i = 0; i < times * times; i++)
          sum += large[4 * (first + Math.floor(i / times) * 2048 + (i % times))] ?? 0;
        const mean = sum / times ** 2;
        const is = small[4 * texel] ?? 0;
        if (is === 255 && mean > 254) continue;
        squares += (is - mean) ** 2;
        painted++;
      }
      const decibel = 10 * Math.log10((255 ** 2 * painted) / squares);
      expect(decibel, `${size} x ${size}`).toBeGreaterThan(36);
    }
  });

  it("wait for a font of the user's, and are painted when it comes", async () => {
    const { engine, read, errors } = await planeOf(128);
    engine.setLayers([decal("a", { ...ADA, font: "mine" })], 1);
    const without = await read();
    expect(without.every((byte) => byte === 255)).toBe(true);
    const bytes = await readShippedFont("lobster-400");
    expect(await engine.setFont("mine", { name: "mine.ttf", bytes })).toEqual({ name: "Lobster Regular" });
    expect(await read()).not.toEqual(without);
    expect(errors).toEqual([]);
  });

  it("tell their size and what no font has", async () => {
    const { engine } = await planeOf(64);
    const { width, height, missing } = await engine.measureText({ ...ADA, text: "Ada漢" });
    expect(width).toBeGreaterThan(2);
    expect(height).toBeGreaterThan(1);
    expect(missing).toEqual(["漢"]);
    await expect(engine.measureText({ ...ADA, font: "none" })).rejects.toMatchObject({ code: "bad-argument" });
    await expect(engine.measureText({ ...ADA, font: "texelcast:fonts/none" })).rejects.toMatchObject({
      code: "bad-font",
    });
  });

  it("fail an export whose font cannot be had, and say so once in the meantime", async () => {
    const { engine, errors } = await planeOf(64);
    engine.setLayers([decal("a", { ...ADA, font: "texelcast:fonts/none" })], 1);
    await engine.idle();
    engine.setLayers([decal("a", { ...ADA, font: "texelcast:fonts/none" })], 2);
    await engine.idle();
    expect(errors).toMatchObject([{ code: "bad-font" }]);
    await expect(engine.exportPng(0)).rejects.toMatchObject({ code: "bad-font" });
  });

  it("leave no pictures behind while they are edited", async () => {
    const { engine } = await planeOf(64);
    const sizes: number[] = [];
    for (let i = 0; i < 30; i++) {
      engine.setLayers([decal("a", { ...ADA, text: `Ada ${i % 10}` })], i);
      await engine.idle();
      sizes.push((await engine.stats()).memoryUsedBytes);
    }
    expect(sizes.at(-1)).toBeLessThanOrEqual(Math.max(...sizes.slice(0, 10)));
  });
});

describe("how many pixels a drawing gets", () => {
  const target = {
    width: SIZE,
    height: SIZE,
    texelsPerMetre: 1000,
    boundsMin: [-1, -1, -1],
    boundsMax: [1, 1, 1],
  } as const;

  it("is enough for its footprint, in powers of two, so that a small drag changes nothing", () => {
    const sizes = [0.1, 0.101, 0.102, 0.103].map((side) =>
      rasterSize(2, footprintTexels({ ...FRONT, size: [side, side / 2, 1] }, target)),
    );
    expect(sizes).toEqual([
      [512, 256],
      [512, 256],
      [512, 256],
      [512, 256],
    ]);
    expect(rasterSize(0.5, [100, 200])).toEqual([512, 1024]);
    // Beyond a million pixels half of that is enough.
    expect(rasterSize(1, [600, 600])).toEqual([1024, 1024]);
  });

  it("has an upper bound, however large the box is", () => {
    expect(rasterSize(1, [1e9, 1e9])).toEqual([MOST_RASTER_PIXELS, MOST_RASTER_PIXELS]);
    expect(rasterSize(1000, [1e9, 1])).toEqual([MOST_RASTER_PIXELS, 4]);
    expect(rasterSize(1000, [0, 0])).toEqual([64, 1]);
  });

  it("follows every kind of projector", () => {
    const pose = { position: [0, 0, 2], rotation: [0, 0, 0, 1] } as const;
    const label = { kind: "cylindrical", ...pose, radius: 0.5, height: 0.2, arc: 180, depth: 0.1 } as const;
    expect(footprintTexels(label, target)).toEqual([500 * Math.PI, 200]);
    const stamp = { kind: "uv", center: [0, 0], size: [0.5, 0.25], angle: 30 } as const;
    expect(footprintTexels(stamp, target)).toEqual([SIZE / 2, SIZE / 4]);
    const lens = { kind: "perspective", ...pose, fov: 90, aspect: 2, near: 0.1, far: 100 } as const;
    const [wide, high] = footprintTexels(lens, target);
    expect(high).toBeCloseTo(4000, 6);
    expect(wide).toBeCloseTo(8000, 6);
  });
});

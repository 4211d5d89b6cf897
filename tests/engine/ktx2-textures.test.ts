import { afterEach, describe, expect, it } from "vitest";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { listOf } from "../../web/engine/gltf-json.ts";
import { decodeKtx2 } from "../../web/engine/ktx2-decoder.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { imageBytes } from "../../web/engine/model-textures.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { type BasisKind, KTX2_TEXTURE, ktx2File, ktx2Model, softPicture } from "../support/ktx2-file.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";
import { seeded } from "../support/seeded.ts";

afterEach(endHosts);

const SOFT = softPicture(64, 32);

/** Of all four channels. */
function decibel(a: Uint8Array, b: Uint8Array): number {
  expect(a.length).toBe(b.length);
  const squares = a.reduce((sum, value, i) => sum + (value - (b[i] ?? 0)) ** 2, 0);
  return 10 * Math.log10((255 * 255 * a.length) / squares);
}

const KINDS: readonly (readonly [BasisKind, number])[] = [
  ["ETC1S", 36],
  ["UASTC", 44],
  ["UASTC, packed by Zstandard", 44],
];

describe("a KTX2 texture", () => {
  it.each(KINDS)("of %s is read as near as its compression allows (%i dB)", async (kind, least) => {
    const { width, height, rgba } = await decodeKtx2(await ktx2File(SOFT, kind), "soft");
    expect([width, height]).toEqual([64, 32]);
    expect(decibel(rgba, SOFT.rgba)).toBeGreaterThan(least);
  });

  it.each([
    [30, 18],
    [1, 1],
    [5, 3],
  ])("of %i × %i pixels has as many, though its blocks have four a side", async (width, height) => {
    const picture = softPicture(width, height);
    const read = await decodeKtx2(await ktx2File(picture, "UASTC"), "odd");
    expect([read.width, read.height]).toEqual([width, height]);
    expect(decibel(read.rgba, picture.rgba)).toBeGreaterThan(25);
  });

  it("gives the same bytes each time, also after one that was damaged", async () => {
    const file = await ktx2File(SOFT, "ETC1S");
    const first = await decodeKtx2(file, "soft");
    await expect(decodeKtx2(file.slice(0, file.length - 60), "cut")).rejects.toMatchObject({ code: "bad-picture" });
    expect(await decodeKtx2(file, "soft")).toEqual(first);
  });

  it.each([0, 11, 40, 79, 200, 1000])("that ends after %i bytes is refused by its name", async (length) => {
    const file = await ktx2File(SOFT, "UASTC");
    await expect(decodeKtx2(file.slice(0, length), "m.glb, paint")).rejects.toMatchObject({
      code: "bad-picture",
      subject: "m.glb, paint",
    });
  });

  it("is read or refused by its name, whatever of its bytes is changed", async () => {
    const file = await ktx2File(SOFT, "ETC1S");
    const random = seeded(7);
    for (let i = 0; i < 60; i++) {
      const changed = file.slice();
      for (let k = 0; k < 3; k++) changed[Math.floor(random() * 300)] = Math.floor(random() * 256);
      const read = await decodeKtx2(changed, "changed").catch((error: unknown) => error);
      if (read instanceof Error) expect(read).toMatchObject({ code: "bad-picture", subject: "changed" });
      else expect(read).toMatchObject({ rgba: expect.any(Uint8Array) });
    }
  });

  it.each([
    ["pixels across", 20, 60_000, "too-many-pixels"],
    ["pixels down", 24, 60_000, "too-many-pixels"],
    ["pictures in an array", 32, 3, "ktx2-kind"],
    ["faces of a cube", 36, 6, "ktx2-kind"],
  ])("that claims other %s is refused", async (_, offset, value, reason) => {
    const file = (await ktx2File(SOFT, "UASTC")).slice();
    new DataView(file.buffer).setUint32(offset, value, true);
    await expect(decodeKtx2(file, "claims")).rejects.toMatchObject({ code: "bad-picture", reason });
  });
});

describe("a model with KTX2 textures alone", () => {
  it("has them as PNG for what shows it, with every index as it was", async () => {
    const ktx2 = await ktx2File(SOFT, "ETC1S");
    const png = solidPng(2, 2, [9, 9, 9, 255]);
    const images = [
      { bytes: png, mimeType: "image/png" },
      { bytes: ktx2, mimeType: "image/ktx2", name: "paint" },
    ];
    const textures = [{ source: 0 }, { extensions: { [KTX2_TEXTURE]: { source: 1 } } }];
    const loaded = await loadModelFile({ name: "k.glb", bytes: ktx2Model(ktx2, { images, textures }) });
    const { json, binary } = readContainer({ name: "shown", bytes: loaded.glb });
    expect(json.textures).toEqual([{ source: 0 }, { source: 1, extensions: {} }]);
    expect(json.extensionsUsed).toBeUndefined();
    expect(json.extensionsRequired).toBeUndefined();
    expect(imageBytes(json, binary, 0, "k.glb")?.bytes).toEqual(png);
    const shown = imageBytes(json, binary, 1, "k.glb");
    expect(await decodePicture(shown?.bytes ?? png, "shown")).toEqual(await decodeKtx2(ktx2, "paint"));
  });

  it("is painted on what they show", async () => {
    const ktx2 = await ktx2File(SOFT, "UASTC");
    const engine = startHost();
    const info = await engine.loadModel({ name: "k.glb", bytes: ktx2Model(ktx2) });
    expect(info.materials[0]).toMatchObject({ textureSize: [64, 32] });
    await engine.openTarget({ material: 0 });
    expect((await decodePicture(await engine.exportPng(0), "painted")).rgba).toEqual(
      (await decodeKtx2(ktx2, "paint")).rgba,
    );
  });

  it("is written with the painted texture as PNG and the others as they came", async () => {
    const ktx2 = await ktx2File(SOFT, "ETC1S");
    const other = await ktx2File(softPicture(8, 8), "UASTC");
    const bytes = ktx2Model(ktx2, {
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, normalTexture: { index: 1 } }],
      textures: [{ extensions: { [KTX2_TEXTURE]: { source: 0 } } }, { extensions: { [KTX2_TEXTURE]: { source: 1 } } }],
      images: [
        { bytes: ktx2, mimeType: "image/ktx2" },
        { bytes: other, mimeType: "image/ktx2" },
      ],
    });
    const engine = startHost();
    await engine.loadModel({ name: "k.glb", bytes });
    await engine.openTarget({ material: 0 });
    const { json, binary } = readContainer({ name: "written", bytes: await engine.exportGlb() });
    expect(listOf(json, "images", "written")[0]?.mimeType).toBe("image/png");
    expect(json.textures).toEqual([{ source: 0 }, { extensions: { [KTX2_TEXTURE]: { source: 1 } } }]);
    expect(json.extensionsRequired).toEqual([KTX2_TEXTURE]);
    expect(imageBytes(json, binary, 1, "written")?.bytes).toEqual(other);
  });

  it("is refused with the name of a damaged one, and what was open stays", async () => {
    const ktx2 = await ktx2File(SOFT, "ETC1S");
    const engine = startHost();
    await engine.loadModel({ name: "good.glb", bytes: ktx2Model(ktx2) });
    await engine.openTarget({ material: 0 });
    const before = await engine.hash(0);
    const broken = { name: "broken.glb", bytes: ktx2Model(ktx2.slice(0, 150)) };
    await expect(engine.loadModel(broken)).rejects.toMatchObject({
      code: "bad-picture",
      subject: "broken.glb, paint",
      hint: "Save or download it again.",
    });
    expect(await engine.hash(0)).toBe(before);
  });
});

describe("a texture that offers a plain picture beside KTX2", () => {
  it("is read from the plain one, even where the extension is required", async () => {
    const png = solidPng(4, 4, [10, 200, 30, 255]);
    const engine = startHost();
    const bytes = ktx2Model(await ktx2File(SOFT, "ETC1S"), {
      textures: [{ source: 1, extensions: { [KTX2_TEXTURE]: { source: 0 } } }],
      images: [
        { bytes: Uint8Array.of(1, 2, 3, 4), mimeType: "image/ktx2" },
        { bytes: png, mimeType: "image/png" },
      ],
    });
    await engine.loadModel({ name: "both.glb", bytes });
    await engine.openTarget({ material: 0 });
    const painted = await decodePicture(await engine.exportPng(0), "painted");
    expect([painted.width, ...painted.rgba.subarray(0, 4)]).toEqual([4, 10, 200, 30, 255]);
  });
});

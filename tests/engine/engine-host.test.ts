import { afterEach, describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { TargetOptions } from "../../web/engine/engine-api.ts";
import { baseTextureSize, loadModelFile } from "../../web/engine/model-loader.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { decal } from "../support/layers.ts";
import { buildGlb, cube, plane, sphere } from "../support/model-builder.ts";
import {
  allTexels,
  at,
  CHART,
  endHosts,
  paintablePlane,
  SIZE,
  startHost,
  texturedPlane,
} from "../support/painted-plane.ts";
import { paintPng, solidPng } from "../support/png-file.ts";

afterEach(endHosts);

const RED = [255, 0, 0, 255] as const;

describe("a loaded model", () => {
  it("is described with its materials, their names and their pictures' sizes", async () => {
    const engine = startHost();
    const info = await engine.loadModel({
      name: "two.glb",
      bytes: buildGlb({
        ...texturedPlane,
        meshes: [plane(2, 0), { positions: cube().positions, indices: [0, 1, 2] }],
      }),
    });
    expect(info).toMatchObject({ name: "two.glb", triangles: 3, boundsMin: [-1, -1, 0], boundsMax: [1, 1, 0.5] });
    expect(info.materials).toMatchObject([
      { index: 0, name: "label", refusal: null, triangles: 2, textureSize: [SIZE, SIZE], uvMin: [0, 0], uvMax: [1, 1] },
      { index: 1, name: "", refusal: { code: "no-uvs" }, triangles: 1, textureSize: null },
    ]);
  });

  it.each([
    ["bytes", (glb: Uint8Array) => glb],
    // Its slice shares memory.
    ["a Buffer", (glb: Uint8Array) => Buffer.from(glb)],
  ])("of %s is handed out as a GLB of its own, and either may be changed", async (_, given) => {
    const engine = startHost();
    const bytes = given(buildGlb(texturedPlane));
    const info = await engine.loadModel({ name: "plane.glb", bytes });
    info.glb.fill(0);
    bytes.fill(0);
    await engine.openTarget({ material: 0 });
    expect(await allTexels(engine)).toEqual((await decodePicture(CHART, "chart")).rgba);
    expect(Buffer.from((await engine.exportGlb()).subarray(0, 4)).toString()).toBe("glTF");
  });

  it("is not copied where the engine takes its bytes over, as a worker does, and keeps no GLB besides", async () => {
    const bytes = buildGlb(texturedPlane);
    const { original, glb } = await loadModelFile({ name: "plane.glb", bytes }, true);
    expect(original.binary?.buffer).toBe(bytes.buffer);
    expect((await loadModelFile({ name: "plane.glb", bytes })).original.binary?.buffer).not.toBe(bytes.buffer);
    expect(glb.buffer, "what is handed out").not.toBe(bytes.buffer);
  });

  it("has its pictures read for their size once, however many materials and targets ask for it", async () => {
    const model = await loadModelFile({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    expect(await baseTextureSize(model, 0)).toEqual([SIZE, SIZE]);
    // Were it read again, it would be damaged.
    model.packed.binary?.fill(0);
    expect(await baseTextureSize(model, 0)).toEqual([SIZE, SIZE]);
  });

  it("stays when loading another one fails", async () => {
    const { engine } = await paintablePlane();
    const before = await engine.hash(0);
    const broken = { name: "broken.glb", bytes: new TextEncoder().encode("glTF?") };
    await expect(engine.loadModel(broken)).rejects.toMatchObject({ code: "bad-container", subject: "broken.glb" });
    expect(await engine.hash(0)).toBe(before);
  });

  it("is named in what the core says about it", async () => {
    const nowhere = { ...plane(), positions: [Number.NaN, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] };
    const attempt = startHost().loadModel({ name: "nan.glb", bytes: buildGlb({ meshes: [nowhere] }) });
    await expect(attempt).rejects.toMatchObject({ code: "bad-geometry", subject: "nan.glb" });
    await expect(attempt).rejects.toThrow(/“nan\.glb”/);
    await expect(attempt, "and what to do").rejects.toMatchObject({ hint: expect.stringContaining("glTF Validator") });
  });

  it.each<[string, Parameters<typeof buildGlb>[0], string]>([
    ["indices out of range", { meshes: [{ ...plane(), indices: [0, 1, 4] }] }, "bad-geometry"],
    ["no triangles", { meshes: [{ ...plane(), indices: [0, 1] }] }, "no-triangles"],
    [
      "an infinite position",
      { meshes: [{ ...plane(), positions: [1 / 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] }] },
      "bad-geometry",
    ],
    ["no mesh at all", { meshes: [plane()], more: { meshes: [], nodes: [{}] } }, "no-triangles"],
    [
      "an extension that it requires and nobody knows",
      { meshes: [plane()], more: { extensionsUsed: ["ACME_x"], extensionsRequired: ["ACME_x"] } },
      "unsupported-model",
    ],
  ])("is refused with %s", async (_, parts, code) => {
    await expect(startHost().loadModel({ name: "m.glb", bytes: buildGlb(parts) })).rejects.toMatchObject({ code });
  });
});

describe("a target", () => {
  it("has its own picture's size, or the size that is asked for, or 1024", async () => {
    const engine = startHost();
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    expect(await engine.openTarget({ material: 0 })).toMatchObject({ width: SIZE, height: SIZE });
    expect(await engine.openTarget({ material: 0, width: 128 })).toMatchObject({ width: 128, height: 128 });
    expect(await engine.openTarget({ material: 0, width: 32, height: 16 })).toMatchObject({ width: 32, height: 16 });
    const base = { name: "base.png", bytes: solidPng(20, 30, RED) };
    expect(await engine.openTarget({ material: 0, base })).toMatchObject({ width: 20, height: 30 });
    await engine.loadModel({ name: "bare.glb", bytes: buildGlb({ meshes: [plane()] }) });
    expect(await engine.openTarget({ material: 0 })).toMatchObject({ width: 1024, height: 1024 });
  });

  it("lies on the material's own picture, byte for byte at its own size", async () => {
    const { engine } = await paintablePlane();
    expect(await allTexels(engine)).toEqual((await decodePicture(CHART, "chart")).rgba);
  });

  it("resamples a pixel-art picture without mixing its pixels", async () => {
    const engine = startHost();
    const image = paintPng(2, 1, (x) => (x === 0 ? [0, 0, 0, 255] : [255, 255, 255, 255]));
    const parts = { ...texturedPlane, images: [{ bytes: image, mimeType: "image/png" }] };
    const greys = async (magFilter: number): Promise<Set<number>> => {
      const samplers = [{ magFilter }];
      const bytes = buildGlb({ ...parts, textures: [{ source: 0, sampler: 0 }], samplers });
      await engine.loadModel({ name: "art.glb", bytes });
      await engine.openTarget({ material: 0, width: 16, height: 16 });
      return new Set((await engine.readTexels(0, 0, 0, 16, 16)).filter((_, i) => i % 4 === 0));
    };
    expect(await greys(9728)).toEqual(new Set([0, 255]));
    expect((await greys(9729)).size).toBeGreaterThan(2);
  });

  it("lies on the material's colour, or white, when it has no picture", async () => {
    const engine = startHost();
    const materials = [{ pbrMetallicRoughness: { baseColorFactor: [1, 0, 0.21404114048223255, 0.5] } }, {}];
    const bytes = buildGlb({ meshes: [plane(1, 0), plane(1, 1)], materials });
    await engine.loadModel({ name: "colours.glb", bytes });
    await engine.openTarget({ material: 0, width: 4 });
    await engine.openTarget({ material: 1, width: 4 });
    expect([...(await engine.readTexels(0, 1, 1, 1, 1))]).toEqual([255, 0, 128, 128]);
    expect([...(await engine.readTexels(1, 1, 1, 1, 1))]).toEqual([255, 255, 255, 255]);
  });

  it("lies on a colour or a picture that is given instead", async () => {
    const { engine } = await paintablePlane();
    await engine.openTarget({ material: 0, width: 8, base: [1, 0.5, 0, 1] });
    expect([...(await engine.readTexels(0, 3, 3, 1, 1))]).toEqual([255, 128, 0, 255]);
    await engine.openTarget({ material: 0, base: { name: "red.png", bytes: solidPng(3, 3, [9, 8, 7, 6]) } });
    expect([...(await engine.readTexels(0, 1, 1, 1, 1))]).toEqual([9, 8, 7, 6]);
    const base = { name: "b.txt", bytes: new TextEncoder().encode("no") };
    await expect(engine.openTarget({ material: 0, base })).rejects.toMatchObject({
      code: "bad-picture",
      subject: "b.txt",
    });
  });

  it.each([[[255, 0, 0, 1]], [[1, 1, 1]], [[1, 1, 1, 1, 1]], [["1", 0, 0, 1]], ["white"], [null]])(
    "does not lie on %j, which is no colour",
    async (base) => {
      const { engine } = await paintablePlane();
      const options = { material: 0, width: 8, base } as unknown as TargetOptions;
      await expect(engine.openTarget(options)).rejects.toMatchObject({ code: "bad-argument", field: "base" });
    },
  );

  it.each([
    [{ width: 0 }, "bad-size"],
    [{ width: 64, height: 8193 }, "bad-size"],
    [{ width: 1.5 }, "bad-argument"],
    [{ width: -4 }, "bad-argument"],
    [{ gutter: 65 }, "bad-argument"],
    [{ material: 3 }, "no-material"],
  ])("is refused with %o", async (options, code) => {
    const { engine } = await paintablePlane();
    await expect(engine.openTarget({ material: 0, ...options })).rejects.toMatchObject({ code });
    expect(await engine.hash(0)).toMatch(/^[0-9a-f]{16}$/);
  });

  it("cannot be opened without a model, nor read without being open", async () => {
    const engine = startHost();
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({ code: "no-model" });
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await expect(engine.hash(0)).rejects.toMatchObject({ code: "bad-argument", field: "material" });
    await engine.openTarget({ material: 0 });
    await expect(engine.readTexels(0, 60, 0, 5, 1)).rejects.toMatchObject({ code: "bad-argument", field: "region" });
    await engine.closeTarget(0);
    await expect(engine.exportPng(0)).rejects.toMatchObject({ code: "bad-argument" });
  });

  it("says that a DDS texture cannot be decoded, and what to do", async () => {
    const engine = startHost();
    const textures = [{ extensions: { MSFT_texture_dds: { source: 0 } } }];
    const more = { extensionsUsed: ["MSFT_texture_dds"] };
    await engine.loadModel({ name: "k.glb", bytes: buildGlb({ ...texturedPlane, textures, more }) });
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "unsupported",
      subject: "k.glb",
      hint: /PNG/,
    });
    expect(await engine.openTarget({ material: 0, width: 8, base: [1, 1, 1, 1] })).toMatchObject({ width: 8 });
  });

  it("names the model and the picture that is damaged", async () => {
    const engine = startHost();
    const images = [{ bytes: CHART.slice(0, 90), mimeType: "image/png", name: "front" }];
    const info = await engine.loadModel({ name: "d.glb", bytes: buildGlb({ ...texturedPlane, images }) });
    expect(info.materials[0]?.textureSize).toBeNull();
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "bad-picture",
      subject: "d.glb, front",
    });
  });

  it("is baked once for its size, however often it is opened", async () => {
    const { engine } = await paintablePlane();
    for (let i = 0; i < 3; i++) await engine.openTarget({ material: 0, base: [0, 0, 0, 1] });
    await engine.closeTarget(0);
    await engine.openTarget({ material: 0, mipmaps: true });
    expect((await engine.stats()).bakeCount).toBe(1);
    await engine.openTarget({ material: 0, width: 96 });
    expect((await engine.stats()).bakeCount).toBe(2);
  });

  it("reports its bake's progress up to the end, in steps that let other work through", async () => {
    const engine = startHost();
    await engine.loadModel({ name: "ball.glb", bytes: buildGlb({ meshes: [sphere(128, 64)] }) });
    const shares: number[] = [];
    let turns = 0;
    const timer = setInterval(() => turns++, 0);
    await engine.openTarget({ material: 0, width: 2048 }, (share) => shares.push(share));
    clearInterval(timer);
    expect(shares.length).toBeGreaterThan(3);
    expect(shares.at(-1)).toBe(1);
    expect(shares).toEqual(shares.toSorted((a, b) => a - b));
    expect(turns).toBeGreaterThan(1);
  });

  it("keeps the old one when its bake is cancelled", async () => {
    const { engine } = await paintablePlane();
    const before = await engine.hash(0);
    const cancel = new AbortController();
    const opening = engine.openTarget({ material: 0, width: 4096 }, () => cancel.abort(), cancel.signal);
    await expect(opening).rejects.toMatchObject({ code: "cancelled", name: "AbortError" });
    expect(await engine.hash(0)).toBe(before);
    expect((await engine.stats()).bakeCount).toBe(1);
    const aborted = engine.openTarget({ material: 0 }, undefined, AbortSignal.abort());
    await expect(aborted).rejects.toMatchObject({ code: "cancelled" });
  });

  it("is refused beyond the memory budget, which leaves the engine usable", async () => {
    const engine = startHost({ memoryBudgetMib: 8 });
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await expect(engine.openTarget({ material: 0, width: 4096 })).rejects.toMatchObject({ code: "out-of-budget" });
    expect(await engine.openTarget({ material: 0 })).toMatchObject({ width: SIZE });
    const { memoryUsedBytes, memoryBudgetBytes } = await engine.stats();
    expect(memoryBudgetBytes).toBe(8 * 2 ** 20);
    expect(memoryUsedBytes).toBeLessThanOrEqual(memoryBudgetBytes);
  });

  it("shows its map as pictures and as numbers", async () => {
    const { engine } = await paintablePlane();
    const normals = await engine.viewMap(0, "normals");
    expect([...normals.rgba.subarray(0, 4)]).toEqual([128, 128, 255, 255]);
    expect(await engine.viewMap(0, "coverage")).toMatchObject({ width: SIZE, height: SIZE });
    const positions = await engine.readMapRows(0, "positions", SIZE - 1, 1);
    expect(positions).toHaveLength(SIZE * 3);
    expect(positions[1]).toBeCloseTo(-0.5 + 0.5 / SIZE, 4);
    expect(await engine.readMapRows(0, "overlap", 0, 1)).toEqual(new Uint8Array(SIZE).fill(1));
    expect([...(await engine.uvTriangles(0))]).toEqual([0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0]);
  });
});

describe("the hash", () => {
  it("is FNV-1a over the region's bytes", async () => {
    const { engine } = await paintablePlane();
    const region = { x: 3, y: 5, width: 20, height: 9 };
    let expected = 0xcbf29ce484222325n;
    for (const byte of await engine.readTexels(0, 3, 5, 20, 9)) {
      expected = BigInt.asUintN(64, (expected ^ BigInt(byte)) * 0x100000001b3n);
    }
    expect(await engine.hash(0, region)).toBe(expected.toString(16).padStart(16, "0"));
  });
});

describe("the exported PNG", () => {
  it("holds the finished texture, byte for byte", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(0.1, 0.2, 0.6))], 1);
    const { rgba } = await decodePicture(await engine.exportPng(0), "out.png");
    expect(rgba).toEqual(await allTexels(engine));
  });
});

describe("an engine", () => {
  it("does calls in the order in which they were made", async () => {
    const engine = startHost();
    const calls = [
      engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) }),
      engine.openTarget({ material: 0 }),
      engine.hash(0),
      engine.loadModel({ name: "bare.glb", bytes: buildGlb({ meshes: [plane()] }) }),
      engine.hash(0),
    ] as const;
    await Promise.all(calls.slice(0, 4));
    await expect(calls[4]).rejects.toMatchObject({ code: "bad-argument" });
  });

  it("rejects everything once it was ended, also what was under way", async () => {
    const { engine } = await paintablePlane();
    const opening = engine.openTarget({ material: 0, width: 4096 }, () => engine.dispose());
    await expect(opening).rejects.toMatchObject({ code: "disposed" });
    await expect(engine.stats()).rejects.toMatchObject({ code: "disposed" });
    engine.setLayers([], 1);
    engine.dispose();
  });

  it("says what is wrong with its WebAssembly at the first call", async () => {
    const engine = startHost({ wasm: new TextEncoder().encode("nonsense") });
    await expect(engine.stats()).rejects.toThrow(TexelcastError);
    await expect(engine.stats()).rejects.toMatchObject({ code: "unsupported" });
  });
});

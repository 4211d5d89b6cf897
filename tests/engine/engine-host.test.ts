import { afterEach, describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { EngineLayer, TargetUpdate } from "../../web/engine/engine-api.ts";
import { createEngineHost, type EngineHost, type EngineHostOptions } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { decal, FRONT, fill } from "../support/layers.ts";
import { buildGlb, cube, cylinder, plane, sphere } from "../support/model-builder.ts";
import { paintPng, solidPng } from "../support/png-file.ts";

const SIZE = 64;
const RED = [255, 0, 0, 255] as const;
const CHART = paintPng(SIZE, SIZE, (x, y) => [x * 4, y * 4, (x * y) % 256, 255]);
const LOGO = paintPng(16, 16, (x, y) => [255 - x, y * 9, 40, x < 2 ? 0 : 200]);

const texturedPlane = {
  meshes: [plane(1, 0)],
  materials: [{ name: "label", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  textures: [{ source: 0 }],
  images: [{ bytes: CHART, mimeType: "image/png" }],
};

const engines: EngineHost[] = [];
afterEach(() => {
  for (const engine of engines.splice(0)) engine.dispose();
});

function host(options: EngineHostOptions = {}): EngineHost {
  const engine = createEngineHost(options);
  engines.push(engine);
  return engine;
}

/** A host with the plane open for painting and a logo to paint with. */
async function paintablePlane(): Promise<{ engine: EngineHost; updates: TargetUpdate[] }> {
  const engine = host();
  const updates: TargetUpdate[] = [];
  engine.onUpdate((update) => updates.push(update));
  await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
  await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
  await engine.openTarget({ material: 0 });
  await engine.idle();
  return { engine, updates };
}

const texels = (engine: EngineHost, material = 0): Promise<Uint8Array> => engine.readTexels(material, 0, 0, SIZE, SIZE);
const coded = (code: string): unknown => expect.objectContaining({ code });

function at(x: number, y: number, size = 0.25): Partial<ReturnType<typeof decal>> {
  return { projector: { ...FRONT, position: [x, y, 0], size: [size, size, 0.5] } };
}

describe("a loaded model", () => {
  it("is described with its materials, their names and their pictures' sizes", async () => {
    const engine = host();
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

  it("is handed out as a GLB of its own, which the receiver may change", async () => {
    const engine = host();
    const bytes = buildGlb(texturedPlane);
    const info = await engine.loadModel({ name: "plane.glb", bytes });
    info.glb.fill(0);
    bytes.fill(0);
    await engine.openTarget({ material: 0 });
    expect(await texels(engine)).toEqual((await decodePicture(CHART, "chart")).rgba);
    expect(Buffer.from((await engine.exportGlb()).subarray(0, 4)).toString()).toBe("glTF");
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
    const attempt = host().loadModel({ name: "nan.glb", bytes: buildGlb({ meshes: [nowhere] }) });
    await expect(attempt).rejects.toMatchObject({ code: "bad-geometry", subject: "nan.glb" });
    await expect(attempt).rejects.toThrow(/“nan\.glb”/);
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
    await expect(host().loadModel({ name: "m.glb", bytes: buildGlb(parts) })).rejects.toMatchObject({ code });
  });
});

describe("a target", () => {
  it("has its own picture's size, or the size that is asked for, or 1024", async () => {
    const engine = host();
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
    expect(await texels(engine)).toEqual((await decodePicture(CHART, "chart")).rgba);
  });

  it("resamples a pixel-art picture without mixing its pixels", async () => {
    const engine = host();
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
    const engine = host();
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
    await expect(engine.openTarget({ material: 0, base: [255, 0, 0, 1] })).rejects.toMatchObject({
      code: "bad-argument",
    });
    const base = { name: "b.txt", bytes: new TextEncoder().encode("no") };
    await expect(engine.openTarget({ material: 0, base })).rejects.toMatchObject({
      code: "bad-picture",
      subject: "b.txt",
    });
  });

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
    const engine = host();
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({ code: "no-model" });
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await expect(engine.hash(0)).rejects.toMatchObject({ code: "bad-argument", field: "material" });
    await engine.openTarget({ material: 0 });
    await expect(engine.readTexels(0, 60, 0, 5, 1)).rejects.toMatchObject({ code: "bad-argument", field: "region" });
    await engine.closeTarget(0);
    await expect(engine.exportPng(0)).rejects.toMatchObject({ code: "bad-argument" });
  });

  it("says that a KTX2 texture cannot be decoded, and what to do", async () => {
    const engine = host();
    const textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
    const more = { extensionsUsed: ["KHR_texture_basisu"] };
    await engine.loadModel({ name: "k.glb", bytes: buildGlb({ ...texturedPlane, textures, more }) });
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "unsupported",
      subject: "k.glb",
      hint: /PNG/,
    });
    expect(await engine.openTarget({ material: 0, width: 8, base: [1, 1, 1, 1] })).toMatchObject({ width: 8 });
  });

  it("names the model and the picture that is damaged", async () => {
    const engine = host();
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
    const engine = host();
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
    const engine = host({ memoryBudgetMib: 8 });
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

describe("updates", () => {
  it("report every texel of a new target first", async () => {
    const { engine, updates } = await paintablePlane();
    expect(updates).toHaveLength(1);
    expect(patched(new Uint8Array(SIZE * SIZE * 4), updates)).toEqual(await texels(engine));
  });

  it("cover exactly what changed, whatever is done to the layers", async () => {
    const { engine, updates } = await paintablePlane();
    let known = await texels(engine);
    const a = decal("a", "logo", at(-0.2, 0.1));
    const b = decal("b", "logo", { ...at(0, 0.05, 0.4), opacity: 0.5 });
    const steps: EngineLayer[][] = [
      [a],
      [a, b],
      [b, a],
      [b, decal("a", "logo", at(0.3, -0.2))],
      [{ ...b, visible: false }, a],
      [fill("f", [0, 0, 1, 0.5]), a],
      [a],
      [],
    ];
    for (const [revision, layers] of steps.entries()) {
      updates.length = 0;
      engine.setLayers(layers, revision);
      await engine.idle();
      const now = await texels(engine);
      expect(patched(known, updates)).toEqual(now);
      expect(updates.every((update) => update.revision === revision)).toBe(true);
      expect(touchesOnlyNear(known, now, updates)).toBe(true);
      known = now;
    }
    expect(known).toEqual((await decodePicture(CHART, "chart")).rgba);
  });

  it("report only where a moved decal was and is, and project that decal alone", async () => {
    const { engine, updates } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(-0.3, -0.3, 0.1)), decal("b", "logo", at(0.3, 0.3, 0.1))], 1);
    await engine.idle();
    updates.length = 0;
    engine.setLayers([decal("a", "logo", at(-0.25, -0.3, 0.1)), decal("b", "logo", at(0.3, 0.3, 0.1))], 2);
    await engine.idle();
    expect(updates).toHaveLength(1);
    expect(updates[0]).toMatchObject({ projectedLayers: 1, material: 0, revision: 2 });
    const area = (updates[0]?.rects ?? []).reduce((sum, rect) => sum + rect.width * rect.height, 0);
    expect(area).toBeLessThanOrEqual((SIZE * SIZE) / 4);
  });

  it("do not come when nothing changed", async () => {
    const { engine, updates } = await paintablePlane();
    const layers = [decal("a", "logo")];
    engine.setLayers(layers, 1);
    await engine.idle();
    const { projectionCount } = await engine.stats();
    updates.length = 0;
    engine.setLayers(structuredClone(layers), 2);
    await engine.idle();
    expect(updates).toHaveLength(0);
    expect((await engine.stats()).projectionCount).toBe(projectionCount);
  });

  it("show the newest list only, when several came at once", async () => {
    const { engine, updates } = await paintablePlane();
    updates.length = 0;
    for (let i = 1; i <= 20; i++) engine.setLayers([decal("a", "logo", at(i / 50, 0))], i);
    await engine.idle();
    expect(updates.map((update) => update.revision)).toEqual([20]);
  });

  it("go on for other targets while one is being baked", async () => {
    const engine = host();
    const meshes = [plane(1, 0), sphere(128, 64, 1)];
    await engine.loadModel({ name: "two.glb", bytes: buildGlb({ meshes, materials: [{}, {}] }) });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.openTarget({ material: 0, width: SIZE });
    await engine.idle();
    const events: string[] = [];
    engine.onUpdate((update) => events.push(`update of ${update.material}`));
    const opening = engine.openTarget({ material: 1, width: 2048 }, () => {
      if (events.length === 0) engine.setLayers([decal("a", "logo", { occlusion: "none" })], 1);
    });
    await opening.then(() => events.push("opened 1"));
    expect(events[0]).toBe("update of 0");
  });

  it("report the whole mip chain when asked, each level in place", async () => {
    const { engine, updates } = await paintablePlane();
    updates.length = 0;
    const info = await engine.openTarget({ material: 0, mipmaps: true });
    expect(info.mipLevels).toBe(7);
    await engine.idle();
    const last = updates.flatMap((update) => update.rects.filter((rect) => rect.level === 6));
    expect(last).toMatchObject([{ x: 0, y: 0, width: 1, height: 1 }]);
    const bytes = updates.reduce((sum, update) => sum + update.bytes.length, 0);
    expect(bytes).toBe(4 * ((4 ** 7 - 1) / 3));
  });

  it("no longer reach a listener that unsubscribed", async () => {
    const { engine } = await paintablePlane();
    let count = 0;
    const unsubscribe = engine.onUpdate(() => count++);
    engine.setLayers([fill("f", [1, 0, 0, 1])], 1);
    await engine.idle();
    unsubscribe();
    engine.setLayers([], 2);
    await engine.idle();
    expect(count).toBe(1);
  });
});

describe("layers", () => {
  it("wait for their picture and their target", async () => {
    const engine = host();
    engine.setLayers([decal("a", "late")], 7);
    await engine.loadModel({ name: "plane.glb", bytes: buildGlb(texturedPlane) });
    await engine.openTarget({ material: 0 });
    const before = await engine.hash(0);
    await engine.setAsset("late", { name: "late.png", bytes: LOGO });
    const after = await engine.hash(0);
    expect(after).not.toBe(before);
    await engine.removeAsset("late");
    expect(await engine.hash(0)).toBe(before);
    await engine.setAsset("late", { name: "late.png", bytes: LOGO });
    expect(await engine.hash(0)).toBe(after);
  });

  it("follow their picture when it is replaced", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", { filter: "nearest" })], 1);
    await engine.setAsset("logo", { name: "red.png", bytes: solidPng(1, 1, RED) });
    expect([...(await engine.readTexels(0, SIZE / 2, SIZE / 2, 1, 1))]).toEqual([...RED]);
  });

  it("are drawn in their order, and the top one wins", async () => {
    const { engine } = await paintablePlane();
    const red = fill("red", [1, 0, 0, 1]);
    const blue = fill("blue", [0, 0, 1, 1]);
    const colour = async (layers: EngineLayer[]): Promise<number[]> => {
      engine.setLayers(layers, 0);
      return [...(await engine.readTexels(0, 5, 5, 1, 1))];
    };
    expect(await colour([red, blue])).toEqual([0, 0, 255, 255]);
    expect(await colour([blue, red])).toEqual([255, 0, 0, 255]);
    expect(await colour([blue, { ...red, visible: false }])).toEqual([0, 0, 255, 255]);
  });

  it("belong to their material alone", async () => {
    const engine = host();
    const meshes = [plane(1, 0), { ...plane(1, 1), positions: plane().positions.map((p, i) => (i % 3 === 2 ? 3 : p)) }];
    await engine.loadModel({ name: "two.glb", bytes: buildGlb({ meshes, materials: [{}, {}] }) });
    await engine.openTarget({ material: 0, width: 8 });
    await engine.openTarget({ material: 1, width: 8 });
    engine.setLayers([fill("a", [1, 0, 0, 1], { material: 1 }), fill("b", [0, 1, 0, 1], { material: 5 })], 1);
    expect([...(await engine.readTexels(0, 0, 0, 1, 1))]).toEqual([255, 255, 255, 255]);
    expect([...(await engine.readTexels(1, 0, 0, 1, 1))]).toEqual([255, 0, 0, 255]);
  });

  it("that cannot be drawn are reported once, by id, and leave the others alone", async () => {
    const { engine } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const bad = decal("bad", "logo", { projector: { ...FRONT, size: [0, 1, 1] } });
    engine.setLayers([bad, decal("good", "logo", at(0.1, 0.1))], 1);
    const withBad = await engine.hash(0);
    engine.setLayers([bad, decal("good", "logo", at(0.2, 0.1))], 2);
    await engine.idle();
    expect(errors).toEqual([expect.objectContaining({ code: "bad-argument", field: "layers[id=bad]" })]);
    engine.setLayers([decal("good", "logo", at(0.1, 0.1))], 3);
    expect(await engine.hash(0)).toBe(withBad);
    engine.setLayers([decal("bad", "logo")], 4);
    await engine.idle();
    engine.setLayers([bad], 5);
    await engine.idle();
    expect(errors).toHaveLength(2);
  });

  it("leave the base as it was once they are gone", async () => {
    const engine = host();
    const meshes = [cylinder(48, 0)];
    await engine.loadModel({ name: "mug.glb", bytes: buildGlb({ ...texturedPlane, meshes }) });
    await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
    await engine.openTarget({ material: 0 });
    const before = await texels(engine);
    const front = decal("a", "logo", { projector: { ...FRONT, position: [0, 0, 1], size: [1, 1, 1] } });
    engine.setLayers([front, { ...front, id: "b", lockAlpha: true, wrap: "repeat", flipX: true }], 1);
    expect(await texels(engine)).not.toEqual(before);
    engine.setLayers([], 2);
    expect(await texels(engine)).toEqual(before);
  });

  it("give the same bytes whatever happened before", async () => {
    const layers = [
      fill("f", [0.2, 0.4, 0.6, 0.5]),
      decal("a", "logo", at(0.1, 0.2, 0.6)),
      decal("b", "logo", at(0, 0, 0.3)),
    ];
    const straight = await paintablePlane();
    straight.engine.setLayers(layers, 1);
    const { engine } = await paintablePlane();
    for (const detour of [[...layers].reverse(), [decal("b", "logo", at(0.4, 0.4))], layers.slice(1), layers]) {
      engine.setLayers(detour, 0);
      await engine.idle();
    }
    expect(await engine.hash(0)).toBe(await straight.engine.hash(0));
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
    expect(rgba).toEqual(await texels(engine));
  });
});

describe("an engine", () => {
  it("does calls in the order in which they were made", async () => {
    const engine = host();
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
    const engine = host({ wasm: new TextEncoder().encode("nonsense") });
    await expect(engine.stats()).rejects.toThrow(TexelcastError);
    await expect(engine.stats()).rejects.toEqual(coded("unsupported"));
  });
});

/** What a receiver has after applying updates to the texels that it knew. */
function patched(known: Uint8Array, updates: readonly TargetUpdate[]): Uint8Array {
  const result = known.slice();
  for (const { rects, bytes } of updates) {
    for (const { x, y, width, height, level, byteOffset } of rects) {
      if (level !== 0) continue;
      for (let row = 0; row < height; row++) {
        const line = bytes.subarray(byteOffset + row * width * 4, byteOffset + (row + 1) * width * 4);
        result.set(line, ((y + row) * SIZE + x) * 4);
      }
    }
  }
  return result;
}

/** Whether no rectangle lies wholly where nothing changed, and none overlaps another. */
function touchesOnlyNear(before: Uint8Array, after: Uint8Array, updates: readonly TargetUpdate[]): boolean {
  const seen = new Set<number>();
  return updates.every(({ rects }) =>
    rects.every(({ x, y, width, height }) => {
      let changed = false;
      for (let row = y; row < y + height; row++) {
        for (let column = x; column < x + width; column++) {
          const texel = row * SIZE + column;
          if (seen.has(texel)) return false;
          seen.add(texel);
          for (let i = texel * 4; i < texel * 4 + 4; i++) changed ||= before[i] !== after[i];
        }
      }
      return changed;
    }),
  );
}

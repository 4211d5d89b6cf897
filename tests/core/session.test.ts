import { BufferGeometry, TorusGeometry } from "three";
import { beforeAll, beforeEach, describe, expect, it } from "vitest";
import {
  DabLayout,
  Filters,
  LayerDefLayout,
  LayerKinds,
  NONE,
  Occlusions,
  Projectors,
  Roles,
  TargetDefLayout,
  Tips,
  Wraps,
} from "../../web/core/abi.ts";
import { Session } from "../../web/core/session.ts";
import type { Target } from "../../web/core/target.ts";
import { type CoreModule, loadCore } from "../../web/core/wasm-module.ts";
import { buildGlb, cube, type MeshParts, plane } from "../support/model-builder.ts";

let core: CoreModule;
let session: Session;

beforeAll(async () => {
  core = await loadCore();
});

beforeEach(() => {
  session = Session.create(core);
});

function bake(target: Target): Target {
  while (!target.bake(1 << 20).done);
  return target;
}

function planeTarget(size = 32): Target {
  session.loadGlb(buildGlb({ meshes: [plane()] }));
  return bake(session.createTarget({ width: size, height: size }));
}

const RED = new Uint8Array([255, 0, 0, 255]);
const coded = (code: string): unknown => expect.objectContaining({ code });

/** All of them different, so that none can be taken for another. */
const PROJECTOR_FIELDS = {
  positionModel: [1.5, 2.5, 3.5],
  rotation: [0, 0, 1, 0],
  size: [4.5, 5.5, 6.5],
  fovDegrees: 7.5,
  aspect: 8.5,
  nearDistance: 9.5,
  farDistance: 10.5,
  radius: 11.5,
  height: 12.5,
  arcDegrees: 13.5,
  depth: 14.5,
  uvCenter: [15.5, 16.5],
  uvSize: [17.5, 18.5],
  uvAngleDegrees: 19.5,
};

describe("a session", () => {
  it("has the ABI's default budget, and any other that is asked for", () => {
    expect(session.stats().memoryBudgetKib).toBe(1024 * 1024);
    expect(Session.create(core, { memoryBudgetMib: 64 }).stats().memoryBudgetKib).toBe(64 * 1024);
  });

  it("refuses work beyond its budget and stays usable", () => {
    const small = Session.create(core, { memoryBudgetMib: 1 });
    small.loadGlb(buildGlb({ meshes: [plane()] }));
    expect(() => bake(small.createTarget({ width: 4096, height: 4096 }))).toThrow(coded("out-of-budget"));
    expect(bake(small.createTarget({ width: 64, height: 64 })).info().coveredTexels).toBe(64 * 64);
  });

  it("is stale once it was destroyed", () => {
    session.destroy();
    expect(() => session.stats()).toThrow(coded("stale-handle"));
    expect(() => session.destroy()).toThrow(coded("stale-handle"));
  });
});

describe("a model of raw arrays", () => {
  it("takes a three.js geometry's arrays as they are", () => {
    const torus = new TorusGeometry(1, 0.4, 24, 48);
    const array = (name: string): Float32Array => torus.getAttribute(name).array as Float32Array;
    const indices = torus.index?.array as Uint16Array;
    session.addMesh({ positions: array("position"), normals: array("normal"), uvs: array("uv"), indices });
    expect(session.modelInfo()).toMatchObject({ triangleCount: indices.length / 3, materialCount: 1 });
    const map = bake(session.createTarget({ width: 128, height: 128 })).info();
    expect(map.coveredTexels).toBe(128 * 128);
    expect(map.overlappingTexels).toBe(0);
  });

  it("bakes as the same geometry in a GLB does", () => {
    const parts = cube();
    session.addMesh(arraysOf(parts));
    const fromArrays = bake(session.createTarget({ width: 64, height: 64 })).readPositions(0, 64);
    const other = Session.create(core);
    other.loadGlb(buildGlb({ meshes: [parts] }));
    expect(fromArrays).toEqual(bake(other.createTarget({ width: 64, height: 64 })).readPositions(0, 64));
  });

  it("counts every three vertices as a triangle without indices", () => {
    const flat = new BufferGeometry().copy(new TorusGeometry(1, 0.4, 6, 8)).toNonIndexed();
    const array = (name: string): Float32Array => flat.getAttribute(name).array as Float32Array;
    session.addMesh({ positions: array("position"), uvs: array("uv") });
    expect(session.modelInfo().triangleCount).toBe(array("position").length / 9);
  });

  it("has as many materials as the highest number asks for", () => {
    session.addMesh({ ...arraysOf(plane()), material: 2 });
    expect(session.modelInfo().materialCount).toBe(3);
    expect(() => session.createTarget({ material: 0 })).toThrow(coded("no-triangles"));
    expect(bake(session.createTarget({ material: 2, width: 8, height: 8 })).info().coveredTexels).toBe(64);
  });

  it.each([
    ["normals", { normals: new Float32Array(11) }],
    ["uvs", { uvs: new Float32Array(9) }],
    ["positions", { positions: new Float32Array(13) }],
  ])("is refused when %s have a wrong length, naming them", (field, change) => {
    expect(() => session.addMesh({ ...arraysOf(plane()), ...change })).toThrow(
      expect.objectContaining({ code: "bad-argument", field }),
    );
  });

  it.each([
    [
      "a position is not a number",
      { positions: Float32Array.of(Number.NaN, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0) },
      "bad-geometry",
    ],
    [
      "a position is infinite",
      { positions: Float32Array.of(Number.POSITIVE_INFINITY, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0) },
      "bad-geometry",
    ],
    ["an index is out of range", { indices: Uint32Array.of(0, 1, 4) }, "bad-geometry"],
    ["it has no vertices", { positions: new Float32Array(), normals: null, uvs: null, indices: null }, "bad-argument"],
    ["the number of indices is no multiple of three", { indices: Uint32Array.of(0, 1, 2, 0) }, "bad-argument"],
  ])("is refused when %s", (_, change, code) => {
    expect(() => session.addMesh({ ...arraysOf(plane()), ...change })).toThrow(coded(code));
    expect(() => session.modelInfo()).toThrow(coded("no-model"));
  });
});

describe("a target", () => {
  it("has the ABI's defaults for what is left out", () => {
    session.loadGlb(buildGlb({ meshes: [plane()] }));
    expect(bake(session.createTarget()).info()).toMatchObject({ width: 1024, height: 1024, gutter: 2, mipLevels: 1 });
    const window = { textureWidth: 0, textureHeight: 0, windowX: 0, windowY: 0 };
    const given = { material: 0, width: 48, height: 20, gutter: 5, mipLevels: 0, ...window };
    expect(Object.keys(given)).toEqual(Object.keys(TargetDefLayout.fields));
    expect(bake(session.createTarget(given)).info()).toMatchObject({ width: 48, height: 20, gutter: 5, mipLevels: 6 });
  });

  it.each([
    [0, 64],
    [64, 0],
    [8193, 64],
    [64, 8193],
    [NONE, 1],
  ])("cannot be %i × %i texels", (width, height) => {
    session.loadGlb(buildGlb({ meshes: [plane()] }));
    expect(() => session.createTarget({ width, height })).toThrow(coded("bad-size"));
  });

  it("is refused with the reason when it cannot be painted", () => {
    expect(() => session.createTarget()).toThrow(coded("no-model"));
    session.loadGlb(buildGlb({ meshes: [{ positions: plane().positions, indices: [0, 1, 2] }] }));
    expect(() => session.createTarget()).toThrow(coded("no-uvs"));
    expect(() => session.createTarget({ material: 7 })).toThrow(coded("no-material"));
    session.loadGlb(buildGlb({ meshes: [plane(1, 1)], materials: [{}, {}] }));
    expect(() => session.createTarget({ material: 0 })).toThrow(coded("no-triangles"));
    session.loadGlb(buildGlb({ meshes: [{ ...plane(), uvs: [0, 1, Number.NaN, 1, 1, 0, 0, 0] }] }));
    expect(() => session.createTarget()).toThrow(coded("bad-uvs"));
  });

  it("cannot be read before its bake has finished", () => {
    session.loadGlb(buildGlb({ meshes: [plane()] }));
    const target = session.createTarget({ width: 512, height: 512 });
    expect(() => target.readCoverage(0, 1)).toThrow(coded("not-baked"));
    expect(() => target.update()).toThrow(coded("not-baked"));
  });

  it("bakes once for a material, size and gutter, however often it is made", () => {
    planeTarget(64).destroy();
    expect(session.stats().bakeCount).toBe(1);
    bake(session.createTarget({ width: 64, height: 64 }));
    const again = bake(session.createTarget({ width: 64, height: 64 }));
    expect(session.stats().bakeCount).toBe(1);
    expect(again.info().coveredTexels).toBe(64 * 64);
    bake(session.createTarget({ width: 64, height: 64, gutter: 9 }));
    bake(session.createTarget({ width: 64, height: 32 }));
    expect(session.stats().bakeCount).toBe(3);
  });

  it("keeps the model and its targets when loading another one fails", () => {
    const target = planeTarget();
    expect(() => session.loadGlb(new TextEncoder().encode("no model"))).toThrow(coded("bad-model"));
    expect(target.info().coveredTexels).toBe(32 * 32);
  });

  it("is stale once it was destroyed, and once another model was loaded", () => {
    const target = planeTarget();
    target.destroy();
    expect(() => target.update()).toThrow(coded("stale-handle"));
    const second = planeTarget();
    session.loadGlb(buildGlb({ meshes: [cube()] }));
    expect(() => second.info()).toThrow(coded("stale-handle"));
  });

  it("gives positions, normals, coverage and overlap of any rows", () => {
    const target = planeTarget(16);
    const positions = target.readPositions(3, 1);
    expect(positions[0]).toBeCloseTo(-0.5 + 0.5 / 16, 4);
    expect(positions[1]).toBeCloseTo(0.5 - 3.5 / 16, 4);
    expect([...target.readNormals(15, 1).slice(0, 3)]).toEqual([0, 0, 1]);
    expect(target.readCoverage(0, 16)).toEqual(new Uint8Array(256).fill(1));
    expect(target.readOverlap(0, 16)).toEqual(new Uint8Array(256).fill(1));
    expect(() => target.readCoverage(10, 7)).toThrow(coded("bad-argument"));
    expect(() => target.view(9, 0, 1)).toThrow(coded("bad-argument"));
  });

  it("refuses pictures whose bytes do not fit their size", () => {
    const target = planeTarget();
    expect(() => target.setBase(2, 2, new Uint8Array(15), Filters.linear)).toThrow(coded("bad-argument"));
    expect(() => session.createImage(2, 2, new Uint8Array(17))).toThrow(coded("bad-argument"));
    expect(() => session.createImage(0, 2, new Uint8Array())).toThrow(coded("bad-size"));
    expect(() => session.createImage(8193, 1, new Uint8Array(8193 * 4))).toThrow(coded("bad-size"));
  });
});

describe("a layer", () => {
  it("gives every field back as it was set", () => {
    const target = planeTarget();
    const image = session.createImage(1, 1, RED);
    const def = {
      kind: LayerKinds.decal,
      image,
      visible: 0,
      opacity: 0.25,
      blend: 0,
      blendSpace: 0,
      lockAlpha: 1,
      filter: Filters.nearest,
      wrap: Wraps.repeat,
      flipX: 1,
      flipY: 1,
      backfaces: 1,
      angleFadeStart: 12.5,
      angleFadeEnd: 34.5,
      occlusion: Occlusions.none,
      projector: 0,
      ...PROJECTOR_FIELDS,
      color: [0.125, 0.375, 0.625, 0.875],
      tip: Tips.mask,
      hardness: 0.0625,
      flow: 0.3125,
      parent: target.createLayer({ kind: LayerKinds.group }),
      role: Roles.mask,
      isolated: 1,
      invertMask: 1,
    };
    expect(Object.keys(def)).toEqual(Object.keys(LayerDefLayout.fields));
    const layer = target.createLayer({ image, size: [1, 1, 1] });
    target.updateLayer(layer, def);
    expect(target.layerDef(layer)).toEqual(def);
    expect(target.layerDef(target.createLayer(def))).toEqual(def);
  });

  it("gives a stroke's dabs back as they were added, with the defaults for what they left out", () => {
    const target = planeTarget();
    const layer = target.createLayer({ kind: LayerKinds.stroke });
    expect(target.dabs(layer)).toEqual([]);
    const dab = {
      flow: 0.25,
      flipX: 1,
      projector: Projectors.cylindrical,
      ...PROJECTOR_FIELDS,
    };
    expect(Object.keys(dab)).toEqual(Object.keys(DabLayout.fields));
    target.addDabs(layer, [dab, { size: [1, 2, 3] }]);
    target.addDabs(layer, []);
    expect(target.dabs(layer)[0]).toEqual(dab);
    expect(target.dabs(layer)[1]).toMatchObject({ flow: 1, projector: 0, rotation: [0, 0, 0, 1], size: [1, 2, 3] });
    expect(() => target.addDabs(layer, [{}, { flow: Number.NaN }])).toThrow(coded("bad-argument"));
    expect(target.dabs(layer)).toHaveLength(2);
    target.clearDabs(layer);
    expect(target.dabs(layer)).toEqual([]);
  });

  it("of one colour takes a gradient and triangles, and gives them up again", () => {
    const target = planeTarget();
    const fill = target.createLayer({ kind: LayerKinds.fill, color: [1, 0, 0, 1] });
    const { width, height } = target.info();
    const paint = (): string => {
      target.update();
      return target.hash(0, 0, width, height);
    };
    const plain = paint();
    target.setGradient(fill, { toModel: [1, 0, 0] });
    const coloured = paint();
    target.setTriangles(fill, Uint32Array.of(1));
    const half = paint();
    target.setTriangles(fill, new Uint32Array());
    expect(new Set([plain, coloured, half, paint()]).size).toBe(4);
    target.setTriangles(fill, null);
    expect(paint()).toBe(coloured);
    target.setGradient(fill, null);
    expect(paint()).toBe(plain);
    expect(() => target.setTriangles(fill, Uint32Array.of(99))).toThrow(coded("bad-argument"));
    expect(() => target.setGradient(fill, { stopCount: 1 })).toThrow(coded("bad-argument"));
  });

  it("has the design document's defaults for what is left out", () => {
    const target = planeTarget();
    const layer = target.createLayer({ image: session.createImage(1, 1, RED), size: [1, 1, 1] });
    expect(target.layerDef(layer)).toMatchObject({
      visible: 1,
      opacity: 1,
      blend: 0,
      blendSpace: 0,
      lockAlpha: 0,
      filter: Filters.linear,
      wrap: Wraps.none,
      flipX: 0,
      flipY: 0,
      backfaces: 0,
      angleFadeStart: 70,
      angleFadeEnd: 90,
      occlusion: Occlusions.self,
      rotation: [0, 0, 0, 1],
    });
  });

  it.each([
    ["kind", { kind: 99 }],
    ["opacity", { opacity: 1.5 }],
    ["opacity", { opacity: Number.NaN }],
    ["filter", { filter: 2 }],
    ["wrap", { wrap: 2 }],
    ["angle_fade", { angleFadeStart: 80, angleFadeEnd: 70 }],
    ["rotation", { rotation: [0, 0, 0, 0] }],
    ["size", { size: [1, 0, 1] }],
    ["size", { size: [1, -1, 1] }],
    ["position", { positionModel: [0, Number.NaN, 0] }],
  ])("is refused with a bad %s, which the message names, and stays as it was", (field, change) => {
    const target = planeTarget();
    const image = session.createImage(1, 1, RED);
    const layer = target.createLayer({ image, size: [1, 1, 1] });
    const before = target.layerDef(layer);
    const attempt = (): void => target.updateLayer(layer, { image, size: [1, 1, 1], ...change });
    expect(attempt).toThrow(coded("bad-argument"));
    expect(attempt).toThrow(new RegExp(field));
    expect(target.layerDef(layer)).toEqual(before);
  });

  it("is stale once it or its target was destroyed", () => {
    const target = planeTarget();
    const layer = target.createLayer({ kind: LayerKinds.fill });
    const other = target.createLayer({ kind: LayerKinds.fill });
    target.destroyLayer(layer);
    expect(() => target.destroyLayer(layer)).toThrow(coded("stale-handle"));
    expect(() => target.updateLayer(layer, {})).toThrow(coded("stale-handle"));
    expect(() => target.layerDef(layer)).toThrow(coded("stale-handle"));
    expect(() => target.moveLayer(0, 0)).toThrow(coded("stale-handle"));
    target.destroy();
    expect(() => target.layerDef(other)).toThrow(coded("stale-handle"));
  });

  it("turns transparent when its picture is destroyed", () => {
    const target = planeTarget();
    target.setBaseColor(10, 20, 30, 255);
    const image = session.createImage(1, 1, RED);
    target.createLayer({ image, size: [1, 1, 1], filter: Filters.nearest });
    target.update();
    expect([...target.read(0, 16, 16, 1, 1)]).toEqual([255, 0, 0, 255]);
    session.destroyImage(image);
    target.update();
    expect([...target.read(0, 16, 16, 1, 1)]).toEqual([10, 20, 30, 255]);
  });
});

function arraysOf(parts: MeshParts): {
  positions: Float32Array;
  normals: Float32Array;
  uvs: Float32Array;
  indices: Uint32Array;
} {
  return {
    positions: Float32Array.from(parts.positions),
    normals: Float32Array.from(parts.normals ?? []),
    uvs: Float32Array.from(parts.uvs ?? []),
    indices: Uint32Array.from(parts.indices ?? []),
  };
}

/** The recipe of tests/golden/README.md, for Node and for the page. */
import { readFileSync } from "node:fs";
import { BLEND_MODES } from "../../web/editor/document/design.ts";
import type { EngineDab, EngineDecalLayer, EngineLayer, Projector, Quaternion } from "../../web/engine/engine-api.ts";
import { decal, fill, group, stroke } from "./layers.ts";
import { buildGlb, type MeshParts } from "./model-builder.ts";
import { makePng } from "./png-file.ts";

/** 16 hex digits. */
export const manyLayersHash: string = JSON.parse(
  readFileSync(new URL("../golden/many_layers.hash", import.meta.url), "utf8"),
);

export const manyLayersSize = 512;
const SIDE = 17;

export function manyLayersModel(): Uint8Array {
  return buildGlb({ meshes: [patch(0), patch(1)], materials: [{ name: "paint" }] });
}

function patch(p: number): MeshParts {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let j = 0; j < SIDE; j++) {
    for (let i = 0; i < SIDE; i++) {
      positions.push(i / 16, ((7 * i + 13 * j + 5 * p) % 8) / 64 + p / 2, j / 16);
      normals.push(i - 8, 32, j - 8);
      uvs.push(((i / 16) * 7 + p * 8 + 0.5) / 16, ((j / 16) * 15 + 0.5) / 16);
      if (i + 1 === SIDE || j + 1 === SIDE) continue;
      const a = j * SIDE + i;
      indices.push(a, a + SIDE, a + 1, a + 1, a + SIDE, a + SIDE + 1);
    }
  }
  return { positions, uvs, indices, material: 0, ...(p === 1 && { normals }) };
}

export function manyLayersPictures(): { readonly key: string; readonly bytes: Uint8Array }[] {
  return [0, 1, 2].map((k) => ({ key: `picture-${k}`, bytes: picture(k) }));
}

function picture(k: number): Uint8Array {
  const rows = Array.from({ length: 16 }, (_, y) =>
    Array.from({ length: 24 }, (_, x) => [
      (16 * x + 3 * y + 40 * k) % 256,
      (7 * x + 11 * y + 90 * k) % 256,
      ((x ^ y) * 8) % 256,
      (x + y + k) % 3 === 0 ? 255 : (9 * x + 14 * y) % 256,
    ]).flat(),
  );
  return makePng({ width: 24, height: 16, bitDepth: 8, colorType: 6, rows });
}

export function manyLayers(): EngineLayer[] {
  const shared = { material: 0, visible: true, blend: "normal", blendSpace: "srgb" } as const;
  const decals = Array.from(
    { length: 12 },
    (_, k): EngineLayer => ({
      ...shared,
      id: `decal-${k}`,
      type: "decal",
      asset: `picture-${k % 3}`,
      opacity: (16 - k) / 16,
      lockAlpha: false,
      filter: k % 4 === 3 ? "nearest" : "linear",
      wrap: k % 6 === 5 ? "repeat" : "none",
      flipX: k % 5 === 4,
      flipY: false,
      backfaces: false,
      angleFade: k % 3 === 1 ? [30, 75] : [70, 90],
      occlusion: k % 2 === 1 ? "none" : "self",
      projector: decalProjector(k),
    }),
  );
  const between = fill("fill", [0.25, 0.5, 0.75, 0.125], { lockAlpha: true });
  return [
    ...decals.slice(0, 6),
    between,
    ...decals.slice(6),
    ...otherLayers(),
    ...blendModes(),
    ...strokes(),
    ...tree(decals),
  ];
}

const decalProjector = (k: number): Projector => ({
  kind: "planar",
  position: [((5 * k) % 16) / 16, (k % 4) / 8, ((11 * k) % 16) / 16],
  rotation: [-4, (k % 3) - 1, (k % 5) - 2, 4],
  size: [(3 + (k % 5)) / 8, (2 + (k % 4)) / 8, 1 + (k % 2)],
});

function blendModes(): EngineLayer[] {
  return BLEND_MODES.map((blend, m) =>
    decal(`blend-${m}`, `picture-${m % 3}`, {
      opacity: 3 / 4,
      blend,
      blendSpace: m % 3 === 2 ? "linear" : "srgb",
      projector: {
        kind: "uv",
        center: [(2 * (m % 4) + 1) / 8, (2 * Math.floor(m / 4) + 1) / 16],
        size: [5 / 16, 3 / 16],
        angle: 0,
      },
    }),
  );
}

function strokes(): EngineLayer[] {
  const round = Array.from(
    { length: 24 },
    (_, d): EngineDab => ({
      kind: "planar",
      position: [(d + 4) / 32, 1 / 4, ((7 * d) % 32) / 32],
      rotation: [-4, 0, 0, 4],
      size: [(1 + (d % 3)) / 16, (1 + (d % 3)) / 16, 2],
      flow: (1 + (d % 4)) / 4,
    }),
  );
  const others = otherProjectors();
  const thrown = [decalProjector(7), others[1], others[3], others[5]].map((projector, i): EngineDab => {
    if (projector === undefined) throw new Error("There are six other projectors.");
    return { ...projector, flow: (4 - i) / 4 };
  });
  const stamps = Array.from(
    { length: 8 },
    (_, e): EngineDab => ({ kind: "uv", center: [(2 * e + 1) / 16, 3 / 8], size: [3 / 16, 3 / 16], angle: 0, flow: 1 }),
  );
  return [
    stroke("stroke-0", round, {
      brush: { tip: "round", color: [3 / 4, 1 / 8, 1 / 4, 1], hardness: 1 / 2, flow: 1 / 2 },
      opacity: 3 / 4,
      occlusion: "none",
    }),
    stroke("stroke-1", thrown, {
      brush: { tip: "picture", asset: "picture-1", color: null, flow: 3 / 4 },
      opacity: 1 / 2,
      blend: "multiply",
    }),
    stroke("stroke-2", stamps, {
      brush: { tip: "picture", asset: "picture-2", color: [0, 0, 0, 1], flow: 1 },
      opacity: 1 / 2,
      blend: "erase",
    }),
  ];
}

function tree(decals: readonly EngineLayer[]): EngineLayer[] {
  const [stroke0, , stroke2] = strokes();
  const again = (layer: EngineLayer | undefined, changes: Partial<EngineDecalLayer> = {}): EngineLayer => {
    if (layer === undefined) throw new Error("The recipe names a layer that is not there.");
    return { ...layer, ...changes, id: `again-${layer.id}` } as EngineLayer;
  };
  const mode = (m: number, changes: Partial<EngineDecalLayer> = {}): EngineLayer => again(blendModes()[m], changes);
  const from = { kind: "uv", size: [1 / 4, 1 / 4], angle: 0, flow: 1 } as const;
  return [
    group("tree-0", [again(decals[2]), again(decals[3])], { opacity: 3 / 4, blendSpace: "linear" }),
    group("tree-1", [again(stroke0), mode(16)], {
      isolated: true,
      opacity: 1 / 2,
      blend: "multiply",
      blendSpace: "linear",
      mask: { layers: [mode(5, { blend: "erase" }), again(stroke2, { blend: "normal" })], invert: false },
    }),
    fill("tree-2", [0, 0, 0, 1], {
      opacity: 1 / 2,
      blendSpace: "linear",
      gradient: {
        kind: "linear",
        from: [0, 0, 0],
        to: [1, 1 / 2, 1],
        stops: [
          { offset: 0, color: [1, 0, 0, 1] },
          { offset: 1 / 2, color: [1 / 4, 3 / 4, 1 / 2, 1 / 4] },
          { offset: 1, color: [0, 0, 1, 3 / 4] },
        ],
      },
      parts: { kind: "faces", faces: Array.from({ length: 342 }, (_, t) => 3 * t) },
      mask: { layers: [mode(9, { blend: "normal" })], invert: true },
    }),
    fill("tree-3", [0, 0, 0, 1], {
      lockAlpha: true,
      gradient: {
        kind: "radial",
        center: [1 / 2, 1 / 4, 1 / 2],
        radius: 3 / 4,
        stops: [
          { offset: 0, color: [1, 1, 0, 1 / 2] },
          { offset: 1, color: [0, 1, 1, 0] },
        ],
      },
    }),
    stroke(
      "tree-4",
      [
        { ...from, center: [1 / 4, 3 / 4] },
        { ...from, center: [3 / 4, 3 / 4], flipX: true },
      ],
      { brush: { tip: "picture", asset: "picture-0", color: null, flow: 1 } },
    ),
  ];
}

function otherProjectors(): Projector[] {
  const eye = (j: number): Projector => ({
    kind: "perspective",
    position: [1 / 4 + j / 2, 2, 3 / 4],
    rotation: [-4, 1 - 2 * j, j, 4],
    fov: 40 + 16 * j,
    aspect: (5 - 2 * j) / 4,
    near: 1 / 2,
    far: 3,
  });
  const label = (rotation: Quaternion, arc: number): Projector => ({
    kind: "cylindrical",
    position: [1 / 2, -1 / 2, 1 / 2],
    rotation,
    radius: 1,
    height: 5 / 8,
    arc,
    depth: 3 / 4,
  });
  const stamp = (j: number, angle: number): Projector => ({
    kind: "uv",
    center: [(2 * j - 5) / 8, (11 - j) / 16],
    size: [1 / 2, 3 / 8],
    angle,
  });
  return [eye(0), eye(1), label([4, 0, 1, 4], 360), label([-4, 1, 0, 4], 50), stamp(4, 30), stamp(5, -100)];
}

function otherLayers(): EngineLayer[] {
  return otherProjectors().map((projector, j) =>
    decal(`other-${j}`, `picture-${j % 3}`, {
      opacity: (10 - j) / 16,
      wrap: j % 2 === 1 ? "repeat" : "none",
      flipY: j % 3 === 1,
      occlusion: j % 4 === 1 ? "none" : "self",
      projector,
    }),
  );
}

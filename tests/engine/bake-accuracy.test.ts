import { beforeAll, describe, expect, it } from "vitest";
import { Session } from "../../web/core/session.ts";
import { type CoreModule, loadCore } from "../../web/core/wasm-module.ts";
import { buildGlb, cube, cylinder, type MeshParts, plane, sphere } from "../support/model-builder.ts";

/** spec.md, 2: positions within 2^-15 of the bounding box's diagonal, normals within half a degree. */
const POSITION_SHARE = 2 ** -15;
const NORMAL_COSINE = Math.cos((0.5 * Math.PI) / 180);
const SIZE = 128;
/** Texels whose centre lies this near an edge (in barycentric weight) may fall on either side of it. */
const NEAR_EDGE = 1e-4;

let core: CoreModule;
beforeAll(async () => {
  core = await loadCore();
});

interface Expected {
  readonly triangle: number;
  readonly position: readonly number[];
  readonly normal: readonly number[];
  readonly nearEdge: boolean;
}

/** Bakes in double precision, texel by texel, straight from the definition. */
function bakeByDefinition(mesh: MeshParts): (Expected | null)[] {
  const { positions, normals = [], uvs = [], indices = [] } = mesh;
  const corner = (values: readonly number[], size: number, triangle: number, k: number): number[] => {
    const vertex = indices[3 * triangle + k] ?? 0;
    return values.slice(vertex * size, vertex * size + size).map(Math.fround);
  };
  const texels: (Expected | null)[] = new Array(SIZE * SIZE).fill(null);
  for (let triangle = indices.length / 3 - 1; triangle >= 0; triangle--) {
    const uv = [0, 1, 2].map((k) => corner(uvs, 2, triangle, k).map((t) => t * SIZE - 0.5));
    const area = edge(uv[0], uv[1], uv[2]);
    if (area === 0) continue;
    const low = [0, 1].map((axis) => Math.max(0, Math.floor(Math.min(...uv.map((p) => p[axis] ?? 0)))));
    const high = [0, 1].map((axis) => Math.min(SIZE - 1, Math.ceil(Math.max(...uv.map((p) => p[axis] ?? 0)))));
    for (let y = low[1] ?? 0; y <= (high[1] ?? 0); y++) {
      for (let x = low[0] ?? 0; x <= (high[0] ?? 0); x++) {
        const at = [x, y];
        const weights = [edge(uv[1], uv[2], at), edge(uv[2], uv[0], at), edge(uv[0], uv[1], at)].map((w) => w / area);
        const least = Math.min(...weights);
        if (least < -NEAR_EDGE) continue;
        const mix = (values: readonly number[]): number[] => {
          const corners = [0, 1, 2].map((k) => corner(values, 3, triangle, k));
          return [0, 1, 2].map((axis) => corners.reduce((sum, c, k) => sum + (c[axis] ?? 0) * (weights[k] ?? 0), 0));
        };
        const before = texels[y * SIZE + x];
        const nearEdge = least < NEAR_EDGE || (before?.nearEdge ?? false);
        texels[y * SIZE + x] = { triangle, position: mix(positions), normal: unit(mix(normals)), nearEdge };
      }
    }
  }
  return texels;
}

function edge(a: readonly number[] = [], b: readonly number[] = [], p: readonly number[] = []): number {
  const [ax = 0, ay = 0] = a;
  const [bx = 0, by = 0] = b;
  const [px = 0, py = 0] = p;
  return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

function unit(v: readonly number[]): number[] {
  const length = Math.hypot(...v);
  return v.map((x) => x / length);
}

describe("the bake, against its definition in double precision,", () => {
  it.each<[string, MeshParts]>([
    ["a plane", plane(3)],
    ["a cube", cube()],
    ["a sphere", sphere(24, 12)],
    ["a cylinder", cylinder(24)],
  ])("is right for %s: coverage, positions and normals", (_, mesh) => {
    const session = Session.create(core);
    session.loadGlb(buildGlb({ meshes: [mesh] }));
    const { boundsMinModel, boundsMaxModel } = session.modelInfo();
    const diagonal = Math.hypot(...boundsMaxModel.map((max, axis) => max - (boundsMinModel[axis] ?? 0)));
    const target = session.createTarget({ width: SIZE, height: SIZE, gutter: 0 });
    while (!target.bake(1 << 20).done);
    const coverage = target.readCoverage(0, SIZE);
    const positions = target.readPositions(0, SIZE);
    const normals = target.readNormals(0, SIZE);

    const expected = bakeByDefinition(mesh);
    let compared = 0;
    let farthest = 0;
    let leastCosine = 1;
    for (const [texel, reference] of expected.entries()) {
      if (reference?.nearEdge) continue;
      expect(coverage[texel]).toBe(reference === null ? 0 : 1);
      if (reference === null) continue;
      compared++;
      const offset = reference.position.map((p, axis) => p - (positions[texel * 3 + axis] ?? 0));
      farthest = Math.max(farthest, Math.hypot(...offset));
      const cosine = reference.normal.reduce((sum, n, axis) => sum + n * (normals[texel * 3 + axis] ?? 0), 0);
      leastCosine = Math.min(leastCosine, cosine);
    }
    expect(compared).toBeGreaterThan((SIZE * SIZE) / 2);
    expect(farthest).toBeLessThan(diagonal * POSITION_SHARE);
    expect(leastCosine).toBeGreaterThan(NORMAL_COSINE);
    session.destroy();
  });

  it("continues a chart's plane into its gutter", () => {
    const session = Session.create(core);
    const mesh = { ...plane(2), uvs: [0.25, 0.75, 0.75, 0.75, 0.75, 0.25, 0.25, 0.25] };
    session.loadGlb(buildGlb({ meshes: [mesh] }));
    const target = session.createTarget({ width: 64, height: 64, gutter: 3 });
    while (!target.bake(1 << 20).done);
    const coverage = target.readCoverage(0, 64);
    const positions = target.readPositions(0, 64);
    for (let y = 0; y < 64; y++) {
      for (let x = 0; x < 64; x++) {
        const texel = y * 64 + x;
        const outside = Math.hypot(Math.max(16 - x, 0, x - 47), Math.max(16 - y, 0, y - 47));
        expect(coverage[texel]).toBe(outside === 0 ? 1 : outside <= 3 ? 2 : 0);
        if (outside > 3) continue;
        expect(positions[texel * 3]).toBeCloseTo(((x + 0.5) / 64 - 0.5) * 4, 3);
        expect(positions[texel * 3 + 1]).toBeCloseTo((0.5 - (y + 0.5) / 64) * 4, 3);
      }
    }
    session.destroy();
  });
});

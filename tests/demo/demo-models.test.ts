import { validateBytes } from "gltf-validator";
import { beforeAll, describe, expect, it } from "vitest";
import { cross, dot, length, subtract } from "../../scripts/demo/geometry/vector.ts";
import {
  type DemoFiles,
  demoFile,
  type MaterialGeometry,
  makeDemoFiles,
  modelBounds,
  readDemoModel,
  vectorAt,
} from "./demo-files.ts";
import { chartNumbers, connectedParts, coverTexels, leastChartDistance } from "./texel-coverage.ts";

let files: DemoFiles;
const parts = new Map<string, MaterialGeometry[]>();
const partsOf = (id: string): MaterialGeometry[] => parts.get(id) as MaterialGeometry[];
const paintable = (id: string) =>
  partsOf(id).filter((part): part is MaterialGeometry & { uvs: Float32Array } => part.uvs !== null);

const MODELS = ["mug", "avatar", "skateboard"];

beforeAll(async () => {
  files = await makeDemoFiles();
  for (const id of MODELS) parts.set(id, (await readDemoModel(files, id)).parts);
});

describe.each(MODELS)("the %s", (id) => {
  it("has no error and no warning from the glTF validator", async () => {
    const { issues } = await validateBytes(demoFile(files, `${id}.glb`));
    expect(issues.messages.filter(({ severity }) => severity <= 1)).toEqual([]);
  });

  it("keeps its UVs inside the texture", () => {
    for (const { uvs } of paintable(id)) {
      expect(uvs.every((value) => value > 0 && value < 1)).toBe(true);
    }
  });

  it("lets no texel belong to two triangles of a material", () => {
    for (const { uvs, indices } of paintable(id)) {
      const { counts } = coverTexels(uvs, indices, chartNumbers(uvs, indices), 1024, 1024);
      expect(counts.reduce((most, count) => Math.max(most, count), 0)).toBe(1);
    }
  });

  it("keeps eight texels at 2048 between its charts", () => {
    for (const { uvs, indices, pictureSize } of paintable(id)) {
      const [width, height] = pictureSize ?? [1024, 1024];
      const needed = (8 * Math.max(width, height)) / 2048;
      const coverage = coverTexels(uvs, indices, chartNumbers(uvs, indices), width, height);
      expect(leastChartDistance(coverage, needed + 1)).toBeGreaterThan(needed);
    }
  });

  it("mirrors no chart", () => {
    for (const { uvs, indices } of paintable(id)) {
      // Counter-clockwise outside, with v down, is a negative area.
      for (let first = 0; first < indices.length; first += 3) {
        const [a, b, c] = [0, 1, 2].map((corner) => (indices[first + corner] as number) * 2) as [
          number,
          number,
          number,
        ];
        const at = (index: number): number => uvs[index] as number;
        const area = (at(b) - at(a)) * (at(c + 1) - at(a + 1)) - (at(b + 1) - at(a + 1)) * (at(c) - at(a));
        if (area >= 0) expect.fail(`triangle ${first / 3} has the UV area ${area}`);
      }
    }
  });

  it("has unit normals", () => {
    for (const { normals } of partsOf(id)) {
      for (let vertex = 0; vertex < normals.length / 3; vertex++) {
        const size = length(vectorAt(normals, vertex));
        if (Math.abs(size - 1) > 1e-5) expect.fail(`vertex ${vertex} has a normal of length ${size}`);
      }
    }
  });

  it("has normals that agree with the side from which its triangles are seen", () => {
    for (const { material, positions, normals, indices } of partsOf(id)) {
      for (let first = 0; first < indices.length; first += 3) {
        const corners = [0, 1, 2].map((corner) => indices[first + corner] as number) as [number, number, number];
        const [a, b, c] = corners.map((vertex) => vectorAt(positions, vertex)) as [never, never, never];
        const face = cross(subtract(b, a), subtract(c, a));
        for (const vertex of corners) {
          const agreement = dot(face, vectorAt(normals, vertex)) / length(face);
          if (agreement < 0.3) expect.fail(`${material}: triangle ${first / 3} and its normal agree by ${agreement}`);
        }
      }
    }
  });

  it("faces outward with every one of its bodies", () => {
    for (const { material, positions, indices } of partsOf(id)) {
      const bodies = connectedParts(indices, (vertex) =>
        vectorAt(positions, vertex)
          .map((value) => Math.round(value * 1e6))
          .join(","),
      );
      const centres = new Map<number, { sum: [number, number, number]; count: number }>();
      bodies.forEach((body, triangle) => {
        const centre = centres.get(body) ?? { sum: [0, 0, 0], count: 0 };
        const corner = vectorAt(positions, indices[triangle * 3] as number);
        for (const axis of [0, 1, 2] as const) centre.sum[axis] += corner[axis];
        centre.count++;
        centres.set(body, centre);
      });
      const volumes = new Map<number, number>();
      bodies.forEach((body, triangle) => {
        const { sum, count } = centres.get(body) as { sum: [number, number, number]; count: number };
        const [a, b, c] = [0, 1, 2].map((corner) =>
          subtract(vectorAt(positions, indices[triangle * 3 + corner] as number), [
            sum[0] / count,
            sum[1] / count,
            sum[2] / count,
          ]),
        ) as [never, never, never];
        volumes.set(body, (volumes.get(body) ?? 0) + dot(a, cross(b, c)));
      });
      for (const volume of volumes.values()) expect(volume, material).toBeGreaterThan(0);
    }
  });

  it("stands on the ground, in the middle", () => {
    const { min, max } = modelBounds(partsOf(id));
    expect(min[1]).toBeCloseTo(0, 3);
    if (id !== "mug") expect(min[0] + max[0]).toBeCloseTo(0, 3);
  });
});

describe("the mug", () => {
  it("is 95 mm tall and 82 mm wide without its handle", () => {
    const { min, max } = modelBounds(partsOf("mug"));
    expect(max[1]).toBeCloseTo(0.095, 4);
    expect(max[2] - min[2]).toBeCloseTo(0.082, 4);
    expect(min[0]).toBeCloseTo(-0.041, 4);
    expect(max[0]).toBeGreaterThan(0.07);
  });

  it("has between ten and twenty thousand triangles", () => {
    const triangles = (partsOf("mug")[0] as MaterialGeometry).indices.length / 3;
    expect(triangles).toBeGreaterThan(10_000);
    expect(triangles).toBeLessThan(20_000);
  });

  it("spreads its texels evenly: nine tenths of them within a tenth of the middle density", () => {
    const { positions, uvs, indices } = paintable("mug")[0] as MaterialGeometry & { uvs: Float32Array };
    const densities: { density: number; area: number }[] = [];
    for (let first = 0; first < indices.length; first += 3) {
      const [a, b, c] = [0, 1, 2].map((corner) => indices[first + corner] as number) as [number, number, number];
      const at = (vertex: number) => vectorAt(positions, vertex);
      const area = length(cross(subtract(at(b), at(a)), subtract(at(c), at(a)))) / 2;
      const u = (vertex: number): number => uvs[vertex * 2] as number;
      const v = (vertex: number): number => uvs[vertex * 2 + 1] as number;
      const uvArea = Math.abs((u(b) - u(a)) * (v(c) - v(a)) - (v(b) - v(a)) * (u(c) - u(a))) / 2;
      densities.push({ density: Math.sqrt(uvArea / area), area: uvArea });
    }
    densities.sort((a, b) => a.density - b.density);
    const total = densities.reduce((sum, { area }) => sum + area, 0);
    let passed = 0;
    const middle = densities.find(({ area }) => {
      passed += area;
      return passed >= total / 2;
    }) as { density: number };
    const even = densities
      .filter(({ density }) => Math.abs(density / middle.density - 1) < 0.1)
      .reduce((sum, { area }) => sum + area, 0);
    expect(even / total).toBeGreaterThan(0.9);
  });
});

describe("the avatar", () => {
  it("is about 1.8 m tall", () => {
    expect(modelBounds(partsOf("avatar")).max[1]).toBeGreaterThan(1.75);
    expect(modelBounds(partsOf("avatar")).max[1]).toBeLessThan(1.85);
  });
});

describe("the skateboard", () => {
  it("has a deck of a real deck's size", () => {
    const deck = partsOf("skateboard").filter(({ material }) => material === "Deck");
    const { min, max } = modelBounds(deck);
    expect(max[0] - min[0]).toBeCloseTo(0.205, 3);
    expect(max[1]).toBeGreaterThan(0.77);
    expect(max[1]).toBeLessThan(0.81);
  });

  it("has its wheels in front of the graphic", () => {
    const { min } = modelBounds(partsOf("skateboard").filter(({ material }) => material === "Wheels"));
    expect(min[2]).toBeGreaterThan(0.02);
  });
});

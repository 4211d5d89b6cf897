import { describe, expect, it } from "vitest";
import { SurfaceCharts } from "../../web/viewer/surface-charts.ts";
import { UvCharts } from "../../web/viewer/uv-charts.ts";

/** A square of two triangles with its top left corner at a place, a tenth wide. */
const square = (u: number, v: number): number[] => {
  const [right, bottom] = [u + 0.1, v + 0.1];
  return [u, v, right, v, u, bottom, right, v, right, bottom, u, bottom];
};

describe("the charts of an unfolded mesh", () => {
  it("are triangles that hang together, named by the lowest of them", () => {
    const charts = new UvCharts(Float32Array.from([...square(0.5, 0.5), ...square(0.1, 0.1), ...square(0.6, 0.5)]));
    expect([...charts.chartOf]).toEqual([0, 0, 2, 2, 0, 0]);
  });

  it("hang together by a single shared corner", () => {
    const charts = new UvCharts(Float32Array.from([...square(0.1, 0.1), ...square(0.2, 0.2)]));
    expect(new Set(charts.chartOf).size).toBe(1);
  });

  it("are joined by a triangle that comes last", () => {
    const bridge = [0.2, 0.1, 0.5, 0.1, 0.3, 0.4];
    const charts = new UvCharts(Float32Array.from([...square(0.1, 0.1), ...square(0.5, 0.1), ...bridge]));
    expect([...charts.chartOf]).toEqual([0, 0, 0, 0, 0]);
  });

  it("hang together where they cross the texture's border, from one repeat of it into the next", () => {
    const [left, right] = [square(0.85, 0.5), square(0.95, 0.5)];
    const further = square(1.05, 0.5);
    expect([...new UvCharts(Float32Array.from([...left, ...right, ...further])).chartOf]).toEqual([0, 0, 0, 0, 0, 0]);
    const downwards = [...square(-0.1, -2.15), ...square(-0.1, -2.05), ...square(-0.1, -1.95)];
    expect(new Set(new UvCharts(Float32Array.from(downwards)).chartOf).size).toBe(1);
    expect([...new UvCharts(Float32Array.from([...square(0.9, 0.5), ...square(0.0, 0.5)])).chartOf]).toEqual([
      0, 0, 2, 2,
    ]);
  });

  it("are found at a place of the texture, and none is beside them", () => {
    const charts = new UvCharts(Float32Array.from([...square(0.1, 0.1), ...square(0.7, 0.7)]));
    expect(charts.chartAt([0.12, 0.12])).toBe(0);
    expect(charts.chartAt([0.79, 0.79])).toBe(2);
    expect(charts.chartAt([0.5, 0.5])).toBeNull();
  });

  it("have a border each, in the repeat of the texture that is asked about", () => {
    const charts = new UvCharts(Float32Array.from([...square(0.1, 0.2), ...square(0.7, 0.7)]));
    const near = (places: readonly number[]): unknown[] => places.map((place) => expect.closeTo(place, 6));
    expect(charts.boundsAt([0.12, 0.22])).toEqual({ low: near([0.1, 0.2]), high: near([0.2, 0.3]) });
    expect(charts.boundsAt([-0.88, 1.22])).toEqual({ low: near([-0.9, 1.2]), high: near([-0.8, 1.3]) });
    expect(charts.boundsAt([0.5, 0.5])).toBeNull();
  });

  it("are found from any repeat of the texture, wherever they lie themselves", () => {
    const charts = new UvCharts(Float32Array.from(square(3.1, -1.9)));
    expect(charts.chartAt([0.12, 0.12])).toBe(0);
    expect(charts.chartAt([-0.88, 5.12])).toBe(0);
  });

  it("give all corners of their triangles", () => {
    const charts = new UvCharts(Float32Array.from([...square(0.1, 0.1), ...square(0.7, 0.7)]));
    expect(charts.cornersOfChart(2)).toHaveLength(12);
    expect(charts.trianglesOf(0)).toEqual([0, 1]);
  });

  it("are none without triangles", () => {
    const charts = new UvCharts(new Float32Array());
    expect([charts.chartOf.length, charts.chartAt([0.5, 0.5])]).toEqual([0, null]);
  });
});

describe("a chart on the model", () => {
  /** Two quads that share an edge in space, and lie apart in the texture. */
  const surface = {
    positions: Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0]),
    normals: new Float32Array(24),
    uvs: Float32Array.from([0, 0.4, 0.4, 0.4, 0.4, 0, 0, 0, 0.5, 0.9, 0.9, 0.9, 0.9, 0.5, 0.5, 0.5]),
    index: Uint32Array.from([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]),
    materialOfTriangle: new Uint32Array(4),
    flagsOfTriangle: new Uint8Array(4),
    meshOfTriangle: new Uint32Array(4),
    faceOfTriangle: Uint32Array.from([0, 1, 2, 3]),
  };

  it("is its triangles and the lines around them", () => {
    const chart = new SurfaceCharts(surface).at({ material: 0, uv: [0.7, 0.8] });
    expect([...(chart?.triangles ?? [])]).toEqual([4, 5, 6, 4, 6, 7]);
    const lines = [...(chart?.borders ?? [])];
    expect(lines).toHaveLength(8);
    expect(lines).not.toContain(0);
  });

  it("has no line inside it where it crosses the texture's border", () => {
    const uvs = Float32Array.from([0.7, 0.4, 1.1, 0.4, 1.1, 0, 0.7, 0, 1.1, 0.4, 1.4, 0.4, 1.4, 0, 1.1, 0]);
    const chart = new SurfaceCharts({ ...surface, uvs }).at({ material: 0, uv: [0.8, 0.3] });
    expect(chart?.triangles).toHaveLength(12);
    expect(chart?.borders).toHaveLength(12);
  });

  it("is the same one wherever in it the pointer is, and null beside it", () => {
    const charts = new SurfaceCharts(surface);
    expect(charts.at({ material: 0, uv: [0.1, 0.1] })).toBe(charts.at({ material: 0, uv: [0.3, 0.35] }));
    expect(charts.at({ material: 0, uv: [0.45, 0.45] })).toBeNull();
    expect(charts.at({ material: 5, uv: [0.1, 0.1] })).toBeNull();
  });
});

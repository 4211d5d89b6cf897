import { describe, expect, it } from "vitest";
import { type ChartMesh, layOutCharts } from "../../web/engine/unwrap/chart-atlas.ts";

/** So many triangles, none of which touches another. */
function apart(count: number): ChartMesh {
  const positions = Float32Array.from({ length: count * 9 }, (_, i) => {
    const [triangle, corner, axis] = [Math.floor(i / 9), Math.floor(i / 3) % 3, i % 3];
    return axis === 0 ? triangle * 3 + (corner === 1 ? 1 : 0) : axis === 1 && corner === 2 ? 1 : 0;
  });
  return { positions, indices: Uint32Array.from({ length: count * 3 }, (_, i) => i), isMirrored: false };
}

/** The box round each triangle's corners: left, top, right, bottom. */
function boxesOf(corners: Float32Array): [number, number, number, number][] {
  return Array.from({ length: corners.length / 6 }, (_, i) => {
    const [xs, ys] = [0, 1].map((axis) => [0, 1, 2].map((corner) => corners[6 * i + 2 * corner + axis] as number));
    return [Math.min(...(xs ?? [])), Math.min(...(ys ?? [])), Math.max(...(xs ?? [])), Math.max(...(ys ?? []))];
  });
}

describe("charts that are too many to lie as far apart as they should", () => {
  it("lie nearer to each other, inside the texture and over none of the others", async () => {
    const layout = await layOutCharts([apart(16)], { size: 64, padding: 16, name: "many.glb" });
    expect(layout.charts).toBe(16);
    const boxes = boxesOf(layout.corners[0] as Float32Array);
    for (const [left, top, right, bottom] of boxes) {
      expect(Math.min(left, top)).toBeGreaterThanOrEqual(0);
      expect(Math.max(right, bottom)).toBeLessThanOrEqual(64);
      const met = boxes.filter(([x, y, toX, toY]) => x < right && toX > left && y < bottom && toY > top);
      expect(met).toHaveLength(1);
    }
  });

  it("are refused where they do not fit so either", async () => {
    const attempt = layOutCharts([apart(400)], { size: 64, padding: 16, name: "many.glb" });
    await expect(attempt).rejects.toMatchObject({ code: "bad-size", subject: "many.glb", value: "64" });
  });
});

import { describe, expect, it } from "vitest";
import { bevelledBox } from "../../scripts/demo/geometry/bevelled-box.ts";
import { deformChart, signedVolume } from "../../scripts/demo/geometry/chart.ts";
import { roundedProfile } from "../../scripts/demo/geometry/profile.ts";
import { packRectangles } from "../../scripts/demo/geometry/skyline-packer.ts";
import { dot, length, subtract, type Vec3 } from "../../scripts/demo/geometry/vector.ts";
import { pressDeck } from "../../scripts/demo/models/skateboard-deck.ts";
import { coverTexels, leastChartDistance } from "./texel-coverage.ts";

describe("a bevelled box", () => {
  const size: Vec3 = [0.4, 0.3, 0.2];
  const charts = bevelledBox({ name: "box", size, bevel: 0.05, steps: 16 });

  it("encloses the volume of its sweep: box, plates, quarter cylinders and one sphere", () => {
    const [x, y, z] = [0.3, 0.2, 0.1];
    const r = 0.05;
    const expected =
      x * y * z + 2 * r * (x * y + y * z + z * x) + Math.PI * r * r * (x + y + z) + (4 / 3) * Math.PI * r ** 3;
    const volume = charts.reduce((sum, chart) => sum + signedVolume(chart, [0, 0, 0]), 0) / 6;
    expect(volume / expected).toBeGreaterThan(0.998);
    expect(volume / expected).toBeLessThan(1);
  });

  it("keeps its full extents", () => {
    for (const axis of [0, 1, 2] as const) {
      const reach = Math.max(...charts.flatMap((chart) => chart.positions.map((position) => position[axis])));
      expect(reach).toBeCloseTo(size[axis] / 2, 12);
    }
  });

  it("refuses a bevel wider than itself", () => {
    expect(() => bevelledBox({ name: "thin", size: [0.1, 0.1, 0.02], bevel: 0.02 })).toThrow(/wider than the box/);
  });
});

describe("a rounded profile", () => {
  it("turns a right angle into a quarter circle that touches both sides", () => {
    const profile = roundedProfile(
      [
        { x: 0, y: 0 },
        { x: 2, y: 0, radius: 1, steps: 64 },
        { x: 2, y: 2 },
      ],
      10,
    );
    const total = profile[profile.length - 1]?.length as number;
    expect(total).toBeCloseTo(1 + Math.PI / 2 + 1, 3);
    const middle = profile.find(({ cornerMiddle }) => cornerMiddle === 1);
    expect(middle?.normal[0]).toBeCloseTo(Math.SQRT1_2, 9);
    expect(middle?.normal[1]).toBeCloseTo(-Math.SQRT1_2, 9);
  });
});

describe("the press that bends the deck", () => {
  it("keeps lengths along the middle of the board", () => {
    let travelled = 0;
    const steps = 4000;
    const at = (step: number): Vec3 => pressDeck([0, -0.4 + (0.8 * step) / steps, 0]);
    for (let step = 0; step < steps; step++) travelled += length(subtract(at(step + 1), at(step)));
    expect(travelled).toBeCloseTo(0.8, 4);
  });

  it("turns normals along with the surface", () => {
    const chart = {
      name: "patch",
      positions: [[0, 0.38, 0] as const],
      normals: [[0, 0, 1] as const],
      flat: [[0, 0] as const],
      triangles: [],
    };
    const [normal] = deformChart(chart, pressDeck).normals as [Vec3];
    const along = subtract(pressDeck([0, 0.381, 0]), pressDeck([0, 0.379, 0]));
    expect(dot(normal, along) / length(along)).toBeCloseTo(0, 4);
    expect(normal[2]).toBeCloseTo(Math.cos((21 * Math.PI) / 180), 4);
  });
});

describe("the packer", () => {
  const items = Array.from({ length: 30 }, (_, index) => ({
    name: `item ${index}`,
    width: 1 + ((index * 7) % 11),
    height: 1 + ((index * 5) % 13),
  }));
  const area = { width: 512, height: 256, spacing: 6 };
  const { scale, places } = packRectangles(items, area);
  const boxes = items.map(({ name, width, height }) => {
    const { x, y } = places.get(name) as { x: number; y: number };
    return { left: x, top: y, right: x + width * scale, bottom: y + height * scale };
  });

  it("keeps the spacing between all rectangles and along the border", () => {
    for (const [index, a] of boxes.entries()) {
      expect(a.left).toBeGreaterThanOrEqual(area.spacing);
      expect(a.top).toBeGreaterThanOrEqual(area.spacing);
      expect(a.right).toBeLessThanOrEqual(area.width - area.spacing);
      expect(a.bottom).toBeLessThanOrEqual(area.height - area.spacing);
      for (const b of boxes.slice(index + 1)) {
        const gap = Math.max(b.left - a.right, a.left - b.right, b.top - a.bottom, a.top - b.bottom);
        expect(gap).toBeGreaterThanOrEqual(area.spacing - 1e-9);
      }
    }
  });

  it("fills more than half of the area", () => {
    const used = boxes.reduce((sum, box) => sum + (box.right - box.left) * (box.bottom - box.top), 0);
    expect(used / (area.width * area.height)).toBeGreaterThan(0.5);
  });
});

describe("the tests' own coverage checker", () => {
  it("gives every texel of a square to one of its two triangles, corners on texel centres or not", () => {
    for (const inset of [0, 0.5, 0.3]) {
      const [low, high] = [(2 + inset) / 16, (10 + inset) / 16];
      const uvs = [low, low, high, low, high, high, low, high];
      const { counts } = coverTexels(uvs, [0, 1, 2, 0, 2, 3], [0, 0], 16, 16);
      expect(counts.reduce((sum, count) => sum + count, 0)).toBe(64);
      expect(Math.max(...counts)).toBe(1);
    }
  });

  it("sees two triangles on one texel", () => {
    const uvs = [0, 0, 1, 0, 0, 1];
    const { counts } = coverTexels(uvs, [0, 1, 2, 0, 1, 2], [0, 1], 8, 8);
    expect(Math.max(...counts)).toBe(2);
  });

  it("measures the way between two charts", () => {
    const square = (x: number) => [x, 0, x + 2, 0, x + 2, 2, x, 2].map((value) => value / 16);
    const uvs = [...square(0), ...square(7)];
    const coverage = coverTexels(uvs, [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7], [0, 0, 1, 1], 16, 16);
    expect(leastChartDistance(coverage, 9)).toBe(6);
  });
});

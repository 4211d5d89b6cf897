import { describe, expect, test } from "vitest";
import { logScale } from "../../bench/plot/log-scale.ts";
import { plotFigures } from "../../bench/plot/plot-figures.ts";
import type { Row } from "../../bench/report.ts";

const ENGINES = ["plain method, native", "plain method, WebAssembly", "Texelcast"];

function rows(work: string, mesh: string, sizes: readonly number[]): Row[] {
  return sizes.flatMap((size) =>
    ENGINES.map((engine, index) => ({
      ...{ work, mesh, size, engine, texels: size * 10 },
      ...{ median: size + index, min: size, max: size * 2, toPlainNative: 1, toPlainWasm: 1 },
    })),
  );
}

const input = (figures: readonly Row[]) => ({
  ...{ date: "2026-01-02T00:00:00Z", machine: "a <fast> machine & more", versions: { texelcast: "1", node: "2" } },
  ...{ rounds: 3, rows: figures },
});
const count = (text: string | null, part: string): number => (text ?? "").split(part).length - 1;

describe("a logarithmic axis", () => {
  test("holds its values in their order, with round numbers as ticks", () => {
    const scale = logScale([3, 700, 20], 0, 100);
    expect([3, 20, 700].map(scale.at)).toEqual([3, 20, 700].map(scale.at).sort((a, b) => a - b));
    expect(scale.at(3)).toBeGreaterThan(0);
    expect(scale.at(700)).toBeLessThan(100);
    expect(scale.ticks).toEqual([3, 10, 30, 100, 300]);
  });

  test("one value alone stands in the middle", () => {
    expect(logScale([5], 0, 100).at(5)).toBeCloseTo(50);
    expect(logScale([5], 0, 100).ticks).toEqual([5]);
  });
});

describe("the benchmark's plot", () => {
  test("each engine has a line in each panel, and each mesh a row of panels", () => {
    const figures = ["torus20k", "torus200k"].flatMap((mesh) => [
      ...rows("bake", mesh, [1024, 2048]),
      ...rows("local10", mesh, [1024, 2048]),
    ]);
    const plot = plotFigures(input(figures));
    expect(count(plot, "<polyline")).toBe(2 * 3 * ENGINES.length);
    expect(plot).toContain("Bake, torus200k");
    expect(plot).not.toContain("NaN");
  });

  test("what was not measured has no panel", () => {
    const plot = plotFigures(input(rows("bake", "torus20k", [64])));
    expect(count(plot, "<polyline")).toBe(ENGINES.length);
    expect(plot).not.toContain("A step of a drag");
    expect(plotFigures(input([]))).toBeNull();
  });

  test("the machine's name is text, whatever it holds", () => {
    expect(plotFigures(input(rows("bake", "torus20k", [64])))).toContain("a &lt;fast> machine &amp; more");
  });
});

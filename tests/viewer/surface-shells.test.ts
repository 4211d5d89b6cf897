import { BoxGeometry, SphereGeometry } from "three";
import { describe, expect, it } from "vitest";
import { shellsOf } from "../../web/viewer/surface-shells.ts";

describe("the shells of a surface", () => {
  it("join faces that the file separates by seams", () => {
    const box = new BoxGeometry();
    const shells = shellsOf({
      positions: Float32Array.from(box.getAttribute("position").array),
      index: Uint32Array.from(box.index?.array ?? []),
    });
    expect(shells).toHaveLength(12);
    expect(new Set(shells).size).toBe(1);
  });

  it("tell parts apart that do not touch", () => {
    const parts = [new SphereGeometry(1, 8, 6), new BoxGeometry().translate(5, 0, 0)];
    const positions = parts.flatMap((part) => [...part.getAttribute("position").array]);
    const first = (parts[0] as SphereGeometry).getAttribute("position").count;
    const index = parts.flatMap((part, at) => [...(part.index?.array ?? [])].map((vertex) => vertex + at * first));
    const shells = shellsOf({ positions: Float32Array.from(positions), index: Uint32Array.from(index) });
    expect(new Set(shells).size).toBe(2);
    expect(shells[0]).not.toBe(shells.at(-1));
  });

  it("of nothing are none", () => {
    expect(shellsOf({ positions: new Float32Array(), index: new Uint32Array() })).toHaveLength(0);
  });
});

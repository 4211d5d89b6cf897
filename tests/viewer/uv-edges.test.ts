import { describe, expect, it } from "vitest";
import { meanLength, uvEdges } from "../../web/viewer/uv-edges.ts";

/** A square of two triangles that share its diagonal. */
const SQUARE = [0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 1].map((value) => value * 0.5);

describe("the edges of an unfolded mesh", () => {
  it("are borders where one triangle has them, inner where two share them", () => {
    const { borders, inner } = uvEdges(Float32Array.from(SQUARE));
    expect(borders).toHaveLength(4 * 4);
    expect([...inner]).toEqual([0.5, 0, 0, 0.5]);
  });

  it("share an edge whatever direction each triangle runs it in", () => {
    const { inner } = uvEdges(Float32Array.from([0, 0, 0.5, 0, 0, 0.5, 0, 0.5, 0.5, 0, 0.5, 0.5]));
    expect(inner).toHaveLength(4);
  });

  it("are brought back as whole triangles from another repeat of the texture", () => {
    const { borders } = uvEdges(Float32Array.from([3.25, -2, 3.75, -2, 3.25, -1.5]));
    expect([...borders]).toEqual([0.25, 0, 0.75, 0, 0.75, 0, 0.25, 0.5, 0.25, 0.5, 0.25, 0]);
  });

  it("are none without triangles", () => {
    const { borders, inner } = uvEdges(new Float32Array());
    expect([borders.length, inner.length, meanLength(inner)]).toEqual([0, 0, 0]);
  });

  it("have a mean length", () => {
    expect(meanLength(Float32Array.from([0, 0, 0.3, 0.4, 0, 0, 0, 0.1]))).toBeCloseTo(0.3, 6);
  });

  it("of a hundred thousand triangles are all found", () => {
    const cells = 224;
    const triangles = Array.from({ length: cells * cells }, (_, cell) => {
      const [u, v] = [(cell % cells) / cells, Math.floor(cell / cells) / cells];
      return SQUARE.map((value, at) => (value * 2) / cells + (at % 2 === 0 ? u : v));
    });
    const { borders, inner } = uvEdges(Float32Array.from(triangles.flat()));
    expect(borders.length / 4).toBe(4 * cells);
    expect(inner.length / 4).toBe(cells * cells + 2 * cells * (cells - 1));
  });
});

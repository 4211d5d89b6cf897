import { describe, expect, it } from "vitest";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { PngStream } from "../../web/engine/png-stream.ts";

/** Whole numbers that look like chance, the same ones each time (Numerical Recipes' generator). */
function randomNumbers(seed: number): (below: number) => number {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

/** One colour, and here and there a channel of another. */
function speckled(width: number, height: number, next: (below: number) => number): Uint8Array {
  const color = [next(256), next(256), next(256), next(256)];
  return Uint8Array.from({ length: width * height * 4 }, (_, i) =>
    next(10) === 0 ? next(256) : (color[i % 4] as number),
  );
}

describe("a PNG that is written row by row", () => {
  it("can be read back byte for byte, however its rows begin", async () => {
    const next = randomNumbers(1);
    for (let picture = 0; picture < 100; picture++) {
      const [width, height] = [1 + next(60), 1 + next(60)];
      const rgba = speckled(width, height, next);
      const png = new PngStream(width, height, null);
      png.addRows(rgba);
      const read = await decodePicture(png.finish(), `${picture}.png`);
      expect(read, `picture ${picture}, ${width} × ${height}`).toEqual({ width, height, rgba });
    }
  });
});

/** The bucket: what it reaches is decided by what is seen, and goes over seams where the surface does, on other materials too. */
import { floodFill } from "./flood-fill.ts";
import type { PixelColor } from "./pixel-canvas.ts";
import type { PixelGesture } from "./pixel-gesture.ts";
import type { PixelSession } from "./pixel-session.ts";
import type { Texel } from "./pixel-shapes.ts";

/** Without `contiguous` it stays on the material that was clicked. */
export function fillFrom(
  gesture: PixelGesture,
  pixels: PixelSession,
  material: number,
  [x, y]: Texel,
  color: PixelColor,
  { tolerance, contiguous }: { readonly tolerance: number; readonly contiguous: boolean },
): void {
  gesture.draw(material, async () => {
    const { grids, neighbours } = pixels.joinedGrids(material, contiguous);
    const pictures = await Promise.all(grids.map((grid) => pixels.seen(grid.material, grid)));
    const rgba = new Uint8Array(grids.reduce((sum, { width, height }) => sum + width * height * 4, 0));
    for (const [place, { first }] of grids.entries()) rgba.set(pictures[place] as Uint8Array, first * 4);
    const own = grids.find((grid) => grid.material === material);
    if (own === undefined) return;
    const start = own.first + y * own.width + x;
    const reached = floodFill(rgba, start, {
      tolerance,
      contiguous,
      neighbours: (texel) => neighbours?.of(texel) ?? [],
    });
    for (const { material: met, first, width, height } of grids) {
      const texels = reached.filter((texel) => texel >= first && texel < first + width * height);
      if (texels.length === 0) continue;
      gesture.draw(met, (canvas) => {
        for (const texel of texels) {
          canvas.set((texel - first) % width, Math.floor((texel - first) / width), color);
        }
      });
    }
  });
}

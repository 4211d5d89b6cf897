/** The bucket: what it reaches is decided by what is seen, and goes over seams where the surface does. */
import { floodFill } from "./flood-fill.ts";
import type { PixelColor } from "./pixel-canvas.ts";
import type { PixelGesture } from "./pixel-gesture.ts";
import type { PixelSession } from "./pixel-session.ts";
import type { Texel } from "./pixel-shapes.ts";

export function fillFrom(
  gesture: PixelGesture,
  pixels: PixelSession,
  [x, y]: Texel,
  color: PixelColor,
  { tolerance, contiguous }: { readonly tolerance: number; readonly contiguous: boolean },
): void {
  const { material, width } = gesture;
  gesture.draw(async (canvas) => {
    const map = pixels.neighboursOf(material, gesture);
    const rgba = await pixels.seen(material, gesture);
    const start = y * width + x;
    const neighbours = (texel: number): readonly number[] => map?.of(texel) ?? [];
    for (const texel of floodFill(rgba, start, { tolerance, contiguous, neighbours })) {
      canvas.set(texel % width, Math.floor(texel / width), color);
    }
  });
}

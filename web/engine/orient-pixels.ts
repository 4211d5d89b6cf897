/** A picture's pixels as EXIF's orientation tag asks for them to be shown. */

/** Turns and mirrors RGBA pixels upright. Orientations 5 to 8 swap width and height. */
export function orientPixels(
  rgba: Uint8Array<ArrayBuffer>,
  width: number,
  height: number,
  orientation: number,
): { rgba: Uint8Array<ArrayBuffer>; width: number; height: number } {
  if (orientation === 1) return { rgba, width, height };
  const swaps = orientation >= 5;
  const outWidth = swaps ? height : width;
  const outHeight = swaps ? width : height;
  const from = new Uint32Array(rgba.buffer, rgba.byteOffset, width * height);
  const to = new Uint32Array(width * height);
  // Upright (x, y) is stored at (sx, sy): mirrored in x for 2, 3, 7, 8, in y for 3, 4, 6, 7, after the swap.
  const mirrorX = [2, 3, 7, 8].includes(orientation);
  const mirrorY = [3, 4, 6, 7].includes(orientation);
  for (let y = 0; y < outHeight; y++) {
    for (let x = 0; x < outWidth; x++) {
      const a = swaps ? y : x;
      const b = swaps ? x : y;
      const sx = mirrorX ? width - 1 - a : a;
      const sy = mirrorY ? height - 1 - b : b;
      to[y * outWidth + x] = from[sy * width + sx] ?? 0;
    }
  }
  return { rgba: new Uint8Array(to.buffer), width: outWidth, height: outHeight };
}

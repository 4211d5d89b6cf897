/** EXIF's orientation tag: how a camera held the picture (EXIF 2.32, 4.6.4: tag 0x0112). */

/**
 * Reads the tag from a TIFF block (JPEG's APP1 behind "Exif", PNG's eXIf, WebP's EXIF). 1, upright, when it is absent or
 * damaged: viewers show such pictures as they are stored.
 */
export function readExifOrientation(tiff: Uint8Array): number {
  const view = new DataView(tiff.buffer, tiff.byteOffset, tiff.byteLength);
  try {
    const order = view.getUint16(0);
    if (order !== 0x4949 && order !== 0x4d4d) return 1;
    const little = order === 0x4949;
    const directory = view.getUint32(4, little);
    const entries = view.getUint16(directory, little);
    for (let i = 0; i < entries; i++) {
      const entry = directory + 2 + 12 * i;
      if (view.getUint16(entry, little) !== 0x0112) continue;
      // A short number, or a long one.
      const isLong = view.getUint16(entry + 2, little) === 4;
      const value = isLong ? view.getUint32(entry + 8, little) : view.getUint16(entry + 8, little);
      return value >= 1 && value <= 8 ? value : 1;
    }
  } catch {
    return 1;
  }
  return 1;
}

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

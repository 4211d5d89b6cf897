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

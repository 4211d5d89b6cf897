/** Sizes in memory as the page names them. */

export const MEBIBYTE = 2 ** 20;

/** "0.4", "12", "256": with a decimal only below ten. */
export function megabytes(bytes: number): string {
  const size = bytes / MEBIBYTE;
  return size < 10 ? String(Math.round(size * 10) / 10) : String(Math.round(size));
}

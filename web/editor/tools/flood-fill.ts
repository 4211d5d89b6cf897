/** Which texels a fill bucket reaches. */

export interface FloodOptions {
  /** 0 to 255: how far each channel may be from the one where the fill begins. */
  readonly tolerance: number;
  /** Only what hangs together; else every texel of the colour. */
  readonly contiguous: boolean;
  readonly neighbours: (texel: number) => readonly number[];
}

/**
 * @param rgba straight alpha, four bytes a texel
 * @param start index of the texel that was clicked
 * @returns indices of texels, the first one first
 */
export function floodFill(rgba: Uint8Array, start: number, options: FloodOptions): number[] {
  const { tolerance, contiguous, neighbours } = options;
  const isAlike = (texel: number): boolean => {
    // What is clear has no colour.
    if (rgba[texel * 4 + 3] === 0 && rgba[start * 4 + 3] === 0) return true;
    for (let channel = 0; channel < 4; channel++) {
      const difference = (rgba[texel * 4 + channel] as number) - (rgba[start * 4 + channel] as number);
      if (Math.abs(difference) > tolerance) return false;
    }
    return true;
  };
  if (!contiguous) {
    const all = Array.from({ length: rgba.length / 4 }, (_, texel) => texel);
    return [start, ...all.filter((texel) => texel !== start && isAlike(texel))];
  }
  const reached = [start];
  const seen = new Set(reached);
  // The list grows while it is walked.
  for (const texel of reached) {
    for (const next of neighbours(texel)) {
      if (seen.has(next)) continue;
      seen.add(next);
      if (isAlike(next)) reached.push(next);
    }
  }
  return reached;
}

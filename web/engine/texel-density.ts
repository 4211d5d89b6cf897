/** How closely a target's texels lie on the model: by it, drawings get as many pixels as can be seen, and no more. */

/** What of an open target is asked. */
export interface DensityMap {
  readonly width: number;
  readonly height: number;
  /** Row after row, three floats a texel, metres. */
  readPositions(row: number, rowCount: number): Float32Array;
  /** Row after row, one byte a texel; 1 where a triangle covers it. */
  readCoverage(row: number, rowCount: number): Uint8Array;
}

/** Pairs of rows that are looked at, spread over the map. */
const SAMPLED_ROWS = 48;
const COVERED = 1;
/** Of the distances between neighbours: where a few triangles are packed more densely than all else, they do not decide. */
const QUANTILE = 0.1;

/** Texels a metre where the model is densely textured; null where no two covered texels are neighbours. */
export function texelsPerMetre(map: DensityMap): number | null {
  const { width, height } = map;
  const distances: number[] = [];
  const step = Math.max(1, Math.floor(height / SAMPLED_ROWS));
  for (let row = 0; row < height; row += step) {
    const rows = Math.min(2, height - row);
    const positions = map.readPositions(row, rows);
    const coverage = map.readCoverage(row, rows);
    const measure = (a: number, b: number): void => {
      if (coverage[a] !== COVERED || coverage[b] !== COVERED) return;
      const along = (axis: number): number => (positions[3 * a + axis] ?? 0) - (positions[3 * b + axis] ?? 0);
      const [x, y, z] = [along(0), along(1), along(2)];
      const distance = Math.sqrt(x * x + y * y + z * z);
      if (distance > 0) distances.push(distance);
    };
    for (let x = 0; x < width; x++) {
      if (x + 1 < width) measure(x, x + 1);
      if (rows > 1) measure(x, x + width);
    }
  }
  if (distances.length === 0) return null;
  const sorted = Float64Array.from(distances).sort();
  return 1 / (sorted[Math.floor(sorted.length * QUANTILE)] ?? 1);
}

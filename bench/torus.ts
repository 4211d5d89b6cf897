/**
 * A bumpy closed torus around the Z axis, unwrapped into 40 rectangular charts (10 around, 4 across) of which 8 are
 * mirrored, which together cover 82 % of the texture.
 */
import type { BenchMesh } from "./work.ts";

const CHARTS_AROUND = 10;
const CHARTS_ACROSS = 4;
/** Cells of the atlas: 8 columns, 5 rows; a chart fills this share of its cell's side. */
const ATLAS_COLUMNS = 8;
const ATLAS_ROWS = 5;
const CHART_SHARE = Math.sqrt(0.82);
const MIRRORED_CHARTS = 8;
const MAJOR_RADIUS = 1;
const MINOR_RADIUS = 0.44;
const BUMP_HEIGHT = 0.08;

/** Quads along the two circles; multiples of 10 and of 4. */
export function generateTorus(name: string, quadsAround: number, quadsAcross: number): BenchMesh {
  const columns = quadsAround / CHARTS_AROUND;
  const rows = quadsAcross / CHARTS_ACROSS;
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let chart = 0; chart < CHARTS_AROUND * CHARTS_ACROSS; chart++) {
    const chartAround = chart % CHARTS_AROUND;
    const chartAcross = Math.floor(chart / CHARTS_AROUND);
    const cellX = (chart % ATLAS_COLUMNS) / ATLAS_COLUMNS;
    const cellY = Math.floor(chart / ATLAS_COLUMNS) / ATLAS_ROWS;
    const mirrored = chart < MIRRORED_CHARTS;
    const first = positions.length / 3;
    for (let row = 0; row <= rows; row++) {
      for (let column = 0; column <= columns; column++) {
        const around = ((chartAround * columns + column) / quadsAround) * 2 * Math.PI;
        const across = ((chartAcross * rows + row) / quadsAcross) * 2 * Math.PI;
        positions.push(...torusPoint(around, across));
        normals.push(...torusNormal(around, across));
        const u = mirrored ? 1 - column / columns : column / columns;
        const margin = (1 - CHART_SHARE) / 2;
        uvs.push(cellX + (margin + u * CHART_SHARE) / ATLAS_COLUMNS);
        uvs.push(cellY + (margin + (row / rows) * CHART_SHARE) / ATLAS_ROWS);
      }
    }
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const corner = first + row * (columns + 1) + column;
        const above = corner + columns + 1;
        indices.push(corner, corner + 1, above + 1, corner, above + 1, above);
      }
    }
  }
  return {
    name,
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    uvs: Float32Array.from(uvs),
    indices: Uint32Array.from(indices),
  };
}

function torusPoint(around: number, across: number): [number, number, number] {
  const minor = MINOR_RADIUS + BUMP_HEIGHT * Math.sin(5 * around) * Math.cos(3 * across);
  const ring = MAJOR_RADIUS + minor * Math.cos(across);
  return [ring * Math.cos(around), ring * Math.sin(around), minor * Math.sin(across)];
}

/** By central differences: the bumps turn the surface, and an analytic form would say no more. */
function torusNormal(around: number, across: number): [number, number, number] {
  const step = 1e-4;
  const along = difference(torusPoint(around + step, across), torusPoint(around - step, across));
  const over = difference(torusPoint(around, across + step), torusPoint(around, across - step));
  const normal: [number, number, number] = [
    along[1] * over[2] - along[2] * over[1],
    along[2] * over[0] - along[0] * over[2],
    along[0] * over[1] - along[1] * over[0],
  ];
  const length = Math.hypot(...normal);
  return [normal[0] / length, normal[1] / length, normal[2] / length];
}

function difference(a: readonly number[], b: readonly number[]): [number, number, number] {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/**
 * A chart: a piece of surface together with its flat pattern, as a tailor cuts it. Models are lists of charts; the
 * packer lays the patterns into the texture and the writer joins them to one primitive. Keeping the pattern in metres
 * until then is what gives all charts of a model the same texel density.
 */

import { add, cross, dot, length, normalise, scale, subtract, type Vec2, type Vec3 } from "./vector.ts";

export interface Chart {
  readonly name: string;
  /** Model space, metres. */
  readonly positions: readonly Vec3[];
  /** Unit, outward. */
  readonly normals: readonly Vec3[];
  /** The pattern: metres, x to the right, y down, as seen from outside (so that no picture is mirrored). */
  readonly flat: readonly Vec2[];
  /** Vertex indices, counter-clockwise seen from outside. */
  readonly triangles: readonly (readonly [number, number, number])[];
  /** Texel density relative to the model's other charts; 1 by default. */
  readonly density?: number;
}

export interface ChartVertex {
  readonly position: Vec3;
  readonly normal: Vec3;
  readonly flat: Vec2;
}

/**
 * A chart over a grid of `rows` x `columns` vertices. `sample` gets row and column counted from the top left, as the
 * pattern lies when seen from outside. Triangles that have shrunk to a line (at a pole) are left out.
 */
export function gridChart(
  name: string,
  rows: number,
  columns: number,
  sample: (row: number, column: number) => ChartVertex,
): Chart {
  const vertices: ChartVertex[] = [];
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) vertices.push(sample(row, column));
  }
  const triangles: [number, number, number][] = [];
  for (let row = 0; row + 1 < rows; row++) {
    for (let column = 0; column + 1 < columns; column++) {
      const topLeft = row * columns + column;
      const bottomLeft = topLeft + columns;
      triangles.push([topLeft, bottomLeft, topLeft + 1], [topLeft + 1, bottomLeft, bottomLeft + 1]);
    }
  }
  return fromVertices(name, vertices, triangles);
}

/** A chart of loose vertices; triangles without area, in space or on the pattern, are left out. */
export function fromVertices(
  name: string,
  vertices: readonly ChartVertex[],
  triangles: readonly (readonly [number, number, number])[],
): Chart {
  const positions = vertices.map((vertex) => vertex.position);
  const flat = vertices.map((vertex) => vertex.flat);
  return {
    name,
    positions,
    normals: vertices.map((vertex) => vertex.normal),
    flat,
    triangles: triangles.filter(([a, b, c]) => {
      const pa = positions[a] as Vec3;
      const normal = cross(subtract(positions[b] as Vec3, pa), subtract(positions[c] as Vec3, pa));
      return length(normal) > 1e-12 && Math.abs(flatArea(flat[a] as Vec2, flat[b] as Vec2, flat[c] as Vec2)) > 1e-12;
    }),
  };
}

function flatArea(a: Vec2, b: Vec2, c: Vec2): number {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/** Several pieces whose patterns already lie side by side, as one chart. */
export function joinCharts(name: string, pieces: readonly Chart[]): Chart {
  const positions: Vec3[] = [];
  const normals: Vec3[] = [];
  const flat: Vec2[] = [];
  const triangles: [number, number, number][] = [];
  for (const piece of pieces) {
    const first = positions.length;
    positions.push(...piece.positions);
    normals.push(...piece.normals);
    flat.push(...piece.flat);
    for (const [a, b, c] of piece.triangles) triangles.push([a + first, b + first, c + first]);
  }
  return { name, positions, normals, flat, triangles };
}

/** Of the numeric Jacobian, metres. */
const DIFFERENCE = 1e-5;

/** Moves every vertex by a smooth map that keeps orientation; normals follow by the map's numeric Jacobian. */
export function deformChart(chart: Chart, map: (position: Vec3) => Vec3): Chart {
  const normals = chart.positions.map((position, index) => {
    const along = (axis: Vec3): Vec3 =>
      scale(
        subtract(map(add(position, scale(axis, DIFFERENCE))), map(subtract(position, scale(axis, DIFFERENCE)))),
        1 / (2 * DIFFERENCE),
      );
    const jx = along([1, 0, 0]);
    const jy = along([0, 1, 0]);
    const jz = along([0, 0, 1]);
    const [nx, ny, nz] = chart.normals[index] as Vec3;
    // The cofactor matrix: inverse transpose times determinant, which spares the division.
    return normalise(add(add(scale(cross(jy, jz), nx), scale(cross(jz, jx), ny)), scale(cross(jx, jy), nz)));
  });
  return { ...chart, positions: chart.positions.map(map), normals };
}

/** Moves a chart without bending it; `rotate` is applied first. */
export function placeChart(chart: Chart, offset: Vec3, rotate: (vector: Vec3) => Vec3 = (vector) => vector): Chart {
  return {
    ...chart,
    positions: chart.positions.map((position) => add(rotate(position), offset)),
    normals: chart.normals.map((normal) => rotate(normal)),
  };
}

/** Turns the pattern by 180 degrees; the surface stays. */
export function turnPattern(chart: Chart): Chart {
  return { ...chart, flat: chart.flat.map(([x, y]) => [-x, -y] as const) };
}

/** Turns the pattern by 90 degrees clockwise as seen on the texture; the surface stays. */
export function quarterTurnPattern(chart: Chart): Chart {
  return { ...chart, flat: chart.flat.map(([x, y]) => [-y, x] as const) };
}

/** Normal of a parametrised surface from its tangents: `right` and `down` as on the pattern. */
export function normalFromTangents(right: Vec3, down: Vec3): Vec3 {
  return normalise(cross(down, right));
}

/** Six times the signed volume between the chart and a point: positive in sum for a closed surface that faces outward. */
export function signedVolume(chart: Chart, origin: Vec3): number {
  let sum = 0;
  for (const [a, b, c] of chart.triangles) {
    const pa = subtract(chart.positions[a] as Vec3, origin);
    const pb = subtract(chart.positions[b] as Vec3, origin);
    const pc = subtract(chart.positions[c] as Vec3, origin);
    sum += dot(pa, cross(pb, pc));
  }
  return sum;
}

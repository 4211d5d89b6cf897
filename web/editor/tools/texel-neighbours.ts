/**
 * Which texels of a skin lie beside each other on the model: in the texture where it is whole there, and across its seams
 * where two charts meet on the surface. Texels side by side in the texture whose places on the model are apart are none.
 */
import type { TexelPlaces } from "../../viewer/viewer-api.ts";

/**
 * In texel widths. Across a seam two centres are 1 apart where the surface is flat and 0.71 over a right angle; the next
 * but one along a right angle is 1.22 away and must not count, or a fill would leak through a line of one texel.
 */
const MOST_ACROSS_SEAM = 1.1;
/** In texel widths: texels that the unwrapping stretches are still beside each other. */
const MOST_IN_CHART = 2.5;
/** Cosine: the other side of a thin sheet is no neighbour. */
const LEAST_ALIKE = -0.5;

export class TexelNeighbours {
  readonly #places: Omit<TexelPlaces, "width" | "height">;
  readonly #grids: readonly { readonly first: number; readonly width: number; readonly height: number }[];
  /** Of texels at the border of a chart alone. */
  readonly #acrossSeams = new Map<number, readonly number[]>();

  /** Several textures are counted one after another, as if the texels of each followed those of the one before. */
  constructor(...textures: readonly TexelPlaces[]) {
    this.#places = joinedPlaces(textures);
    let first = 0;
    this.#grids = textures.map(({ width, height }) => {
      const grid = { first, width, height };
      first += width * height;
      return grid;
    });
    const { covered } = this.#places;
    const border: number[] = [];
    for (let texel = 0; texel < covered.length; texel++) {
      if (covered[texel] === 1 && this.#inChart(texel).length < 4) border.push(texel);
    }
    this.#joinBorders(border);
  }

  /** Indices of texels, in no particular order; none for a texel that nothing covers. */
  of(texel: number): readonly number[] {
    if (this.#places.covered[texel] !== 1) return [];
    return [...this.#inChart(texel), ...(this.#acrossSeams.get(texel) ?? [])];
  }

  #inChart(texel: number): number[] {
    const { covered } = this.#places;
    const grid = this.#grids.findLast(({ first }) => first <= texel);
    if (grid === undefined) return [];
    const { first, width, height } = grid;
    const [x, y] = [(texel - first) % width, Math.floor((texel - first) / width)];
    const found: number[] = [];
    const look = (other: number): void => {
      if (covered[other] === 1 && this.#areNear(texel, other, MOST_IN_CHART)) found.push(other);
    };
    if (x > 0) look(texel - 1);
    if (x < width - 1) look(texel + 1);
    if (y > 0) look(texel - width);
    if (y < height - 1) look(texel + width);
    return found;
  }

  /** A grid of cells as wide as the widest texel: what is near lies in the cells around. */
  #joinBorders(border: readonly number[]): void {
    const { positions, sizes } = this.#places;
    const cell = MOST_ACROSS_SEAM * Math.max(0, ...border.map((texel) => sizes[texel] as number));
    if (!(cell > 0)) return;
    const cellsOf = (texel: number): [number, number, number] => [
      Math.floor((positions[texel * 3] as number) / cell),
      Math.floor((positions[texel * 3 + 1] as number) / cell),
      Math.floor((positions[texel * 3 + 2] as number) / cell),
    ];
    const grid = new Map<string, number[]>();
    for (const texel of border) {
      const key = cellsOf(texel).join();
      const held = grid.get(key);
      if (held === undefined) grid.set(key, [texel]);
      else held.push(texel);
    }
    for (const texel of border) {
      const [x, y, z] = cellsOf(texel);
      const inChart = this.#inChart(texel);
      const near: number[] = [];
      for (const stepX of [-1, 0, 1]) {
        for (const stepY of [-1, 0, 1]) {
          for (const stepZ of [-1, 0, 1]) {
            for (const other of grid.get(`${x + stepX},${y + stepY},${z + stepZ}`) ?? []) {
              const isNew = other !== texel && !inChart.includes(other);
              if (isNew && this.#areNear(texel, other, MOST_ACROSS_SEAM)) near.push(other);
            }
          }
        }
      }
      if (near.length > 0) this.#acrossSeams.set(texel, near);
    }
  }

  #areNear(a: number, b: number, widths: number): boolean {
    const { positions, normals, shells, sizes } = this.#places;
    if (shells[a] !== shells[b]) return false;
    let square = 0;
    let alike = 0;
    for (let axis = 0; axis < 3; axis++) {
      square += ((positions[a * 3 + axis] as number) - (positions[b * 3 + axis] as number)) ** 2;
      alike += (normals[a * 3 + axis] as number) * (normals[b * 3 + axis] as number);
    }
    const width = ((sizes[a] as number) + (sizes[b] as number)) / 2;
    return alike > LEAST_ALIKE && square <= (widths * width) ** 2;
  }
}

function joinedPlaces(textures: readonly TexelPlaces[]): Omit<TexelPlaces, "width" | "height"> {
  const [only] = textures;
  if (only !== undefined && textures.length === 1) return only;
  return {
    covered: Uint8Array.from(textures.flatMap(({ covered }) => [...covered])),
    positions: Float32Array.from(textures.flatMap(({ positions }) => [...positions])),
    normals: Float32Array.from(textures.flatMap(({ normals }) => [...normals])),
    shells: Uint32Array.from(textures.flatMap(({ shells }) => [...shells])),
    sizes: Float32Array.from(textures.flatMap(({ sizes }) => [...sizes])),
  };
}

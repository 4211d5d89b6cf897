/**
 * A picture laid on other texture coordinates, so that the model looks as before: each new texel takes the mean of the
 * old picture under it. By + - * / alone and without a canvas, so that it gives the same bytes everywhere (spec.md, 7).
 *
 * A plain TypeScript loop and not the core's projection of a flattened copy: that one's places are exact to 2^-15 of the model
 * (spec.md, 2), a third of a pixel where coordinates repeat a picture ten times, and it knows no mirrored or clamped edge.
 */
import type { Picture } from "../engine-api.ts";

/** How a picture goes on beyond its edges (glTF's sampler.wrapS, wrapT). */
export type Wrap = "repeat" | "mirror" | "clamp";

export interface OldTexture {
  readonly picture: Picture;
  readonly wrap: readonly [u: Wrap, v: Wrap];
  /** Magnified without a blend between its pixels. */
  readonly nearest: boolean;
}

/** Triangles of one mesh: six numbers each, u and v of three corners. */
export interface MovedTriangles {
  /** In the old picture, 0 to 1 and beyond. */
  readonly from: Float64Array;
  /** Texels of the new one; NaN for a triangle that has no place there. */
  readonly to: Float32Array;
}

/** How far beyond a triangle's edge texels take its colour by their own place, texels: what a bilinear sample there reads. */
const RING = 2;
/** Samples along a texel's side, at most. */
const MAX_SAMPLES = 8;
/** Inside, with a little to spare for rounding. */
const EDGE = -1e-9;

/** RGBA, straight alpha, `size` x `size`; every texel has a colour, those outside of all triangles that of the nearest one. */
export function resampleTexture(old: OldTexture, meshes: readonly MovedTriangles[], size: number): Uint8Array {
  const rgba = new Uint8Array(4 * size * size);
  const { owners, triangles } = claimTexels(old.picture, meshes, size);
  const color = new Float64Array(4);
  let known = -1;
  let triangle: Triangle | null = null;
  for (let texel = 0; texel < owners.length; texel++) {
    const owner = owners[texel] as number;
    if (owner < 0) continue;
    if (owner !== known) triangle = triangles(owner);
    known = owner;
    if (triangle === null) continue;
    sampleTexel(old, triangle, texel % size, Math.floor(texel / size), color);
    for (let channel = 0; channel < 4; channel++) {
      rgba[4 * texel + channel] = Math.floor((color[channel] as number) + 0.5);
    }
  }
  bleed(rgba, owners, size);
  return rgba;
}

/** What a triangle's texels need to know, all in doubles. A weight or a coordinate at (x, y) is a * x + b * y + c. */
interface Triangle {
  readonly x: readonly [number, number, number];
  readonly y: readonly [number, number, number];
  /** The weights of the second and the third corner; the first has the rest. */
  readonly second: Plane;
  readonly third: Plane;
  /** Pixels of the old picture. */
  readonly across: Plane;
  readonly down: Plane;
}

interface Plane {
  readonly a: number;
  readonly b: number;
  readonly c: number;
}

function triangleAt({ from, to }: MovedTriangles, index: number, { width, height }: Picture): Triangle | null {
  const i = 6 * index;
  const x = [to[i], to[i + 2], to[i + 4]] as [number, number, number];
  const y = [to[i + 1], to[i + 3], to[i + 5]] as [number, number, number];
  const area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  // NaN too.
  if (!(Math.abs(area) > 1e-12)) return null;
  const plane = (at0: number, at1: number, at2: number): Plane => {
    const a = ((at1 - at0) * (y[2] - y[0]) - (at2 - at0) * (y[1] - y[0])) / area;
    const b = ((at2 - at0) * (x[1] - x[0]) - (at1 - at0) * (x[2] - x[0])) / area;
    return { a, b, c: at0 - a * x[0] - b * y[0] };
  };
  const old = (at: number, pixels: number): Plane =>
    plane((from[at] ?? 0) * pixels, (from[at + 2] ?? 0) * pixels, (from[at + 4] ?? 0) * pixels);
  return { x, y, second: plane(0, 1, 0), third: plane(0, 0, 1), across: old(i, width), down: old(i + 1, height) };
}

/** For each texel the triangle that colours it, counted through all meshes; -1 without one. */
function claimTexels(picture: Picture, meshes: readonly MovedTriangles[], size: number) {
  const owners = new Int32Array(size * size).fill(-1);
  const distances = new Float32Array(size * size).fill(Number.POSITIVE_INFINITY);
  const starts: number[] = [];
  let count = 0;
  for (const mesh of meshes) {
    starts.push(count);
    for (let i = 0; i < mesh.to.length / 6; i++) {
      const triangle = triangleAt(mesh, i, picture);
      if (triangle !== null) claim(triangle, count + i, owners, distances, size);
    }
    count += mesh.to.length / 6;
  }
  const triangles = (owner: number): Triangle | null => {
    let mesh = starts.length - 1;
    while ((starts[mesh] as number) > owner) mesh--;
    return triangleAt(meshes[mesh] as MovedTriangles, owner - (starts[mesh] as number), picture);
  };
  return { owners, triangles };
}

function claim(triangle: Triangle, owner: number, owners: Int32Array, distances: Float32Array, size: number): void {
  const { x, y } = triangle;
  const left = Math.max(0, Math.floor(Math.min(...x) - RING));
  const right = Math.min(size - 1, Math.ceil(Math.max(...x) + RING));
  const top = Math.max(0, Math.floor(Math.min(...y) - RING));
  const bottom = Math.min(size - 1, Math.ceil(Math.max(...y) + RING));
  for (let row = top; row <= bottom; row++) {
    for (let column = left; column <= right; column++) {
      const texel = row * size + column;
      if (distances[texel] === 0) continue;
      const distance = distanceTo(triangle, column + 0.5, row + 0.5);
      if (distance > RING * RING || distance >= (distances[texel] as number)) continue;
      distances[texel] = distance;
      owners[texel] = owner;
    }
  }
}

function isInside({ second, third }: Triangle, x: number, y: number): boolean {
  const atSecond = second.a * x + second.b * y + second.c;
  const atThird = third.a * x + third.b * y + third.c;
  return atSecond >= EDGE && atThird >= EDGE && atSecond + atThird <= 1 - EDGE;
}

/** Squared, texels; 0 inside. */
function distanceTo(triangle: Triangle, x: number, y: number): number {
  if (isInside(triangle, x, y)) return 0;
  const [nearX, nearY] = nearestOnEdges(triangle, x, y);
  return (x - nearX) * (x - nearX) + (y - nearY) * (y - nearY);
}

/** The point of the triangle's edges that is nearest to one outside. */
function nearestOnEdges({ x, y }: Triangle, px: number, py: number): readonly [number, number] {
  let least = Number.POSITIVE_INFINITY;
  let found: readonly [number, number] = [px, py];
  for (let from = 0; from < 3; from++) {
    const ax = x[from] as number;
    const ay = y[from] as number;
    const dx = (x[(from + 1) % 3] as number) - ax;
    const dy = (y[(from + 1) % 3] as number) - ay;
    const length = dx * dx + dy * dy;
    const along = length > 0 ? Math.min(1, Math.max(0, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
    const qx = ax + along * dx;
    const qy = ay + along * dy;
    const distance = (px - qx) * (px - qx) + (py - qy) * (py - qy);
    if (distance >= least) continue;
    least = distance;
    found = [qx, qy];
  }
  return found;
}

/** The mean of the old picture over what of a texel lies in its triangle; outside of it, the colour of its nearest edge. */
function sampleTexel(old: OldTexture, triangle: Triangle, column: number, row: number, color: Float64Array): void {
  const samples = samplesFor(triangle);
  color.fill(0);
  let count = 0;
  for (let j = 0; j < samples; j++) {
    for (let i = 0; i < samples; i++) {
      const x = column + (i + 0.5) / samples;
      const y = row + (j + 0.5) / samples;
      if (!isInside(triangle, x, y)) continue;
      addSample(old, triangle, x, y, color);
      count++;
    }
  }
  if (count === 0) {
    const inside = isInside(triangle, column + 0.5, row + 0.5);
    const [x, y] = inside ? [column + 0.5, row + 0.5] : nearestOnEdges(triangle, column + 0.5, row + 0.5);
    addSample(old, triangle, x, y, color);
    count = 1;
  }
  for (let channel = 0; channel < 4; channel++) color[channel] = (color[channel] as number) / count;
}

/** As many along a side as a texel spans old pixels. */
function samplesFor({ across, down }: Triangle): number {
  const span = Math.max(Math.abs(across.a) + Math.abs(across.b), Math.abs(down.a) + Math.abs(down.b));
  return Math.min(MAX_SAMPLES, Math.max(1, Math.ceil(span - 1e-6)));
}

function addSample(
  { picture, wrap, nearest }: OldTexture,
  { across, down }: Triangle,
  newX: number,
  newY: number,
  color: Float64Array,
): void {
  const { width, height, rgba } = picture;
  const x = across.a * newX + across.b * newY + across.c;
  const y = down.a * newX + down.b * newY + down.c;
  if (nearest) {
    const at = 4 * (wrapped(Math.floor(y), height, wrap[1]) * width + wrapped(Math.floor(x), width, wrap[0]));
    for (let channel = 0; channel < 4; channel++)
      color[channel] = (color[channel] as number) + (rgba[at + channel] ?? 0);
    return;
  }
  const left = Math.floor(x - 0.5);
  const top = Math.floor(y - 0.5);
  const fx = x - 0.5 - left;
  const fy = y - 0.5 - top;
  const x0 = wrapped(left, width, wrap[0]);
  const x1 = wrapped(left + 1, width, wrap[0]);
  const y0 = width * wrapped(top, height, wrap[1]);
  const y1 = width * wrapped(top + 1, height, wrap[1]);
  for (let channel = 0; channel < 4; channel++) {
    const upper = (rgba[4 * (y0 + x0) + channel] ?? 0) * (1 - fx) + (rgba[4 * (y0 + x1) + channel] ?? 0) * fx;
    const lower = (rgba[4 * (y1 + x0) + channel] ?? 0) * (1 - fx) + (rgba[4 * (y1 + x1) + channel] ?? 0) * fx;
    color[channel] = (color[channel] as number) + upper * (1 - fy) + lower * fy;
  }
}

function wrapped(index: number, length: number, wrap: Wrap): number {
  if (!Number.isFinite(index)) return 0;
  if (wrap === "clamp") return Math.min(length - 1, Math.max(0, index));
  const period = wrap === "mirror" ? 2 * length : length;
  const inside = ((index % period) + period) % period;
  return inside < length ? inside : period - 1 - inside;
}

/**
 * Gives every texel without a triangle the colour of one near it, in two sweeps (Danielsson 1980): a viewer's mip levels mix
 * them in.
 */
function bleed(rgba: Uint8Array, owners: Int32Array, size: number): void {
  const sources = new Int32Array(size * size);
  for (let texel = 0; texel < sources.length; texel++) sources[texel] = (owners[texel] as number) < 0 ? -1 : texel;
  const distance = (source: number, column: number, row: number): number => {
    const dx = (source % size) - column;
    const dy = Math.floor(source / size) - row;
    return dx * dx + dy * dy;
  };
  const sweep = (forward: boolean): void => {
    const step = forward ? -1 : 1;
    for (let n = 0; n < size * size; n++) {
      const texel = forward ? n : size * size - 1 - n;
      if ((owners[texel] as number) >= 0) continue;
      const column = texel % size;
      const row = Math.floor(texel / size);
      let best = sources[texel] as number;
      let least = best < 0 ? Number.POSITIVE_INFINITY : distance(best, column, row);
      for (let k = 0; k < 4; k++) {
        const dx = k === 0 ? step : k - 2;
        const dy = k === 0 ? 0 : step;
        if (column + dx < 0 || column + dx >= size || row + dy < 0 || row + dy >= size) continue;
        const other = sources[texel + dy * size + dx] as number;
        if (other < 0) continue;
        const far = distance(other, column, row);
        if (far >= least) continue;
        least = far;
        best = other;
      }
      sources[texel] = best;
    }
  };
  sweep(true);
  sweep(false);
  for (const [texel, source] of sources.entries()) {
    if (source < 0 || source === texel) continue;
    rgba.copyWithin(4 * texel, 4 * source, 4 * source + 4);
  }
}

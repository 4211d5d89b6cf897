/**
 * Flat art: a zone's part of the texture laid out flat at its true size and the right way up. The way from texels to
 * metres is the one linear map that has the zone's mean metric: exact on planes, cylinders and cones that are unwrapped
 * without stretch, the nearest flat thing elsewhere.
 */
import type { ZoneSurface } from "../core/abi.ts";
import type { Picture } from "./engine-api.ts";
import type { TexelRect } from "./zone-clip.ts";

/** Columns: what a texel to the right, and one down, is on the art; metres of the model, x to the right and y down. */
export interface FlatMap {
  readonly xx: number;
  readonly xy: number;
  readonly yx: number;
  readonly yy: number;
}

/** Turns smaller than this share of a radian are rounding: art comes out upright, and not askew by a hair. */
const UPRIGHT = 1e-3;
/** More samples a side for a pixel of the art would not show. */
const MOST_SAMPLES = 8;

/** A zone whose surface lies level has no up of its own: it keeps the texture's. */
export function flatMap({ metric, up, mirrored }: ZoneSurface): FlatMap {
  const [across, skew, down] = metric as readonly [number, number, number];
  // The symmetric square root of the metric.
  const root = Math.sqrt(Math.max(0, across * down - skew * skew));
  const trace = Math.sqrt(across + down + 2 * root);
  const s = { xx: (across + root) / trace, xy: skew / trace, yx: skew / trace, yy: (down + root) / trace };
  const flip = mirrored > 0.5 ? -1 : 1;
  const flat = { xx: flip * s.xx, xy: s.xy, yx: flip * s.yx, yy: s.yy };
  const turn = uprightTurn(flat, up as readonly [number, number]);
  return {
    xx: turn.a * flat.xx - turn.b * flat.xy,
    xy: turn.b * flat.xx + turn.a * flat.xy,
    yx: turn.a * flat.yx - turn.b * flat.yy,
    yy: turn.b * flat.yx + turn.a * flat.yy,
  };
}

/** The turn that puts `up` upwards: (a, b) is its first column. */
function uprightTurn(flat: FlatMap, up: readonly [number, number]): { readonly a: number; readonly b: number } {
  const x = flat.xx * up[0] + flat.yx * up[1];
  const y = flat.xy * up[0] + flat.yy * up[1];
  const length = Math.sqrt(x * x + y * y);
  // The mean of slopes: 1 where the surface stands upright, 0 where it lies level.
  if (!(length > 0.05)) return { a: 1, b: 0 };
  if (Math.abs(x) < UPRIGHT * length) return { a: y < 0 ? 1 : -1, b: 0 };
  if (Math.abs(y) < UPRIGHT * length) return { a: 0, b: x < 0 ? 1 : -1 };
  return { a: -y / length, b: -x / length };
}

/** Where the art lies: its extent, metres, of all texels that are not clear. */
export interface FlatBounds {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Of the art's picture: null where all of it is clear. What a texel at the edge is covered of tells where in it the edge lies. */
export function flatBounds(cover: Uint8Array, rect: TexelRect, map: FlatMap): FlatBounds | null {
  const bounds = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  const add = (x: number, y: number): void => {
    const at = { x: map.xx * x + map.yx * y, y: map.xy * x + map.yy * y };
    bounds.left = Math.min(bounds.left, at.x);
    bounds.right = Math.max(bounds.right, at.x);
    bounds.top = Math.min(bounds.top, at.y);
    bounds.bottom = Math.max(bounds.bottom, at.y);
  };
  for (let y = 0; y < rect.height; y++) {
    const edges = edgesIn(rect.width, (x) => cover[y * rect.width + x] as number);
    for (const x of edges) add(rect.x + x, rect.y + y + 0.5);
  }
  for (let x = 0; x < rect.width; x++) {
    const edges = edgesIn(rect.height, (y) => cover[y * rect.width + x] as number);
    for (const y of edges) add(rect.x + x + 0.5, rect.y + y);
  }
  return bounds.left < bounds.right && bounds.top < bounds.bottom ? bounds : null;
}

/** Where along a row or a column the cover begins and ends; neither where none of it is half covered. */
function edgesIn(count: number, coverAt: (place: number) => number): number[] {
  let first = 0;
  while (first < count && coverAt(first) < 128) first++;
  if (first === count) return [];
  let last = count - 1;
  while (coverAt(last) < 128) last--;
  const share = (place: number): number => (place < 0 || place >= count ? 0 : coverAt(place) / 255);
  return [first + 1 - share(first) - share(first - 1), last + share(last) + share(last + 1)];
}

/** Calls `take` with the art's rows, top down. `texels`: of the rectangle; `width`, `height`: pixels of the art. */
export function sampleFlat(
  texels: Picture,
  rect: TexelRect,
  map: FlatMap,
  bounds: FlatBounds,
  [width, height]: readonly [number, number],
  take: (row: Uint8Array) => void,
): void {
  const det = map.xx * map.yy - map.yx * map.xy;
  const stepX = (bounds.right - bounds.left) / width;
  const stepY = (bounds.bottom - bounds.top) / height;
  // Texels a pixel to the right, and one down.
  const right = { x: (map.yy * stepX) / det, y: (-map.xy * stepX) / det };
  const below = { x: (-map.yx * stepY) / det, y: (map.xx * stepY) / det };
  const longest = Math.sqrt(Math.max(right.x * right.x + right.y * right.y, below.x * below.x + below.y * below.y));
  const samples = Math.min(MOST_SAMPLES, Math.max(1, Math.ceil(longest - 1e-3)));
  const origin = {
    x: (map.yy * bounds.left - map.yx * bounds.top) / det - rect.x,
    y: (-map.xy * bounds.left + map.xx * bounds.top) / det - rect.y,
  };
  const row = new Uint8Array(width * 4);
  const sum = new Float64Array(4);
  for (let j = 0; j < height; j++) {
    for (let i = 0; i < width; i++) {
      sum.fill(0);
      for (let n = 0; n < samples; n++) {
        const v = j + (n + 0.5) / samples;
        for (let m = 0; m < samples; m++) {
          const u = i + (m + 0.5) / samples;
          addSample(texels, origin.x + right.x * u + below.x * v, origin.y + right.y * u + below.y * v, sum);
        }
      }
      const alpha = sum[3] as number;
      for (let c = 0; c < 3; c++) row[i * 4 + c] = alpha > 0 ? Math.round((sum[c] as number) / alpha) : 0;
      row[i * 4 + 3] = Math.round(alpha / (samples * samples));
    }
    take(row);
  }
}

/** Bilinear, colours weighted by alpha. */
function addSample({ width, height, rgba }: Picture, x: number, y: number, sum: Float64Array): void {
  const left = Math.floor(x - 0.5);
  const top = Math.floor(y - 0.5);
  const shareX = x - 0.5 - left;
  const shareY = y - 0.5 - top;
  for (let dy = 0; dy < 2; dy++) {
    const row = Math.min(height - 1, Math.max(0, top + dy));
    for (let dx = 0; dx < 2; dx++) {
      const column = Math.min(width - 1, Math.max(0, left + dx));
      const at = (row * width + column) * 4;
      const weight = (dx ? shareX : 1 - shareX) * (dy ? shareY : 1 - shareY) * (rgba[at + 3] as number);
      for (let c = 0; c < 3; c++) sum[c] = (sum[c] as number) + weight * (rgba[at + c] as number);
      sum[3] = (sum[3] as number) + weight;
    }
  }
}

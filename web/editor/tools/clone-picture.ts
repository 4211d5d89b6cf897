/** The pictures that the clone tool throws: of what an eye sees, and of a piece of the flat texture. */
import type { Picture } from "../../engine/engine-api.ts";
import type { SurfaceSight } from "../../viewer/viewer-api.ts";

/** Pixels; right and bottom are the first that are outside. */
export interface PixelArea {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What is seen, in the colours of the textures by material; clear beside the model, outside `area`, and where there is no texture. */
export function pictureOfSight(
  { width, height, materials, uvs }: SurfaceSight,
  textures: ReadonlyMap<number, Picture>,
  area: PixelArea,
  nearest: boolean,
): Picture {
  const rgba = new Uint8Array(width * height * 4);
  const sample = nearest ? nearestTexel : mixedTexel;
  for (let y = Math.max(0, area.top); y < Math.min(height, area.bottom); y++) {
    for (let x = Math.max(0, area.left); x < Math.min(width, area.right); x++) {
      const pixel = y * width + x;
      const texture = textures.get(materials[pixel] as number);
      if (texture !== undefined) {
        sample(texture, uvs[pixel * 2] as number, uvs[pixel * 2 + 1] as number, rgba, pixel * 4);
      }
    }
  }
  return { width, height, rgba };
}

/** Up to `reach` texels to each side of a place, which may lie beyond the texture; then of the border's texel that is nearest to it. */
export function areaAround(
  { width, height }: Pick<Picture, "width" | "height">,
  [u, v]: readonly [number, number],
  reach: number,
): PixelArea {
  const span = (place: number, size: number): readonly [number, number] => {
    const middle = Math.min(size - 1, Math.max(0, Math.floor(place * size)));
    return [Math.max(0, middle - reach), Math.min(size, middle + reach)];
  };
  const [left, right] = span(u, width);
  const [top, bottom] = span(v, height);
  return { left, top, right, bottom };
}

/** The texels of an area, which may reach over the texture's borders; there it is clear. */
export function pieceOf({ width, height, rgba }: Picture, { left, top, right, bottom }: PixelArea): Picture {
  const piece = new Uint8Array((right - left) * (bottom - top) * 4);
  const [from, to] = [Math.max(0, left), Math.min(width, right)];
  if (from < to) {
    for (let y = Math.max(0, top); y < Math.min(height, bottom); y++) {
      const row = rgba.subarray((y * width + from) * 4, (y * width + to) * 4);
      piece.set(row, ((y - top) * (right - left) + from - left) * 4);
    }
  }
  return { width: right - left, height: bottom - top, rgba: piece };
}

function nearestTexel({ width, height, rgba }: Picture, u: number, v: number, out: Uint8Array, at: number): void {
  const from = (wrapped(Math.floor(v * height), height) * width + wrapped(Math.floor(u * width), width)) * 4;
  for (let channel = 0; channel < 4; channel++) out[at + channel] = rgba[from + channel] as number;
}

/** The four texels around a place by their shares, colours by their alpha. */
function mixedTexel({ width, height, rgba }: Picture, u: number, v: number, out: Uint8Array, at: number): void {
  const [x, y] = [u * width - 0.5, v * height - 0.5];
  const [column, row] = [Math.floor(x), Math.floor(y)];
  const [right, down] = [x - column, y - row];
  const [left, next] = [wrapped(column, width), wrapped(column + 1, width)];
  const [upper, lower] = [wrapped(row, height) * width, wrapped(row + 1, height) * width];
  let [red, green, blue, alpha] = [0, 0, 0, 0];
  const add = (texel: number, share: number): void => {
    const weight = share * (rgba[texel * 4 + 3] as number);
    red += weight * (rgba[texel * 4] as number);
    green += weight * (rgba[texel * 4 + 1] as number);
    blue += weight * (rgba[texel * 4 + 2] as number);
    alpha += weight;
  };
  add(upper + left, (1 - right) * (1 - down));
  add(upper + next, right * (1 - down));
  add(lower + left, (1 - right) * down);
  add(lower + next, right * down);
  if (alpha === 0) return;
  out[at] = Math.round(red / alpha);
  out[at + 1] = Math.round(green / alpha);
  out[at + 2] = Math.round(blue / alpha);
  out[at + 3] = Math.round(alpha);
}

const wrapped = (index: number, count: number): number => ((index % count) + count) % count;

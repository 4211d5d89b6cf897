/** A pointer's places on the texel grid, in either view. */
import type { SurfaceHit, ToolSample } from "../../viewer/viewer-api.ts";
import type { PixelSize } from "./pixel-session.ts";
import { type Texel, texelLine } from "./pixel-shapes.ts";
import type { PathStep } from "./pointer-path.ts";

/** Texels between two looks at the model that are still one line; more are another chart. */
const MOST_HOP = 3;

/** In texels, with fractions. */
export type GridPlace = readonly [x: number, y: number];

export const placeOfUv = (uv: readonly [number, number], { width, height }: PixelSize): GridPlace => [
  uv[0] * width,
  uv[1] * height,
];

export const texelAt = ([x, y]: GridPlace): Texel => [Math.floor(x), Math.floor(y)];

/** Null beside the model, on another material, and beside the texture. */
export function placeOf(sample: ToolSample, material: number, size: PixelSize): GridPlace | null {
  if (sample.view.kind === "model") {
    return sample.hit?.material === material ? placeOfUv(sample.hit.uv, size) : null;
  }
  const uv = sample.view.uvAt(sample.at);
  return uv && placeOfUv(uv, size);
}

/** A place of one material's grid. */
export interface MaterialPlace {
  readonly material: number;
  readonly at: GridPlace;
}

/** The texels that a path over the surface passes, in its order, joined where it stays within a chart. */
export function texelsAlong(
  steps: readonly PathStep[],
  sizeOf: (material: number) => PixelSize | null,
  from: MaterialPlace | null,
): { readonly places: readonly MaterialPlace[]; readonly last: MaterialPlace | null } {
  const places: MaterialPlace[] = [];
  let last = from;
  for (const step of steps) {
    const material = step?.hit.material;
    const size = material === undefined ? null : sizeOf(material);
    if (step === null || material === undefined || size === null) {
      last = null;
      continue;
    }
    const at = placeOfUv(step.hit.uv, size);
    const joins = last !== null && last.material === material && isNear(last.at, at);
    for (const each of joins ? joined((last as MaterialPlace).at, at) : [at]) places.push({ material, at: each });
    last = { material, at };
  }
  return { places, last };
}

/** By material, in the order in which they come. */
export function byMaterial(places: readonly MaterialPlace[]): ReadonlyMap<number, readonly GridPlace[]> {
  const parts = new Map<number, GridPlace[]>();
  for (const { material, at } of places) {
    const part = parts.get(material);
    if (part === undefined) parts.set(material, [at]);
    else part.push(at);
  }
  return parts;
}

/** From the second texel of the line on to the place itself. */
export function joined(from: GridPlace, to: GridPlace): GridPlace[] {
  const [start, end] = [texelAt(from), texelAt(to)];
  const between = texelLine(start, end).slice(1, -1);
  return [...between.map(([x, y]): GridPlace => [x + 0.5, y + 0.5]), to];
}

/** The corners of a square of texels, texture coordinates, around it. */
export function blockCorners([left, top]: Texel, across: number, { width, height }: PixelSize) {
  const [right, bottom] = [left + across, top + across];
  return [
    [left / width, top / height],
    [right / width, top / height],
    [right / width, bottom / height],
    [left / width, bottom / height],
  ] as const satisfies readonly SurfaceHit["uv"][];
}

const isNear = (a: GridPlace, b: GridPlace): boolean =>
  Math.abs(a[0] - b[0]) <= MOST_HOP && Math.abs(a[1] - b[1]) <= MOST_HOP;

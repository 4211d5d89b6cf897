/** Where the texels of a small texture lie on the model. */
import type { SurfaceQuery } from "./surface-query.ts";
import type { UvPlace } from "./uv-lookup.ts";

/** Of each texel, row by row from the top. A texel counts as covered where its middle or a corner lies in a triangle. */
export interface TexelPlaces {
  readonly width: number;
  readonly height: number;
  /** 1 where covered. */
  readonly covered: Uint8Array;
  /** Three numbers a texel, metres, model space. */
  readonly positions: Float32Array;
  /** Three numbers a texel, unit. */
  readonly normals: Float32Array;
  /** The connected part of the model that it lies on. */
  readonly shells: Uint32Array;
  /** Metres that it is wide: the root of its area. */
  readonly sizes: Float32Array;
}

/** Where a texel is looked at: its middle, else near its corners. A chart that merely touches it there does not count. */
const LOOKS = [
  [0.5, 0.5],
  [0.02, 0.02],
  [0.98, 0.02],
  [0.02, 0.98],
  [0.98, 0.98],
] as const;

/** Looks every texel up, so that time goes with width times height: for skins of some hundred texels across. */
export function texelPlaces(query: SurfaceQuery, material: number, width: number, height: number): TexelPlaces {
  const count = width * height;
  const places = {
    width,
    height,
    covered: new Uint8Array(count),
    positions: new Float32Array(count * 3),
    normals: new Float32Array(count * 3),
    shells: new Uint32Array(count),
    sizes: new Float32Array(count),
  };
  const sizeOf = new Map<number, number>();
  for (let texel = 0; texel < count; texel++) {
    const place = placeIn(query, material, texel % width, Math.floor(texel / width), { width, height });
    if (place === null) continue;
    const sample = query.at(place.triangle, place.shares);
    let size = sizeOf.get(place.triangle);
    if (size === undefined) {
      const { u, v } = query.uvGradients(place.triangle);
      size = 1 / Math.sqrt(u.clone().cross(v).length() * width * height);
      sizeOf.set(place.triangle, size);
    }
    places.covered[texel] = 1;
    sample.position.toArray(places.positions, texel * 3);
    sample.normal.toArray(places.normals, texel * 3);
    places.shells[texel] = query.shellOf(place.triangle);
    places.sizes[texel] = size;
  }
  return places;
}

function placeIn(
  query: SurfaceQuery,
  material: number,
  column: number,
  row: number,
  { width, height }: { readonly width: number; readonly height: number },
): UvPlace | null {
  for (const [x, y] of LOOKS) {
    const place = query.triangleAtUv(material, [(column + x) / width, (row + y) / height]);
    if (place !== null) return place;
  }
  return null;
}

/** A surface that is asked once for each place, by the place's own object: a drag asks at each of its moves where things began. */
import type { Vec3 } from "../../engine/engine-api.ts";
import type { SurfaceHit, ToolSurface } from "../../viewer/viewer-api.ts";

/** What is asked of the surface to carry a mask over it. */
export type MaskSurface = Pick<ToolSurface, "near" | "atUv">;

/** Holds for as long as the surface stays as it is. */
export function rememberedSurface(surface: MaskSurface): MaskSurface {
  const feet = new WeakMap<Vec3, SurfaceHit | null>();
  return {
    near: (place) => {
      const known = feet.get(place);
      if (known !== undefined) return known;
      const foot = surface.near(place);
      feet.set(place, foot);
      return foot;
    },
    atUv: (material, uv) => surface.atUv(material, uv),
  };
}

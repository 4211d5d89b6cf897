/** The middles of a model, as planes that a decal can lie in. */
import type { ModelInfo, Vec3 } from "../../engine/engine-api.ts";
import type { ModelMiddle } from "../../viewer/viewer-api.ts";
import { mirrorOf } from "./mirror-setting.ts";

/** The model's own planes of symmetry: where a mirror would stand. */
export function middlesOf(info: Pick<ModelInfo, "boundsMin" | "boundsMax">): ModelMiddle[] {
  return (["x", "y", "z"] as const).flatMap((axis) => {
    const mirror = mirrorOf(axis, info);
    const along = (length: number): Vec3 => [
      axis === "x" ? length : 0,
      axis === "y" ? length : 0,
      axis === "z" ? length : 0,
    ];
    return mirror ? [{ point: along(mirror.offset), normal: along(1) }] : [];
  });
}

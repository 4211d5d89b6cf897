/** What the view tells of a place of its surface. */
import { tupleOf } from "./decal-pose.ts";
import type { SurfaceSample } from "./surface-query.ts";
import type { SurfaceHit } from "./viewer-api.ts";

export function hitOf(sample: SurfaceSample): SurfaceHit {
  return {
    position: tupleOf(sample.position),
    normal: tupleOf(sample.normal),
    material: sample.material,
    uv: [wrapUnit(sample.uv[0]), wrapUnit(sample.uv[1])],
    face: sample.face,
    isBack: sample.isBack,
  };
}

function wrapUnit(value: number): number {
  const wrapped = value - Math.floor(value);
  return wrapped < 1 ? wrapped : 0;
}

/** Where a material's triangles go beyond its texture, which repeats there (spec.md, section 1), whatever its sampler says. */

/** Half a texel of one of 2048: what goes beyond by less has no texel there, and repeated would show the other edge's colour. */
const SLACK = 2 ** -12;

/** @param axis 0: to the left or right, 1: above or below */
export function goesBeyond(
  { uvMin, uvMax }: { readonly uvMin: ArrayLike<number>; readonly uvMax: ArrayLike<number> },
  axis: 0 | 1,
): boolean {
  return (uvMin[axis] ?? 0) < -SLACK || (uvMax[axis] ?? 0) > 1 + SLACK;
}

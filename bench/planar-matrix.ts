/** The matrices that the plain method takes, from a projector as designs have it (position, rotation, size). */
import type { PlanarProjector } from "../web/engine/engine-api.ts";

/** Model space to the decal's box [-1/2, 1/2]^3: 3 rows of 4. */
export function decalFromModel({ position, rotation, size }: PlanarProjector): number[] {
  const axes = boxAxes(rotation);
  return axes.flatMap((axis, row) => {
    const scaled = axis.map((component) => component / size[row]);
    return [...scaled, -scaled.reduce((sum, component, index) => sum + component * position[index], 0)];
  });
}

/** The box's +Z, from the surface to the viewer. Unit. */
export function directionModel({ rotation }: PlanarProjector): number[] {
  return boxAxes(rotation)[2];
}

/** The box's x, y and z axes in model space: the columns of the rotation's matrix. */
export function boxAxes([x, y, z, w]: PlanarProjector["rotation"]): number[][] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
}

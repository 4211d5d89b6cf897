/** A viewer of a model that is a sheet across Z: what slides on it goes straight. */
import type { Projector } from "../../web/engine/engine-api.ts";
import type { ModelMiddle } from "../../web/viewer/viewer-api.ts";

export const sheet = {
  centred(projector: Projector, [middle]: readonly ModelMiddle[]): Projector {
    if (projector.kind !== "planar" || !middle) return projector;
    const { point, normal } = middle;
    const away = normal.reduce(
      (sum, part, axis) => sum + part * ((projector.position[axis] ?? 0) - (point[axis] ?? 0)),
      0,
    );
    const [x, y, z] = projector.position;
    return { ...projector, position: [x - away * normal[0], y - away * normal[1], z - away * normal[2]] };
  },
};

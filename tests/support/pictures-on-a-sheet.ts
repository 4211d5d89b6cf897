/** Pictures on a model that is a sheet across Z, and its viewer: what slides on it goes straight. */
import { makeDecalLayer, type PlacedLayer } from "../../web/editor/document/index.ts";
import type { CylindricalProjector, Projector, UvProjector } from "../../web/engine/engine-api.ts";
import type { ModelMiddle } from "../../web/viewer/viewer-api.ts";

/** Sine and cosine of half a quarter turn. */
export const HALF = Math.SQRT1_2;

export const layer = (id: string, projector: Projector, material = 0): PlacedLayer =>
  makeDecalLayer({ id, name: id, material, asset: "logo", projector, filter: "linear" });

/** @param spin sine and cosine of half its turn about Z */
export const box = (
  x: number,
  y: number,
  [width, height] = [0.2, 0.2],
  spin: readonly [number, number] = [0, 1],
): Projector => ({
  ...{ kind: "planar", position: [x, y, 0], rotation: [0, 0, spin[0], spin[1]], size: [width, height, 0.1] },
});

export const stamp = (u: number, v: number, [width, height] = [0.1, 0.05], angle = 0): UvProjector => ({
  ...{ kind: "uv", center: [u, v], size: [width, height], angle },
});

export const label: CylindricalProjector = {
  ...{ kind: "cylindrical", position: [0, 0, 0], rotation: [0, 0, 0, 1], radius: 1, height: 1, arc: 90, depth: 0.1 },
};

/** Centres and positions in their plane, to a billionth. */
export const placesOf = (projectors: readonly Projector[]): number[][] =>
  projectors.map((projector) => {
    const place = projector.kind === "uv" ? projector.center : projector.position.slice(0, 2);
    return place.map((part) => Math.round(part * 1e9) / 1e9);
  });

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

import { expect, it } from "vitest";
import { type Design, emptyDesign, makeDecalLayer, makeGroupLayer } from "../../web/editor/document/index.ts";
import { clearPlaces } from "../../web/editor/state/clear-place.ts";
import type { PlanarProjector, Projector, UvProjector } from "../../web/engine/engine-api.ts";

const box = (x: number, y: number): PlanarProjector => ({
  kind: "planar",
  position: [x, y, 0],
  rotation: [0, 0, 0, 1],
  size: [1, 1, 1],
});
const stamp = (size: number): UvProjector => ({ kind: "uv", center: [0.5, 0.5], size: [size, size], angle: 0 });
const designOf = (...projectors: Projector[]): Design => ({
  ...emptyDesign(),
  layers: projectors.map((projector, index) => makeDecalLayer({ id: `d${index}`, asset: "a", projector })),
});
/** A flat wall, and a texture as wide as the wall. */
const wall = {
  nudge: (projector: Projector, right: number, up: number): Projector =>
    projector.kind === "uv"
      ? { ...projector, center: [projector.center[0] + right / 100, projector.center[1] - up / 100] }
      : { ...projector, position: [projector.position[0] + right, projector.position[1] + up, projector.position[2]] },
};

it("leaves a place as it is where no other decal lies, or one beside it", () => {
  expect(clearPlaces(designOf(box(3, 0)), 100, wall)(box(0, 0))).toEqual(box(0, 0));
});

it("goes down to the right past every decal that lies on the way", () => {
  expect(clearPlaces(designOf(box(0, 0), box(4, -4)), 100, wall)(box(0, 0))).toEqual(box(8, -8));
});

it("takes what lies as good as there for its place, on either side, and nothing that is half a step away", () => {
  for (const aside of [-1.9, -0.1, 0.1, 1.9]) {
    expect(clearPlaces(designOf(box(aside, 0)), 100, wall)(box(0, 0))).toEqual(box(4, -4));
  }
  for (const aside of [-2, 2, 4]) expect(clearPlaces(designOf(box(aside, 0)), 100, wall)(box(0, 0))).toEqual(box(0, 0));
  expect(clearPlaces(designOf(box(0, 1.9)), 100, wall)(box(0, 0))).toEqual(box(4, -4));
});

it("sees what lies in a group", () => {
  const { layers } = designOf(box(0, 0));
  const grouped = { layers: [makeGroupLayer({ id: "g", layers })] };
  expect(clearPlaces(grouped, 100, wall)(box(0, 0))).toEqual(box(4, -4));
});

it("ends where the model does", () => {
  const end = { nudge: (projector: Projector) => projector };
  expect(clearPlaces(designOf(box(0, 0)), 100, end)(box(0, 0))).toEqual(box(0, 0));
});

it("sets a stamp apart in the texture, and leaves alone what covers all of it", () => {
  expect(clearPlaces(designOf(stamp(0.2)), 100, wall)(stamp(0.2)).center[0]).toBeCloseTo(0.54);
  expect(clearPlaces(designOf(stamp(1)), 100, wall)(stamp(1))).toEqual(stamp(1));
});

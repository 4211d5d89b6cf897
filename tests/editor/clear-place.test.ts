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
const cleared = <P extends Projector>(design: Pick<Design, "layers">, projector: P, viewer: typeof wall): P =>
  clearPlaces(design, [projector], 100, viewer)(projector);

it("leaves a place as it is where no other decal lies, or one beside it", () => {
  expect(cleared(designOf(box(3, 0)), box(0, 0), wall)).toEqual(box(0, 0));
});

it("goes down to the right past every decal that lies on the way", () => {
  expect(cleared(designOf(box(0, 0), box(4, -4)), box(0, 0), wall)).toEqual(box(8, -8));
});

it("takes what lies as good as there for its place, on either side, and nothing that is half a step away", () => {
  for (const aside of [-1.9, -0.1, 0.1, 1.9]) {
    expect(cleared(designOf(box(aside, 0)), box(0, 0), wall)).toEqual(box(4, -4));
  }
  for (const aside of [-2, 2, 4]) expect(cleared(designOf(box(aside, 0)), box(0, 0), wall)).toEqual(box(0, 0));
  expect(cleared(designOf(box(0, 1.9)), box(0, 0), wall)).toEqual(box(4, -4));
});

it("sees what lies in a group", () => {
  const { layers } = designOf(box(0, 0));
  const grouped = { layers: [makeGroupLayer({ id: "g", layers })] };
  expect(cleared(grouped, box(0, 0), wall)).toEqual(box(4, -4));
});

it("ends where the model does", () => {
  const end = { nudge: (projector: Projector) => projector };
  expect(cleared(designOf(box(0, 0)), box(0, 0), end)).toEqual(box(0, 0));
});

it("sets a stamp apart in the texture, and leaves alone what covers all of it", () => {
  expect(cleared(designOf(stamp(0.2)), stamp(0.2), wall).center[0]).toBeCloseTo(0.54);
  expect(cleared(designOf(stamp(1)), stamp(1), wall)).toEqual(stamp(1));
});

it("sets several apart as they lie, and none of them on another one of the design", () => {
  const [first, second, third] = [box(0, 0), box(4, -4), box(20, 3)];
  const together = clearPlaces(designOf(first, second, third), [first, second, third], 100, wall);
  expect([first, second, third].map(together)).toEqual([box(8, -8), box(12, -12), box(28, -5)]);
});

it("leaves several where they are if none of them lies on another one", () => {
  const [first, second] = [box(0, 0), box(4, -4)];
  const together = clearPlaces(designOf(box(8, -8)), [first, second], 100, wall);
  expect([first, second].map(together)).toEqual([first, second]);
});

it("searches the surface once for each of very many", () => {
  const boxes = Array.from({ length: 2000 }, (_, k) => box((k % 50) * 4, Math.floor(k / 50) * 4));
  let searches = 0;
  const counted = {
    nudge: (projector: Projector, right: number, up: number): Projector => {
      searches += 1;
      return wall.nudge(projector, right, up);
    },
  };
  const together = clearPlaces(designOf(...boxes), boxes, 100, counted);
  expect(boxes.map(together)).toEqual(boxes.map(({ position: [x, y] }) => box(x + 4, y - 4)));
  expect(searches).toBeLessThan(boxes.length + 100);
});

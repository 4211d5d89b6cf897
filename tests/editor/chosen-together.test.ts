import { expect, it, vi } from "vitest";
import { makeDecalLayer, type PlacedLayer } from "../../web/editor/document/index.ts";
import { changedAlike } from "../../web/editor/state/carried-projector.ts";
import { ChosenTogether, TOGETHER } from "../../web/editor/state/chosen-together.ts";
import { INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { scaledProjector, spunProjector } from "../../web/editor/state/projector-steps.ts";
import { shownStamp } from "../../web/editor/state/shown-stamp.ts";
import { type Stamp, stampsBox, stampWith } from "../../web/editor/state/stamps-together.ts";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  UvProjector,
} from "../../web/engine/engine-api.ts";
import type { ViewerDecal } from "../../web/viewer/viewer-api.ts";

const box = (x: number, width = 0.2): PlanarProjector => ({
  ...{ kind: "planar", position: [x, 0, 0], rotation: [0, 0, 0, 1], size: [width, width, 0.1] },
});
const stamp = (u: number, v: number, angle = 0): UvProjector => ({
  ...{ kind: "uv", center: [u, v], size: [0.1, 0.05], angle },
});
const layer = (id: string, projector: Projector, material = 0): PlacedLayer =>
  makeDecalLayer({ id, name: id, material, asset: "logo", projector, filter: "linear" });
const shown = ({ id, projector }: PlacedLayer, visible = true): ViewerDecal => ({
  ...{ id, name: id, materials: [0], visible, projector, aspect: 1 },
});

/** Of a viewer whose arrangements move all boxes by what the common one has grown. */
function chosen() {
  const arrangement = vi.fn((projectors: readonly Projector[]) => {
    const common = box(0, 1);
    const at = (now: PlanarProjector): Projector[] =>
      projectors.map((each) => (each.kind === "planar" ? { ...each, position: [now.size[0], 0, 0] } : each));
    return projectors.length > 1 ? { box: common, at } : null;
  });
  const setDecals = vi.fn();
  const together = new ChosenTogether({ arrangement, setDecals }, () => ({ material: 0, model: null }));
  return { together, arrangement, setDecals };
}

it("shows a box with handles round what is chosen, and outlines that", () => {
  const { together, setDecals } = chosen();
  const [a, b, c] = [layer("a", box(0)), layer("b", box(1)), layer("c", box(2))];
  const decals = [a, b, c].map((each) => shown(each));
  together.show(decals, "b", [a, b]);
  const [given, held] = setDecals.mock.lastCall as [ViewerDecal[], string];
  expect(held).toBe(TOGETHER);
  expect(given.slice(0, 3)).toEqual(decals);
  expect(given[3]).toMatchObject({ id: TOGETHER, visible: false, projector: box(0, 1) });
  expect(new Set(given[3]?.beside)).toEqual(new Set([a.projector, b.projector]));
  expect(given[3]?.holds, "what a press takes hold of, whatever lies over it").toEqual(decals.slice(0, 2));
});

it("shows handles at one of a chosen group that has no common box, and outlines the others", () => {
  const { together, setDecals } = chosen();
  const [a, b] = [layer("a", box(0)), layer("b", box(1))];
  together.show([shown(a), shown(b)], "group", [a]);
  const [given, held] = setDecals.mock.lastCall as [ViewerDecal[], string];
  expect(held).toBe("a");
  expect(given).toEqual([{ ...shown(a), beside: [], holds: [shown(a)] }, shown(b)]);
  together.show([shown(a, false), shown(b)], "group", [a]);
  expect(setDecals.mock.lastCall?.[1], "of a hidden one none").toBe("group");
});

it("outlines no crowd", () => {
  const { together, setDecals } = chosen();
  const crowd = Array.from({ length: 30 }, (_, index) => layer(`${index}`, box(index)));
  const decals = crowd.map((each) => shown(each));
  together.show(decals, "0", crowd);
  expect((setDecals.mock.lastCall as [ViewerDecal[]])[0].at(-1)?.beside).toEqual([]);
});

it("goes on from where the first of many steps did, until something else has moved one of them", () => {
  const { together, arrangement } = chosen();
  const grow = <P extends Projector>(projector: P): P => scaledProjector(projector, 2);
  const layers = [layer("a", box(0)), layer("b", box(1))];
  const first = together.changed(layers, grow);
  const moved = layers.map((each, index) => ({ ...each, projector: first[index] as Projector }));
  const second = together.changed(moved, grow) as PlanarProjector[];
  expect(second.map(({ position }) => position[0])).toEqual([4, 4]);
  expect(arrangement).toHaveBeenCalledOnce();
  together.changed([layers[0] as PlacedLayer, layer("b", box(3))], grow);
  expect(arrangement).toHaveBeenCalledTimes(2);
});

it("keeps what a drag of the box has made of them when it ends, and not what it shows on its way", () => {
  const { together, arrangement } = chosen();
  const layers = [layer("a", box(0)), layer("b", box(1))];
  together.show(
    layers.map((each) => shown(each)),
    "a",
    layers,
  );
  together.dragged(layers, box(0, 3), false);
  const ended = together.dragged(layers, box(0, 5), true);
  const moved = layers.map((each, index) => ({ ...each, projector: ended[index] as Projector }));
  const after = together.changed(moved, (projector) => scaledProjector(projector, 2)) as PlanarProjector[];
  expect(after.map(({ position }) => position[0])).toEqual([10, 10]);
  expect(arrangement).toHaveBeenCalledOnce();
});

it("turns and sizes stamps about the mean of their middles, those of another texture apart", () => {
  const { together } = chosen();
  const layers = [layer("a", stamp(0.2, 0.5)), layer("b", stamp(0.6, 0.5, 30)), layer("c", stamp(0.9, 0.9), 1)];
  const quarter = <P extends Projector>(projector: P): P => spunProjector(projector, 90);
  const [a, b, c] = together.changed(layers, quarter) as UvProjector[];
  expect(a).toMatchObject({ center: [expect.closeTo(0.4), expect.closeTo(0.7)], angle: -90 });
  expect(b).toMatchObject({ center: [expect.closeTo(0.4), expect.closeTo(0.3)], angle: -60 });
  expect(c).toMatchObject({ center: [0.9, 0.9], angle: -90 });
  let now: readonly Projector[] = layers.map(({ projector }) => projector);
  for (let step = 0; step < 36; step += 1) {
    const there = layers.map((each, index) => ({ ...each, projector: now[index] as Projector }));
    now = together.changed(there, (projector) => spunProjector(scaledProjector(projector, step % 2 ? 0.5 : 2), 10));
  }
  for (const [index, each] of (now as UvProjector[]).entries()) {
    const { center, size, angle } = (layers[index] as PlacedLayer).projector as UvProjector;
    expect(each.center).toEqual(center.map((part) => expect.closeTo(part, 9)));
    expect(each.size).toEqual(size.map((part) => expect.closeTo(part, 9)));
    expect(each.angle).toBeCloseTo(angle, 9);
  }
});

it("shows a box round several stamps of the texture, and takes them along with it", () => {
  const { together } = chosen();
  const layers = [layer("a", stamp(0.2, 0.5)), layer("b", stamp(0.6, 0.4)), layer("c", stamp(0.9, 0.9), 1)];
  const design = { ...INITIAL_STATE.design, layers };
  const held = shownStamp({ ...INITIAL_STATE, design, selectedId: "a", material: 0 }, layers);
  expect(held?.id).toBe(TOGETHER);
  const common = held?.projector as UvProjector;
  expect(common.center).toEqual([expect.closeTo(0.4), expect.closeTo(0.45)]);
  expect(common.size).toEqual([expect.closeTo(0.5), expect.closeTo(0.15)]);
  const [a, b, c] = together.dragged(layers, { ...common, center: [0.4, 0.5], size: [1, 0.15] }, true) as UvProjector[];
  expect(a).toMatchObject({
    center: [expect.closeTo(0), expect.closeTo(0.55)],
    size: [expect.closeTo(0.2), expect.closeTo(0.05)],
  });
  expect(b?.center).toEqual([expect.closeTo(0.8), expect.closeTo(0.45)]);
  expect(c).toBe(layers[2]?.projector);
  const own = shownStamp({ ...INITIAL_STATE, design, selectedId: "c", material: 1 }, layers.slice(2));
  expect(own).toMatchObject({ id: "c", locked: false });
});

it("takes back the stretch of a stamp that is turned in its box", () => {
  const leaning = stamp(0.6, 0.4, 25);
  const common = stampsBox([layer("a", stamp(0.2, 0.5)), layer("b", leaning)] as Stamp[]);
  const wide = { ...common, size: [common.size[0] * 1.7, common.size[1]] } as const;
  const { size } = stampWith(wide, common, stampWith(common, wide, leaning));
  expect(size).toEqual([expect.closeTo(0.1, 9), expect.closeTo(0.05, 9)]);
});

it("changes what has no common middle as the one that is dragged, each where it lies", () => {
  const start = box(0);
  const dragged = spunProjector(scaledProjector(start, 1.5), 30);
  const eye: PerspectiveProjector = {
    ...{ kind: "perspective", position: [0, 0, 2], rotation: [0, 0, 0, 1], fov: 20, aspect: 1, near: 1, far: 3 },
  };
  const label: CylindricalProjector = {
    ...{ kind: "cylindrical", position: [0, 0, 0], rotation: [0, 0, 0, 1] },
    ...{ radius: 1, height: 0.2, arc: 40, depth: 0.1 },
  };
  const other = changedAlike(start, dragged, box(1)) as PlanarProjector;
  const own = spunProjector(scaledProjector(box(1), 1.5), 30);
  expect(other.size[0]).toBeCloseTo(own.size[0]);
  expect(other.rotation).toEqual(own.rotation.map((part) => expect.closeTo(part)));
  expect(other.position).toEqual([1, 0, 0]);
  const seen = changedAlike(eye, scaledProjector(eye, 2), label) as CylindricalProjector;
  expect(seen).toMatchObject({ height: expect.closeTo(0.4), arc: expect.closeTo(80) });
  expect(changedAlike(stamp(0, 0), stamp(0, 0, 40), stamp(0.5, 0.5, 5))).toEqual(stamp(0.5, 0.5, 45));
  const wider = { ...start, size: [0.4, 0.2, 0.1] } as const;
  expect(changedAlike(start, wider, box(1)), "a side alone is the dragged one's").toEqual(box(1));
});

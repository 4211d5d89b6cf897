import { expect, it } from "vitest";
import { carriedProjector, footOf, type NearSurface } from "../../web/editor/state/carried-projector.ts";
import { spun } from "../../web/editor/state/rotation.ts";
import type {
  CylindricalProjector,
  PlanarProjector,
  Projector,
  Quaternion,
  UvProjector,
  Vec3,
} from "../../web/engine/engine-api.ts";

const carried = (start: Projector, now: Projector, other: Projector, near: NearSurface): Projector =>
  carriedProjector(start, now, other, footOf(other, near), near);

const ABOUT_Y = (degrees: number): Quaternion => {
  const half = (degrees * Math.PI) / 360;
  return [0, Math.sin(half), 0, Math.cos(half)];
};
/** On a mug of radius 1 about Y, facing outward, at an angle from +Z towards +X. */
const onMug = (degrees: number, height: number, radius = 1): PlanarProjector => {
  const angle = (degrees * Math.PI) / 180;
  const position: Vec3 = [radius * Math.sin(angle), height, radius * Math.cos(angle)];
  return { kind: "planar", position, rotation: ABOUT_Y(degrees), size: [0.2, 0.3, 0.1] };
};
const mug: NearSurface = ([x, y, z]) => {
  const far = Math.hypot(x, z);
  return { position: [x / far, y, z / far], normal: [x / far, 0, z / far] };
};
const nowhere: NearSurface = () => null;

function expectSame(projector: Projector, wanted: Projector): void {
  const rounded = (value: Projector): unknown =>
    JSON.parse(
      JSON.stringify(value, (_, part) => (typeof part === "number" ? Math.round(part * 1e9) / 1e9 + 0 : part)),
    );
  expect(rounded(projector)).toEqual(rounded(wanted));
}

it("carries what lies on a mug round it, by the same angle and height", () => {
  const moved = carried(onMug(10, 0), onMug(75, 0.4), onMug(-30, 1), mug);
  expectSame(moved, onMug(35, 1.4));
});

it("keeps a place on a table beside the dragged one as far and as turned as it was", () => {
  const flat = (x: number, z: number): PlanarProjector => ({ ...onMug(0, 0), position: [x, 0, z] });
  const turned: PlanarProjector = { ...flat(5, 5), rotation: spun([0, 0, 0, 1], 30) };
  expectSame(carried(flat(0, 0), flat(2, -3), turned, nowhere), { ...turned, position: [7, 0, 2] });
});

it("stays on the surface where that does not go on as it did under the dragged one", () => {
  // Dragged up, straight, where the mug grows wider: what is carried keeps its height over the surface.
  const wider: NearSurface = ([x, y, z]) => {
    const far = Math.hypot(x, z) / (1 + Math.max(0, y));
    return { position: [x / far, y, z / far], normal: [x / Math.hypot(x, z), 0, z / Math.hypot(x, z)] };
  };
  const lifted = onMug(40, 0, 1.05);
  expectSame(carried(onMug(0, 0), onMug(0, 0.5), lifted, wider), onMug(40, 0.5, 1.55));
});

it("leans as the surface does where it comes to lie", () => {
  const along = Math.SQRT1_2;
  // A table that goes down beyond its edge, at half a right angle.
  const table: NearSurface = ([x, y]) =>
    x < 6 ? { position: [x, y, 0], normal: [0, 0, 1] } : { position: [x, y, 6 - x], normal: [along, 0, along] };
  const flat = (x: number): PlanarProjector => ({ ...onMug(0, 0), position: [x, 0, 0.2] });
  const down: PlanarProjector = { ...flat(7), position: [7 + 0.2 * along, 0, 0.2 * along - 1], rotation: ABOUT_Y(45) };
  expectSame(carried(flat(3), flat(5), flat(5), table), down);
  // Behind an edge the nearest surface looks away: no place to lie on.
  const wall: NearSurface = ([x, y]) => ({ position: [x, y, 0], normal: x < 6 ? [0, 0, 1] : [0, 0, -1] });
  expectSame(carried(flat(3), flat(5), flat(5), wall), flat(7));
});

it("leaves a label on its axis", () => {
  const label: CylindricalProjector = {
    kind: "cylindrical",
    ...{ position: [0, 1, 0], rotation: ABOUT_Y(20), radius: 1, height: 0.3, arc: 90, depth: 0.1 },
  };
  const moved = carried(onMug(0, 0), onMug(50, 0.25), label, mug);
  expectSame(moved, { ...label, position: [0, 1.25, 0], rotation: ABOUT_Y(70) });
  // Also where what is dragged leans, as over the mug's foot.
  const leaning = { ...onMug(0, -0.2), rotation: [Math.SQRT1_2 / 2, 0, 0, Math.sqrt(7 / 8)] as const };
  const kept = carried(onMug(0, 0), leaning, label, mug) as CylindricalProjector;
  expect([kept.position[0], kept.position[2]]).toEqual([0, 0]);
  expect([kept.rotation[0], kept.rotation[2]]).toEqual([0, 0]);
});

it("carries stamps by stamps alone", () => {
  const stamp = (u: number, v: number): UvProjector => ({ kind: "uv", center: [u, v], size: [0.1, 0.1], angle: 5 });
  expectSame(carried(stamp(0.5, 0.5), stamp(0.6, 0.3), stamp(0.1, 0.9), mug), stamp(0.2, 0.7));
  expect(carried(onMug(0, 0), onMug(9, 0), stamp(0.1, 0.9), mug)).toEqual(stamp(0.1, 0.9));
  expect(carried(stamp(0.5, 0.5), stamp(0.6, 0.3), onMug(0, 0), mug)).toEqual(onMug(0, 0));
});

import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  UvProjector,
} from "../../web/engine/engine-api.ts";
import { arrangementOf } from "../../web/viewer/arrangement.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import type { Arrangement } from "../../web/viewer/viewer-api.ts";
import { radians } from "./pose-helpers.ts";
import { cube, cylinder, queryOf, sheet, sphere } from "./surface-helpers.ts";

type Place = readonly [number, number, number];
const VIEW = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };

const near = (query: SurfaceQuery, place: readonly number[]): SurfaceSample =>
  query.closest(new Vector3(...place)) as SurfaceSample;

/** Boxes on the surface near those places, each of another size. */
function laid(query: SurfaceQuery, ...places: Place[]): PlanarProjector[] {
  return places.map((place, index) =>
    projectorOf(placeOnSurface(query, near(query, place), 0.2 + 0.1 * index, 1.5, VIEW, null)),
  );
}

function together(query: SurfaceQuery, projectors: readonly Projector[]): Arrangement {
  const found = arrangementOf(query, projectors);
  if (found === null) throw new Error("They have no common middle.");
  return found;
}

function turned(box: PlanarProjector, degrees: number): PlanarProjector {
  const turn = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), radians(degrees));
  const { x, y, z, w } = new Quaternion(...box.rotation).multiply(turn);
  return { ...box, rotation: [x, y, z, w] };
}

const grown = (box: PlanarProjector, across: number, up = across): PlanarProjector => ({
  ...box,
  size: [box.size[0] * across, box.size[1] * up, box.size[2]],
});

const boxes = (projectors: readonly Projector[]): PlanarProjector[] => projectors as PlanarProjector[];

function expectSame(now: readonly Projector[], wanted: readonly PlanarProjector[], tolerance = 1e-9): void {
  for (const [index, projector] of boxes(now).entries()) {
    const { position, rotation, size } = wanted[index] as PlanarProjector;
    expect(new Vector3(...projector.position).distanceTo(new Vector3(...position))).toBeLessThan(tolerance);
    expect(new Quaternion(...projector.rotation).angleTo(new Quaternion(...rotation))).toBeLessThan(tolerance + 1e-7);
    expect(new Vector3(...projector.size).distanceTo(new Vector3(...size))).toBeLessThan(tolerance);
  }
}

/** How far boxes are off the surface, and (radians) how far they lean on it. */
function expectOnSurface(query: SurfaceQuery, projectors: readonly Projector[], off: number, lean: number): void {
  for (const { position, rotation } of boxes(projectors)) {
    const sample = near(query, position);
    expect(sample.distance).toBeLessThan(off);
    expect(new Vector3(0, 0, 1).applyQuaternion(new Quaternion(...rotation)).angleTo(sample.normal)).toBeLessThan(lean);
  }
}

describe("on a plane", () => {
  const query = queryOf(sheet());
  const start = laid(query, [-0.5, 0.2, 0], [0.4, -0.3, 0], [0.3, 0.5, 0]);

  it("turns places and pictures about the middle of the box round all of them", () => {
    const pair = laid(query, [-0.5, 0, 0], [0.4, 0, 0]).map((each) => ({ ...each, size: [0.2, 0.2, 0.1] as const }));
    const { box, at } = together(query, pair);
    expect(box.position).toEqual([expect.closeTo(-0.05), expect.closeTo(0), expect.closeTo(0)]);
    expect(box.size.slice(0, 2)).toEqual([expect.closeTo(1.1), expect.closeTo(0.2)]);
    const upended = turned({ ...(pair[0] as PlanarProjector), position: [0, 0, 0] }, 90);
    expectSame(at(turned(box, 90)), [
      { ...upended, position: [-0.05, -0.45, 0] },
      { ...upended, position: [-0.05, 0.45, 0] },
    ]);
  });

  it("comes back after four right angles, and after it has grown and shrunk, though each step begins anew", () => {
    let now: readonly Projector[] = start;
    for (let step = 0; step < 4; step += 1) {
      const { box, at } = together(query, now);
      now = at(turned(box, 90));
    }
    expectSame(now, start);
    for (const factor of [2, 0.5]) {
      const { box, at } = together(query, now);
      now = at(grown(box, factor));
    }
    expectSame(now, start);
  });

  it("keeps the corner where it is that a drag of the opposite one leaves, and stretches along one side alone", () => {
    const { box, at } = together(query, start);
    const [width] = box.size;
    const wider = grown(box, 1.5, 1);
    const stretched = boxes(at({ ...wider, position: [box.position[0] + width / 4, box.position[1], 0] }));
    const left = box.position[0] - width / 2;
    for (const [index, { position, size }] of start.entries()) {
      const { position: place, size: sides } = stretched[index] as PlanarProjector;
      expect(place).toEqual([
        expect.closeTo(left + 1.5 * (position[0] - left), 9),
        expect.closeTo(position[1], 9),
        expect.closeTo(0, 9),
      ]);
      expect(sides).toEqual([expect.closeTo(1.5 * size[0], 9), expect.closeTo(size[1], 9), expect.closeTo(size[2], 9)]);
    }
  });

  it("takes back a stretch of what is turned in it", () => {
    const leaning = start.map((each, index) => turned(each, 35 * index));
    const { box, at } = together(query, leaning);
    const back = together(query, at(grown(box, 1, 1.4)));
    const sizes = boxes(back.at(grown(back.box, 1, 1 / 1.4))).map(({ size }) => size);
    for (const [index, [width, height]] of sizes.entries()) {
      expect(width).toBeCloseTo(leaning[index]?.size[0] as number, 9);
      expect(height).toBeCloseTo(leaning[index]?.size[1] as number, 9);
    }
  });

  it("goes straight on beyond the border, and comes back", () => {
    const { box, at } = together(query, start);
    const far = at(grown(box, 3));
    expect(Math.max(...boxes(far).map(({ position: [x] }) => x))).toBeGreaterThan(1.2);
    for (const { position, rotation } of boxes(far)) {
      expect(position[2]).toBeCloseTo(0);
      expect(new Quaternion(...rotation).angleTo(new Quaternion())).toBeCloseTo(0);
    }
    const again = together(query, far);
    expectSame(again.at(grown(again.box, 1 / 3)), start);
  });
});

describe.each([
  ["a mug", cylinder(), 0.002],
  ["a ball", sphere(), 0.03],
] as const)("on %s", (_, shape, drift) => {
  const query = queryOf(shape);
  const start = laid(query, [-0.5, 0.2, 0.8], [0.6, -0.3, 0.8], [0.2, 0.4, 1]);

  it("leaves everything where it is while the box is", () => {
    const { box, at } = together(query, start);
    expectSame(at(box), start);
  });

  it("keeps on the surface what is turned, sized and moved", () => {
    const { box, at } = together(query, start);
    const aside = new Vector3(0.3, 0.1, 0).applyQuaternion(new Quaternion(...box.rotation));
    const [x, y, z] = aside.add(new Vector3(...box.position)).toArray();
    for (const now of [turned(box, 40), turned(box, 180), grown(box, 1.3), { ...box, position: [x, y, z] as const }]) {
      expectOnSurface(query, at(now), 1e-3, radians(1));
    }
  });

  it("adds nothing up in a drag that goes back and forth", () => {
    const { box, at } = together(query, start);
    for (let step = 0; step < 12; step += 1) at(turned(grown(box, 1 + step / 8), 31 * step));
    expectSame(at(box), start);
  });

  it("is hardly elsewhere after 36 steps of ten degrees, each from where the one before has left it", () => {
    let now: readonly Projector[] = start;
    for (let step = 0; step < 36; step += 1) {
      const { box, at } = together(query, now);
      now = at(turned(box, 10));
    }
    expectSame(now, start, drift);
  });
});

it("keeps on a mug what the unrolled label has: a way along it is as long as the way up", () => {
  const query = queryOf(cylinder());
  const angle = radians(50);
  const pair = laid(query, [Math.sin(-angle), 0, Math.cos(angle)], [Math.sin(angle), 0, Math.cos(angle)]);
  const same = pair.map((each) => ({ ...each, size: [0.2, 0.2, 0.2] as const }));
  const { box, at } = together(query, same);
  const [low, high] = boxes(at(turned(box, 90)));
  expect(low?.position[1]).toBeCloseTo(-angle, 2);
  expect(high?.position[1]).toBeCloseTo(angle, 2);
  expect(high?.position[2]).toBeCloseTo(1, 2);
  const [left, right] = boxes(at(grown(box, 1.5)));
  expect(Math.atan2(left?.position[0] as number, left?.position[2] as number)).toBeCloseTo(-1.5 * angle, 1);
  expect(Math.atan2(right?.position[0] as number, right?.position[2] as number)).toBeCloseTo(1.5 * angle, 1);
});

it("puts many, whose ways go in fewer steps, near where the unrolled label has them, and leaves them while the box is left", () => {
  const query = queryOf(cylinder());
  const places = Array.from({ length: 200 }, (_, index): Place => {
    const angle = ((index % 20) / 20 - 0.5) * 1.2;
    return [Math.sin(angle), (Math.floor(index / 20) / 10 - 0.5) * 0.8, Math.cos(angle)];
  });
  const many = laid(query, ...places).map((each) => ({ ...each, size: [0.02, 0.02, 0.05] as const }));
  const { box, at } = together(query, many);
  expectSame(at(box), many);
  const exact = places.map(([x, y, z]): Place => {
    const middle = Math.atan2(box.position[0], box.position[2]);
    const angle = middle + (Math.atan2(x, z) - middle) * 1.5;
    return [Math.sin(angle), box.position[1] + (y - box.position[1]) * 1.5, Math.cos(angle)];
  });
  const off = boxes(at(grown(box, 1.5))).map(({ position }, index) =>
    new Vector3(...position).distanceTo(near(query, exact[index] as Place).position),
  );
  expect(Math.max(...off)).toBeLessThan(0.03);
});

it("goes round an edge", () => {
  const query = queryOf(cube());
  const { box, at } = together(query, laid(query, [-0.5, 0, 1], [0.5, 0, 1]));
  const [, right] = boxes(at(grown(box, 3)));
  const past = box.position[0] + 3 * (0.5 - box.position[0]) - 1;
  expect(right?.position).toEqual([expect.closeTo(1), expect.closeTo(0), expect.closeTo(1 - past)]);
  expectOnSurface(query, [right as PlanarProjector], 1e-6, radians(1));
});

it("has no middle for what looks apart, for one alone, and for stamps", () => {
  const query = queryOf(cylinder());
  const stamp: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [0.1, 0.1], angle: 0 };
  expect(arrangementOf(query, laid(query, [0, 0, 1], [0, 0, -1]))).toBeNull();
  expect(arrangementOf(query, laid(query, [0, 0, 1]))).toBeNull();
  expect(arrangementOf(query, [stamp, stamp, ...laid(query, [0, 0, 1])])).toBeNull();
});

it("takes a label round its axis, an eye along as one body, and leaves a stamp", () => {
  const query = queryOf(cylinder());
  const label: CylindricalProjector = {
    ...{ kind: "cylindrical", position: [0, 0.5, 0], rotation: [0, 0, 0, 1] },
    ...{ radius: 1, height: 0.2, arc: 40, depth: 0.1 },
  };
  const eye: PerspectiveProjector = {
    ...{ kind: "perspective", position: [0, 0, 4], rotation: [0, 0, 0, 1], fov: 10, aspect: 1 },
    ...{ near: 1, far: 4 },
  };
  const stamp: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [0.1, 0.1], angle: 0 };
  const [decal] = laid(query, [0, -0.5, 1]) as [PlanarProjector];
  const { box, at } = together(query, [label, eye, stamp, decal]);
  const middle = box.position[1];
  const [round, other, same] = at(turned(box, -90)) as [CylindricalProjector, PerspectiveProjector, UvProjector];
  expect(same).toBe(stamp);
  expect(round.position[0]).toBeCloseTo(0);
  expect(round.position[1]).toBeCloseTo(middle, 2);
  const front = new Vector3(0, 0, 1).applyQuaternion(new Quaternion(...round.rotation));
  expect(Math.atan2(front.x, front.z)).toBeCloseTo(0.5 - middle, 2);
  expect(other.position).toEqual([expect.closeTo(-middle, 2), expect.closeTo(middle, 2), expect.closeTo(4, 2)]);
  const [larger, further] = at(grown(box, 2)) as [CylindricalProjector, PerspectiveProjector];
  expect(larger).toMatchObject({ height: 0.4, arc: 80, radius: 1 });
  expect(further).toMatchObject({ near: 2, far: 8, fov: 10 });
  expect(further.position[2]).toBeCloseTo(1 + 2 * 3, 2);
});

it("has its middle in the air over a gap between two parts", () => {
  const query = queryOf(sheet().translate(-1.5, 0, 0), sheet().translate(1.5, 0, 0));
  const start = laid(query, [-1, 0.2, 0], [1, -0.2, 0]).map((each) => ({ ...each, size: [0.2, 0.2, 0.1] as const }));
  const { box, at } = together(query, start);
  expect(box.position).toEqual([expect.closeTo(0), expect.closeTo(0), expect.closeTo(0)]);
  const [first, second] = boxes(at(turned(box, 180)));
  expect(first?.position).toEqual([expect.closeTo(1), expect.closeTo(-0.2), expect.closeTo(0)]);
  expect(second?.position).toEqual([expect.closeTo(-1), expect.closeTo(0.2), expect.closeTo(0)]);
});

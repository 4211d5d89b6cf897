import { BoxGeometry, PlaneGeometry, SphereGeometry, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { type LandingView, landingPlace } from "../../web/viewer/landing-place.ts";
import type { SurfaceQuery, SurfaceSample } from "../../web/viewer/surface-query.ts";
import { cube, placedFromFront, queryOf } from "./surface-helpers.ts";

/** Looked at from the front, by rays side by side; the view is `span` metres wide and high, and its middle is at the origin. */
function seenFromFront(query: SurfaceQuery, span = 4): LandingView {
  return {
    query,
    sampleAt: (right, below) => query.raycast(new Vector3(right * span, -below * span, 10), new Vector3(0, 0, -1)),
    eyeOf: ({ position: [x, y] }) => new Vector3(x, y, 10),
    spanAt: () => [span, span],
    projectorAt: placedFromFront(query),
    isTaken: () => false,
  };
}

describe("something new", () => {
  it("lies in the middle of the view, as wide as is wished, where it lies well there", () => {
    const landing = landingPlace(seenFromFront(queryOf(cube())), 1, 1);
    expect(landing).toMatchObject({ hit: { position: [0, 0, 1] }, width: 1 });
  });

  it("is narrower where what it lies on is, and still lies in the middle", () => {
    const landing = landingPlace(seenFromFront(queryOf(new BoxGeometry(0.7, 3, 0.5))), 1, 1);
    expect(landing?.hit.position[0]).toBeCloseTo(0, 9);
    expect(landing?.width).toBeLessThan(0.8);
    expect(landing?.width).toBeGreaterThan(0.5);
  });

  it("lies on the larger face beside a gap that the middle of the view is at", () => {
    const chest = new BoxGeometry(1.4, 1.2, 0.5).translate(0, 0.7, 0);
    const legs = [-0.4, 0.4].map((x) => new BoxGeometry(0.3, 1.2, 0.3).translate(x, -0.6, 0));
    const landing = landingPlace(seenFromFront(queryOf(chest, ...legs)), 0.9, 1);
    const [x = 0, y = 0] = landing?.hit.position ?? [];
    expect(x).toBeCloseTo(0, 9);
    expect(y).toBeGreaterThan(0.45);
    expect(landing?.width).toBeGreaterThan(0.6);
  });

  it("lies on one part rather than on two that stand side by side", () => {
    const [chest, arm] = [new BoxGeometry(1, 2, 0.5), new BoxGeometry(0.5, 2, 0.5).translate(0.76, 0, 0)];
    const view = seenFromFront(queryOf(chest, arm));
    const offCentre = { ...view, sampleAt: (right: number, below: number) => view.sampleAt(right + 0.1, below) };
    const landing = landingPlace(offCentre, 0.8, 1);
    const [x = 0] = landing?.hit.position ?? [];
    expect(x + (landing?.width ?? 0) / 2).toBeLessThan(0.55);
  });

  it("does not lie where something that stands before the surface hides it", () => {
    const wall = new PlaneGeometry(4, 4);
    const post = new BoxGeometry(0.2, 4, 0.2).translate(0.1, 0, 2);
    const landing = landingPlace(seenFromFront(queryOf(wall, post)), 0.6, 1);
    const [x = 0, , z] = landing?.hit.position ?? [];
    expect(z).toBeCloseTo(0, 9);
    expect(Math.abs(x - 0.1)).toBeGreaterThan(0.3);
  });

  it.each([
    [78, "goes from where it would be seen from its side to where it is seen"],
    [53, "stays near the middle where it is seen well enough"],
  ])("on a surface that is turned away by %i degrees, %s", (degrees, result) => {
    const front = new PlaneGeometry(1.4, 4).translate(-1.3, 0, 0);
    const side = new PlaneGeometry(8, 4)
      .translate(4, 0, 0)
      .rotateY((degrees * Math.PI) / 180)
      .translate(-0.6, 0, 0);
    const landing = landingPlace(seenFromFront(queryOf(front, side)), 0.4, 1);
    const [x = 0] = landing?.hit.position ?? [];
    if (result.startsWith("stays")) expect(x).toBeCloseTo(0, 9);
    else expect(x).toBeLessThan(-0.6);
  });

  it("takes no more than half of the view, also where the camera has come near", () => {
    const near = seenFromFront(queryOf(cube()), 0.4);
    expect(landingPlace(near, 1, 1)?.width).toBeCloseTo(0.2, 9);
    expect(landingPlace(near, 1, 4)?.width).toBeCloseTo(0.2, 9);
    expect(landingPlace(near, 1, 0.25)?.width).toBeCloseTo(0.05, 9);
  });

  it("lies beside a picture that lies in the middle already, not much smaller, and beside two", () => {
    const taken: { x: number; y: number; half: number }[] = [];
    const view = {
      ...seenFromFront(queryOf(new PlaneGeometry(4, 4))),
      isTaken: ({ position: { x, y } }: SurfaceSample) =>
        taken.some((one) => Math.max(Math.abs(x - one.x), Math.abs(y - one.y)) < one.half),
    };
    for (const most of [0, 0.1, 0.1]) {
      const landing = landingPlace(view, 0.9, 1);
      const [x = 0, y = 0] = landing?.hit.position ?? [];
      const half = (landing?.width ?? 0) / 2;
      expect(half).toBeGreaterThan(0.25);
      const over = taken.map((one) => Math.max(Math.abs(x - one.x), Math.abs(y - one.y)) - one.half - half);
      for (const gap of over) expect(gap).toBeGreaterThan(-most);
      taken.push({ x, y, half });
    }
  });

  it("is found beside a picture after a third of the places and widths that there are, as each takes a slow phone long", () => {
    const taken: Vector3[] = [];
    const view = seenFromFront(queryOf(new SphereGeometry(1, 48, 32)), 3);
    let tried = 0;
    const counted: LandingView = {
      ...view,
      projectorAt: (...place) => {
        tried += 1;
        return view.projectorAt(...place);
      },
      isTaken: ({ position: { x, y } }) =>
        taken.some((one) => Math.max(Math.abs(x - one.x), Math.abs(y - one.y)) < 0.25),
    };
    for (const [right, above] of [
      [0, 0],
      [0, 0.54],
      [0.54, 0],
      [0, -0.54],
      [-0.54, 0],
    ] as const) {
      tried = 0;
      const landing = landingPlace(counted, 0.5, 1);
      expect(landing?.width).toBe(0.5);
      const [x = 0, y = 0] = landing?.hit.position ?? [];
      expect(x).toBeCloseTo(right, 2);
      expect(y).toBeCloseTo(above, 2);
      expect(tried).toBeLessThanOrEqual((49 * 3) / 3);
      taken.push(new Vector3(x, y, 0));
    }
  });

  it("is narrow on a narrow part, also where all of that is under other pictures", () => {
    const view = { ...seenFromFront(queryOf(new BoxGeometry(0.7, 3, 0.5))), isTaken: () => true };
    expect(landingPlace(view, 1, 1)?.width).toBeLessThan(0.8);
  });

  it("lies in the middle where all of the surface is under other pictures", () => {
    const view = { ...seenFromFront(queryOf(cube())), isTaken: () => true };
    expect(landingPlace(view, 1, 1)).toMatchObject({ hit: { position: [0, 0, 1] }, width: 1 });
  });

  it("has no place where nothing of the model is near the middle", () => {
    const aside = queryOf(new BoxGeometry(0.2, 0.2, 0.2).translate(1.9, 0, 0));
    expect(landingPlace(seenFromFront(aside), 1, 1)).toBeNull();
  });
});

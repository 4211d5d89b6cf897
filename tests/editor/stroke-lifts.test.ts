import { expect, it, vi } from "vitest";
import type { Dab } from "../../web/editor/document/index.ts";
import { strokeLifts } from "../../web/editor/state/stroke-lifts.ts";

const dabAt = (x: number): Dab => ({
  ...{ kind: "planar", rotation: [0, 0, 0, 1], size: [0.1, 0.1, 0.1], flow: 1 },
  position: [x, 0, 0],
});
const chain = (count: number, step = 0.025): Dab[] => Array.from({ length: count }, (_, index) => dabAt(index * step));
const placeOf = (dab: Dab): number => (dab.kind === "planar" ? dab.position[0] : 0);

it("a long stroke over an even surface asks for one dab in eight, and takes what lies between as it is", () => {
  const dabs = chain(200);
  const slope = vi.fn((dab: Dab) => placeOf(dab) * 0.02);
  expect(strokeLifts(dabs, slope)).toEqual(dabs.map((dab) => expect.closeTo(placeOf(dab) * 0.02, 9)));
  expect(slope).toHaveBeenCalledTimes(26);
});

it("a stroke of 40 dabs, as most on a mask are, is asked for six of them, so that two hundred go along in a drag", () => {
  const ask = vi.fn(() => 1);
  expect(strokeLifts(chain(40), ask)).toEqual(chain(40).map(() => 1));
  expect(ask).toHaveBeenCalledTimes(6);
});

it("where the surface steps, and where the stroke has begun anew, each dab is asked for", () => {
  const step = (dab: Dab): number => (placeOf(dab) > 2.6 ? 0.05 : 0);
  const dabs = chain(200);
  expect(strokeLifts(dabs, step)).toEqual(dabs.map(step));
  const apart = [...chain(100), ...chain(100).map((dab) => dabAt(placeOf(dab) + 9))];
  const hill = (dab: Dab): number => Math.sin(placeOf(dab));
  for (const [index, lift] of strokeLifts(apart, hill).entries()) {
    expect(lift).toBeCloseTo(hill(apart[index] as Dab), 2);
  }
});

it("a short stroke is asked for dab by dab", () => {
  const ask = vi.fn(() => 1);
  expect(strokeLifts(chain(16), ask)).toEqual(chain(16).map(() => 1));
  expect(ask).toHaveBeenCalledTimes(16);
});

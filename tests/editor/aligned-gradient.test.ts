import { expect, test } from "vitest";
import { roundGradient } from "../../web/editor/state/aligned-gradient.ts";
import type { OpenModel } from "../../web/editor/state/design-state.ts";

test("a round gradient reaches as far as the model's longest side, so that its circle is in the view whole", () => {
  const info = { boundsMin: [-1, 0, 2], boundsMax: [1, 6, 5] };
  expect(roundGradient({ info } as unknown as OpenModel)).toMatchObject({ center: [0, 3, 3.5], radius: 3 });
});

test("a round gradient of no model has a radius all the same", () => {
  expect(roundGradient(null).radius).toBeGreaterThan(0);
});

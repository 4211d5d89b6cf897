/** Where the shop's products can be printed: a zones file each, true to the model's own measures. */
import type { Vec2 } from "../geometry/vector.ts";
import { mugPrintArea } from "../models/mug.ts";
import { deckPrintArea } from "../models/skateboard.ts";

/** Round enough for a person to read, and far finer than a texel. */
const tidy = (value: number): number => Math.round(value * 1e6) / 1e6;
const uvShape = (polygon: readonly Vec2[]): object => ({
  kind: "uv",
  polygon: polygon.map((corner) => corner.map(tidy)),
});

/** By the product's id. */
export function shopZones(): Readonly<Record<string, object>> {
  return {
    mug: {
      texelcastZones: 1,
      dpi: { least: 100, good: 150 },
      zones: [{ id: "wall", name: "Wall", shape: uvShape(mugPrintArea()), safe: 3, bleed: 0, policy: "clip" }],
    },
    figure: {
      texelcastZones: 1,
      // The model is as tall as a person, the figure is not.
      printScale: 0.1,
      dpi: { least: 100, good: 150 },
      zones: [
        { id: "chest", name: "Chest", shape: bodyBox(1), safe: 1, bleed: 0, policy: "clip" },
        { id: "back", name: "Back", shape: bodyBox(-1), safe: 1, bleed: 0, policy: "clip" },
      ],
    },
    skateboard: {
      texelcastZones: 1,
      dpi: { least: 40, good: 55 },
      zones: [{ id: "deck", name: "Underside", shape: uvShape(deckPrintArea()), safe: 8, bleed: 0, policy: "clip" }],
    },
  };
}

/** The flat of the shirt: inside of its rounded edges, from the belt to the collar. */
const bodyBox = (side: 1 | -1): object => ({
  kind: "box",
  position: [0, 1.12, 0.12 * side],
  size: [0.38, 0.4, 0.12],
});

/** Zones as tests ask for them. */
import { NO_ZONES, type PrintZone, type PrintZones } from "../../web/engine/print-zones.ts";

/** The left half of material 0's texture, which cuts off what lies beyond. */
export const LEFT_HALF: PrintZone = {
  id: "left",
  name: "Left",
  material: 0,
  shape: {
    kind: "uv",
    polygon: [
      [0, 0],
      [0.5, 0],
      [0.5, 1],
      [0, 1],
    ],
  },
  safe: 0,
  bleed: 0,
  policy: "clip",
};

/** The left half alone; `changes` are the zone's, `more` the file's. */
export const zones = (changes: Partial<PrintZone> = {}, more: Partial<PrintZones> = {}): PrintZones => ({
  ...NO_ZONES,
  ...more,
  zones: [{ ...LEFT_HALF, ...changes }],
});

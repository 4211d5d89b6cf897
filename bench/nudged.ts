import type { PlanarProjector } from "../web/engine/engine-api.ts";

/** Metres: a drag moves the decal by this much, to and fro, so that no engine can reuse what it has. */
const NUDGE = 1e-3;

export function nudged(projector: PlanarProjector, round: number): PlanarProjector {
  const [x, y, z] = projector.position;
  return { ...projector, position: [x + (round % 2) * NUDGE, y, z] };
}

/** Which handle a press takes. Told by distance and not by what lies on top: on a small outline their targets overlap. */
import type { ScreenPoint } from "./screen-space.ts";

/** How far from its middle a handle is caught, CSS pixels: 24 across for a mouse, 44 for a finger (WCAG 2.5.8 and 2.5.5). */
export const MOUSE_REACH = 12;
export const FINGER_REACH = 22;

/**
 * The nearest handle within reach of a point; null where there is none, or where the middle of the outline is nearer: by that
 * the decal itself is moved, and it is what a finger aims at.
 */
export function handleUnder<Name>(
  at: ScreenPoint,
  handles: Iterable<readonly [Name, ScreenPoint]>,
  middle: ScreenPoint | null,
  reach: number,
): Name | null {
  let nearest = middle === null ? reach : Math.min(reach, distance(at, middle));
  let name: Name | null = null;
  for (const [candidate, place] of handles) {
    const away = distance(at, place);
    if (away < nearest) {
      nearest = away;
      name = candidate;
    }
  }
  return name;
}

export function distance(from: ScreenPoint, to: ScreenPoint): number {
  return Math.hypot(to.x - from.x, to.y - from.y);
}

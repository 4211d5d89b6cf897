/** Shift in a slide, as in other tools: straight across or straight up and down, as the view shows it. */
import type { ScreenPoint } from "./screen-space.ts";

/** The point of `from`'s row or column that is nearest to `to`: of that which it has gone further along. */
export function heldToAxis(from: ScreenPoint, to: ScreenPoint): ScreenPoint {
  return Math.abs(to.x - from.x) < Math.abs(to.y - from.y) ? { x: from.x, y: to.y } : { x: to.x, y: from.y };
}

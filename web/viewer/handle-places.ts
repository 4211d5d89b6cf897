/** Where handles stand about an outline in pixels: on it, or further out where it is too small to leave its middle free. */
import type { HandleName, HandlePlace, ScaleHandleName } from "./gizmo-overlay.ts";
import { distance } from "./handle-under.ts";
import type { ScreenPoint } from "./screen-space.ts";

/** Edges shorter than this on the screen have no room for a handle between their corners, CSS pixels. */
const LEAST_EDGE = 60;
/** Corners of the smallest outline stand this far from its middle, CSS pixels. */
const LEAST_CORNER_REACH = 40;

/** An outline's middle, and how far from a handle's middle it is caught, in CSS pixels. */
export interface HandleRoom {
  readonly middle: ScreenPoint;
  readonly reach: number;
}

/**
 * The handles that scale: corners, and edges that have room for one. Null from `pixelOf` is behind the eye.
 * All keep two reaches from the middle, so that one reach about it is the decal's own.
 */
export function scaleHandlePlaces(
  pixelOf: (name: ScaleHandleName) => ScreenPoint | null,
  { middle, reach }: HandleRoom,
): readonly (readonly [ScaleHandleName, Omit<HandlePlace, "hidden">])[] {
  const [sw, se, ne, nw] = [pixelOf("sw"), pixelOf("se"), pixelOf("ne"), pixelOf("nw")];
  if (sw === null || se === null || ne === null || nw === null) {
    return [];
  }
  const places: [ScaleHandleName, Omit<HandlePlace, "hidden">][] = [];
  for (const [name, from, to] of [
    ["n", nw, ne],
    ["s", sw, se],
    ["e", se, ne],
    ["w", sw, nw],
  ] as const) {
    const at = pixelOf(name);
    // Round a mug an edge's two ends may meet again: half of it counts, too.
    const length = at === null ? 0 : Math.max(distance(from, to), 2 * distance(from, at));
    if (at !== null && length >= Math.max(LEAST_EDGE, 4 * reach)) {
      const angle = degreesOf(from, to);
      places.push([name, { ...pushedOut(at, middle, 2 * reach), angle, cursor: resizeCursor(angle + 90) }]);
    }
  }
  const least = Math.max(LEAST_CORNER_REACH, 2 * reach);
  for (const [name, at, from, to] of [
    ["sw", sw, nw, sw],
    ["se", se, se, ne],
    ["ne", ne, se, ne],
    ["nw", nw, nw, sw],
  ] as const) {
    const cursor = resizeCursor(degreesOf(middle, at));
    places.push([name, { ...pushedOut(at, middle, least), angle: degreesOf(from, to), cursor }]);
  }
  return places;
}

/** A point, or the one behind it as seen from the middle that is `least` pixels from there. */
export function pushedOut(at: ScreenPoint, middle: ScreenPoint, least: number): ScreenPoint {
  const factor = Math.max(1, least / Math.max(distance(at, middle), 1e-3));
  return { x: middle.x + (at.x - middle.x) * factor, y: middle.y + (at.y - middle.y) * factor };
}

/** Whether a place leaves the middle and the handles that are there already room to be caught. */
export function isFree(
  at: ScreenPoint,
  { middle, reach }: HandleRoom,
  handles: ReadonlyMap<HandleName, HandlePlace>,
): boolean {
  return (
    distance(at, middle) >= 2 * reach && [...handles.values()].every((place) => distance(at, place) >= 1.5 * reach)
  );
}

/** Direction on the screen, degrees clockwise from the right. */
export function degreesOf(from: ScreenPoint, to: ScreenPoint): number {
  return (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI;
}

/** The resize cursor nearest to a direction on the screen. */
export function resizeCursor(degrees: number): string {
  const names = ["ew-resize", "nwse-resize", "ns-resize", "nesw-resize"] as const;
  const eighth = Math.round(degrees / 45);
  return names[((eighth % 4) + 4) % 4] as string;
}

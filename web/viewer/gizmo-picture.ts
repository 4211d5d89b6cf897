/** What the gizmo of a decal looks like from a camera: lines and handles in pixels, hidden parts told apart. */
import type { Vector3 } from "three";
import { type OutlinePoint, POINTS_PER_EDGE } from "./decal-outline.ts";
import { axisOf, boxCorners, type DecalPose } from "./decal-pose.ts";
import type { GizmoPicture, HandleName, HandlePlace, HandleStand, ScaleHandleName } from "./gizmo-overlay.ts";
import { degreesOf, isFree, pushedOut, resizeCursor, scaleHandlePlaces } from "./handle-places.ts";
import { distance } from "./handle-under.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** What a picture is drawn from. */
export interface GizmoView {
  readonly screen: ScreenSpace;
  readonly query: SurfaceQuery;
  /** How far from a handle's middle it is caught, CSS pixels. */
  readonly reach: number;
  /** In a drag: where the handles stood when it began, so that none jumps from under the pointer. */
  readonly stand: HandleStand | null;
}

/** Where the handle that turns may stand: sides of the outline, and shares of its stem's usual length. The first that is free. */
const KNOB_PLACES = (["n", "s", "e", "w"] as const).flatMap((side) => [1, 1.5, 2].map((share) => ({ side, share })));

/** Lengths on the screen, CSS pixels. */
const ROTATE_STEM = 30;
const ARROW_LENGTH = 46;
const ARROW_BEYOND_HANDLE = 24;
const ARROW_HEAD = 7;
/** The handle that turns keeps this far from the view's border. */
const KNOB_MARGIN = 14;
/** What is added to an arrow's length, the first with which its handle can be told from the others. */
const ARROW_STRETCHES = [0, 20, 40, 60, 80, 100];
/** An arrow shorter than this on the screen points at the viewer: nothing to pull on. */
export const LEAST_ARROW = 30;
/** Pieces of a box edge that are told apart as hidden or seen. */
const EDGE_PIECES = 4;

/** Index of each corner and edge middle in the outline. */
export const OUTLINE_INDEX: Readonly<Record<ScaleHandleName, number>> = {
  sw: 0,
  s: POINTS_PER_EDGE / 2,
  se: POINTS_PER_EDGE,
  e: POINTS_PER_EDGE * 1.5,
  ne: POINTS_PER_EDGE * 2,
  n: POINTS_PER_EDGE * 2.5,
  nw: POINTS_PER_EDGE * 3,
  w: POINTS_PER_EDGE * 3.5,
};

/** Pairs of `boxCorners` indices. */
const BOX_EDGES = [
  [0, 1],
  [2, 3],
  [4, 5],
  [6, 7],
  [0, 2],
  [1, 3],
  [4, 6],
  [5, 7],
  [0, 4],
  [1, 5],
  [2, 6],
  [3, 7],
] as const;

/** The outline alone, for a decal under the pointer. */
export function hoverPath(view: GizmoView, outline: readonly OutlinePoint[]): string {
  return outlinePaths(view, outline).seen;
}

/** The outline alone of a decal under way. */
export function drawOutline(
  view: GizmoView,
  outline: readonly OutlinePoint[],
): Pick<GizmoPicture, "outline" | "outlineHidden"> {
  const lines = outlinePaths(view, outline);
  return { outline: lines.seen, outlineHidden: lines.hidden };
}

/** The whole gizmo of a selected decal. `handles: false` for one that is locked. */
export function drawGizmo(
  view: GizmoView,
  pose: DecalPose,
  outline: readonly OutlinePoint[],
  options: { readonly handles: boolean; readonly hover: string },
): GizmoPicture {
  const lines = outlinePaths(view, outline);
  const box = boxPaths(view, pose);
  const facing = axisOf(pose, 2).dot(view.screen.eye.sub(pose.position)) > 0;
  const handles = new Map<HandleName, HandlePlace>();
  const middle = view.screen.project(pose.position);
  const shown = options.handles && facing && outline.length > 0 && middle !== null;
  let knob = NO_KNOB;
  if (shown) {
    addScaleHandles(view, outline, middle, handles);
    knob = addKnob(view, outline, { right: axisOf(pose, 0), up: axisOf(pose, 1) }, middle, handles);
  }
  const arrow = middle === null ? NO_ARROW : arrowAlong(view, pose.position, axisOf(pose, 2), pose.size.z / 2, handles);
  if (shown && arrow.handle !== null) {
    handles.set("depth", arrow.handle);
  }
  return {
    outline: lines.seen,
    outlineHidden: lines.hidden,
    box: box.seen,
    boxHidden: box.hidden,
    guide: knob.stem,
    arrow: arrow.line,
    arrowHead: arrow.head,
    stand: { knob: knob.place, stretch: arrow.stretch },
    hover: options.hover,
    beside: "",
    middle,
    handles,
  };
}

/** Where a handle's drag begins, in the box's own metric frame: on the draped outline, at its height. */
export function handleHeight(name: HandleName, outline: readonly OutlinePoint[]): number {
  return outline[outlineIndexOf(name)]?.height ?? 0;
}

/** The outline's point that a handle belongs to. */
export function outlineIndexOf(name: HandleName): number {
  if (name === "rotate") return OUTLINE_INDEX.n;
  return name === "depth" || name === "near" || name === "far" ? 0 : OUTLINE_INDEX[name];
}

export function outlinePaths(view: GizmoView, outline: readonly OutlinePoint[]): { seen: string; hidden: string } {
  if (outline.length === 0) {
    return { seen: "", hidden: "" };
  }
  const closed = [...outline, outline[0] as OutlinePoint];
  const points = closed.map((point) => view.screen.project(point.position));
  const seen = closed.map((point) => point.onSurface && view.query.isClear(view.screen.eye, point.position));
  return splitPath(points, seen);
}

function boxPaths(view: GizmoView, pose: DecalPose): { seen: string; hidden: string } {
  // Three edges share a corner, which is looked at once: each look casts a ray.
  const corners = boxCorners(pose).map((corner) => seenFrom(view, corner));
  return joined(
    BOX_EDGES.map(([from, to]) => {
      const [start, end] = [corners[from] as SeenPoint, corners[to] as SeenPoint];
      const between = Array.from({ length: EDGE_PIECES - 1 }, (_, piece) =>
        seenFrom(view, start.position.clone().lerp(end.position, (piece + 1) / EDGE_PIECES)),
      );
      return [start, ...between, end];
    }),
  );
}

interface SeenPoint {
  readonly position: Vector3;
  readonly pixel: ScreenPoint | null;
  readonly isClear: boolean;
}

function seenFrom({ screen, query }: GizmoView, position: Vector3): SeenPoint {
  return { position, pixel: screen.project(position), isClear: query.isClear(screen.eye, position) };
}

function joined(polylines: readonly (readonly SeenPoint[])[]): { seen: string; hidden: string } {
  const paths = polylines.map((points) =>
    splitPath(
      points.map((point) => point.pixel),
      points.map((point) => point.isClear),
    ),
  );
  return { seen: paths.map((path) => path.seen).join(""), hidden: paths.map((path) => path.hidden).join("") };
}

export function linePaths(
  view: GizmoView,
  polylines: readonly (readonly Vector3[])[],
): { seen: string; hidden: string } {
  const pieces = polylines.map((polyline) => {
    // A line of two points is cut in pieces that are told apart; a curve has its own.
    const [from, to] = polyline as readonly [Vector3, Vector3];
    return polyline.length > 2
      ? polyline
      : Array.from({ length: EDGE_PIECES + 1 }, (_, piece) => from.clone().lerp(to, piece / EDGE_PIECES));
  });
  return joined(pieces.map((points) => points.map((point) => seenFrom(view, point))));
}

export function addScaleHandles(
  view: GizmoView,
  outline: readonly OutlinePoint[],
  middle: ScreenPoint,
  handles: Map<HandleName, HandlePlace>,
): void {
  const pixelOf = (name: ScaleHandleName) => {
    const point = outline[OUTLINE_INDEX[name]];
    return point === undefined ? null : view.screen.project(point.position);
  };
  for (const [name, place] of scaleHandlePlaces(pixelOf, { middle, reach: view.reach })) {
    handles.set(name, { ...place, hidden: isHidden(view, outline, name) });
  }
}

export interface Knob {
  /** SVG path data. */
  readonly stem: string;
  readonly place: HandleStand["knob"];
}

export const NO_KNOB: Knob = { stem: "", place: null };

/**
 * The handle that turns, on a stem from an edge's middle along one of the picture's own axes (unit). Above the picture, or
 * where it would be out of the view there, at another side; and where all are out, at the view's border.
 */
export function addKnob(
  view: GizmoView,
  outline: readonly OutlinePoint[],
  { right, up }: { readonly right: Vector3; readonly up: Vector3 },
  middle: ScreenPoint,
  handles: Map<HandleName, HandlePlace>,
): Knob {
  const { screen, query, reach } = view;
  const outward = { n: up, s: up.clone().negate(), e: right, w: right.clone().negate() };
  const length = Math.max(ROTATE_STEM, 2 * reach);
  const knobs = (view.stand?.knob ? [view.stand.knob] : KNOB_PLACES).flatMap((place) => {
    const { side, share } = place;
    const foot = outline[OUTLINE_INDEX[side]]?.position;
    const low = foot && screen.project(foot);
    const spot = foot?.clone().addScaledVector(outward[side], length * share * screen.metresPerPixel(foot));
    const high = spot && screen.project(spot);
    // Beyond the corners, which keep two reaches from the middle.
    return low && high ? [{ place, low, spot, at: pushedOut(high, middle, Math.SQRT2 * 2 * reach) }] : [];
  });
  const fits = ({ at }: { at: ScreenPoint }): boolean => {
    const shown = screen.within(at, KNOB_MARGIN);
    return distance(at, shown) < length / 2 && isFree(shown, { middle, reach }, handles);
  };
  const knob = knobs.find(fits) ?? knobs[0];
  if (knob === undefined) {
    return NO_KNOB;
  }
  const at = screen.holds(middle) ? screen.within(knob.at, KNOB_MARGIN) : knob.at;
  const hidden = !query.isClear(screen.eye, knob.spot);
  handles.set("rotate", { ...at, angle: degreesOf(knob.low, at) + 90, hidden, cursor: "grab" });
  return { stem: line(knob.low, at), place: knob.place };
}

export interface Arrow {
  readonly line: string;
  readonly head: string;
  readonly handle: HandlePlace | null;
  readonly stretch: HandleStand["stretch"];
}

const NO_ARROW: Arrow = { line: "", head: "", handle: null, stretch: null };

/**
 * An arrow from a point along a unit direction, as long on the screen as its foreshortening lets it. Its handle is `reach`
 * metres from there, or as far as it can be told from the point and from the handles that are there already.
 */
export function arrowAlong(
  view: GizmoView,
  begin: Vector3,
  direction: Vector3,
  reach: number,
  handles: ReadonlyMap<HandleName, HandlePlace>,
): Arrow {
  const { screen, stand } = view;
  const perPixel = screen.metresPerPixel(begin);
  const from = screen.project(begin);
  const least = Math.max(reach, ARROW_LENGTH * perPixel);
  for (const stretch of stand === null ? ARROW_STRETCHES : [stand.stretch ?? 0]) {
    const grip = begin.clone().addScaledVector(direction, least + stretch * perPixel);
    const at = screen.project(grip);
    const tip = screen.project(grip.clone().addScaledVector(direction, ARROW_BEYOND_HANDLE * perPixel));
    // Its head alone may be out of the view.
    if (from === null || at === null || tip === null || (stand === null && !screen.holds(at))) {
      break;
    }
    const room = { middle: from, reach: view.reach };
    if (stand !== null || (distance(from, at) >= LEAST_ARROW && isFree(at, room, handles))) {
      const angle = degreesOf(from, tip);
      const hidden = !view.query.isClear(screen.eye, grip);
      return {
        line: line(from, tip),
        head: arrowHead(tip, angle),
        handle: { ...at, angle, hidden, cursor: resizeCursor(angle) },
        stretch,
      };
    }
  }
  return NO_ARROW;
}

function isHidden(view: GizmoView, outline: readonly OutlinePoint[], name: keyof typeof OUTLINE_INDEX): boolean {
  const point = outline[OUTLINE_INDEX[name]];
  return point !== undefined && !view.query.isClear(view.screen.eye, point.position);
}

/** Two paths of a polyline: the segments whose ends are both seen, and the others. */
function splitPath(
  points: readonly (ScreenPoint | null)[],
  seen: readonly boolean[],
): { seen: string; hidden: string } {
  const paths = { seen: "", hidden: "" };
  let drawing: "seen" | "hidden" | null = null;
  for (let end = 1; end < points.length; end++) {
    const from = points[end - 1];
    const to = points[end];
    if (!from || !to) {
      drawing = null;
      continue;
    }
    const kind = seen[end - 1] && seen[end] ? "seen" : "hidden";
    paths[kind] += drawing === kind ? `L${pixel(to)}` : line(from, to);
    drawing = kind;
  }
  return paths;
}

export function line(from: ScreenPoint, to: ScreenPoint): string {
  return `M${pixel(from)}L${pixel(to)}`;
}

function pixel(point: ScreenPoint): string {
  return `${point.x.toFixed(1)} ${point.y.toFixed(1)}`;
}

function arrowHead(tip: ScreenPoint, angle: number): string {
  const at = (degrees: number, length: number) => {
    const radians = ((angle + degrees) * Math.PI) / 180;
    return pixel({ x: tip.x + Math.cos(radians) * length, y: tip.y + Math.sin(radians) * length });
  };
  return `M${at(0, ARROW_HEAD)}L${at(130, ARROW_HEAD)}L${at(-130, ARROW_HEAD)}Z`;
}

/** What the gizmo of a decal looks like from a camera: lines and handles in pixels, hidden parts told apart. */
import type { Vector3 } from "three";
import { type OutlinePoint, POINTS_PER_EDGE } from "./decal-outline.ts";
import { axisOf, boxCorners, type DecalPose, fromLocal } from "./decal-pose.ts";
import type { GizmoPicture, HandleName, HandlePlace, ScaleHandleName } from "./gizmo-overlay.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** What a picture is drawn from. */
export interface GizmoView {
  readonly screen: ScreenSpace;
  readonly query: SurfaceQuery;
}

/** Lengths on the screen, CSS pixels. */
const ROTATE_STEM = 30;
const ARROW_LENGTH = 46;
const ARROW_BEYOND_HANDLE = 24;
const ARROW_HEAD = 7;
/** Edges shorter than this on the screen have no room for a handle between their corners. */
const LEAST_EDGE_FOR_HANDLE = 60;
/** Corner handles keep this far from the middle, so that a small decal can still be taken by its body. */
const LEAST_CORNER_REACH = 40;
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
  const arrow = arrowOf(view, pose, outline);
  let guide = "";
  if (options.handles && facing) {
    addScaleHandles(view, outline, handles);
    guide = addRotateHandle(view, pose, outline, handles);
    if (arrow.handle !== null) {
      handles.set("depth", arrow.handle);
    }
  }
  return {
    outline: lines.seen,
    outlineHidden: lines.hidden,
    box: box.seen,
    boxHidden: box.hidden,
    guide,
    arrow: arrow.line,
    arrowHead: arrow.head,
    hover: options.hover,
    twin: "",
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
  handles: Map<HandleName, HandlePlace>,
): void {
  const pixelOf = (name: keyof typeof OUTLINE_INDEX) => {
    const point = outline[OUTLINE_INDEX[name]];
    return point === undefined ? null : view.screen.project(point.position);
  };
  const [sw, se, ne, nw] = [pixelOf("sw"), pixelOf("se"), pixelOf("ne"), pixelOf("nw")];
  if (sw === null || se === null || ne === null || nw === null) {
    return;
  }
  const centre = { x: (sw.x + se.x + ne.x + nw.x) / 4, y: (sw.y + se.y + ne.y + nw.y) / 4 };
  for (const [name, at, from, to] of [
    ["n", pixelOf("n"), nw, ne],
    ["s", pixelOf("s"), sw, se],
    ["e", pixelOf("e"), se, ne],
    ["w", pixelOf("w"), sw, nw],
  ] as const) {
    // Round a mug an edge's two ends may meet again: half of it counts, too.
    const length = at === null ? 0 : Math.max(distance(from, to), 2 * distance(from, at));
    if (at !== null && length >= LEAST_EDGE_FOR_HANDLE) {
      const angle = degreesOf(from, to);
      handles.set(name, { ...at, angle, hidden: isHidden(view, outline, name), cursor: resizeCursor(angle + 90) });
    }
  }
  for (const [name, at] of [
    ["sw", sw],
    ["se", se],
    ["ne", ne],
    ["nw", nw],
  ] as const) {
    const side = name === "sw" || name === "nw" ? [nw, sw] : [se, ne];
    const angle = degreesOf(side[0] as ScreenPoint, side[1] as ScreenPoint);
    const cursor = resizeCursor(degreesOf(centre, at));
    const place = pushedOut(at, centre);
    handles.set(name, { ...place, angle, hidden: isHidden(view, outline, name), cursor });
  }
}

function pushedOut(at: ScreenPoint, centre: ScreenPoint): ScreenPoint {
  const reach = Math.hypot(at.x - centre.x, at.y - centre.y);
  const factor = Math.max(1, LEAST_CORNER_REACH / Math.max(reach, 1));
  return { x: centre.x + (at.x - centre.x) * factor, y: centre.y + (at.y - centre.y) * factor };
}

/** Returns the stem's path. */
function addRotateHandle(
  view: GizmoView,
  pose: DecalPose,
  outline: readonly OutlinePoint[],
  handles: Map<HandleName, HandlePlace>,
): string {
  const top = outline[OUTLINE_INDEX.n];
  if (top === undefined) {
    return "";
  }
  const foot = fromLocal(pose, 0, pose.size.y / 2, top.height);
  return addKnob(view, top.position, foot, axisOf(pose, 1), handles);
}

/**
 * The knob that turns, on a stem from `from`; it stands above `foot` along `upward` (unit). Returns the stem's path.
 */
export function addKnob(
  view: GizmoView,
  from: Vector3,
  foot: Vector3,
  upward: Vector3,
  handles: Map<HandleName, HandlePlace>,
): string {
  const knob = foot.clone().addScaledVector(upward, ROTATE_STEM * view.screen.metresPerPixel(from));
  const low = view.screen.project(from);
  const high = view.screen.project(knob);
  if (low === null || high === null) {
    return "";
  }
  const hidden = !view.query.isClear(view.screen.eye, knob);
  handles.set("rotate", { ...high, angle: degreesOf(low, high) + 90, hidden, cursor: "grab" });
  return line(low, high);
}

/** The arrow along +Z from the surface, as long on the screen as its foreshortening lets it. */
function arrowOf(view: GizmoView, pose: DecalPose, outline: readonly OutlinePoint[]): Arrow {
  return outline.length === 0 ? NO_ARROW : arrowAlong(view, pose.position, axisOf(pose, 2), pose.size.z / 2);
}

export interface Arrow {
  readonly line: string;
  readonly head: string;
  readonly handle: HandlePlace | null;
}

const NO_ARROW: Arrow = { line: "", head: "", handle: null };

/** An arrow from a point along a unit direction, its handle `reach` metres from there or as far as it can be taken. */
export function arrowAlong(view: GizmoView, begin: Vector3, direction: Vector3, reach: number): Arrow {
  const perPixel = view.screen.metresPerPixel(begin);
  const grip = Math.max(reach, ARROW_LENGTH * perPixel);
  const at3 = begin.clone().addScaledVector(direction, grip);
  const from = view.screen.project(begin);
  const at = view.screen.project(at3);
  const tip = view.screen.project(begin.clone().addScaledVector(direction, grip + ARROW_BEYOND_HANDLE * perPixel));
  if (from === null || at === null || tip === null || distance(from, at) < LEAST_ARROW) {
    return NO_ARROW;
  }
  const angle = degreesOf(from, tip);
  const hidden = !view.query.isClear(view.screen.eye, at3);
  return {
    line: line(from, tip),
    head: arrowHead(tip, angle),
    handle: { ...at, angle, hidden, cursor: resizeCursor(angle) },
  };
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

function distance(from: ScreenPoint, to: ScreenPoint): number {
  return Math.hypot(to.x - from.x, to.y - from.y);
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

/** What the gizmo of a projector that is no box looks like: its picture's border, its volume's edges, its handles. */
import { Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector } from "../engine/engine-api.ts";
import type { OutlinePoint } from "./decal-outline.ts";
import type { GizmoPicture, HandleName, HandlePlace } from "./gizmo-overlay.ts";
import {
  addKnob,
  addScaleHandles,
  arrowAlong,
  type GizmoView,
  LEAST_ARROW,
  linePaths,
  NO_KNOB,
  OUTLINE_INDEX,
  outlinePaths,
} from "./gizmo-picture.ts";
import { degreesOf, isFree, resizeCursor } from "./handle-places.ts";
import { volumeEdges } from "./projector-outline.ts";
import { rotationOf } from "./projector-sight.ts";
import type { ScreenPoint } from "./screen-space.ts";

const NO_HANDLES = { guide: "", arrow: "", arrowHead: "", middle: null, stand: null };

type ThrownProjector = PerspectiveProjector | CylindricalProjector;

/** `handles: false` for a decal that is locked, or of a flat stamp, which has its handles in the texture. */
export function drawThrown(
  view: GizmoView,
  projector: Exclude<Projector, { kind: "planar" }>,
  outline: readonly OutlinePoint[],
  options: { readonly handles: boolean; readonly hover: string },
): GizmoPicture {
  const lines = outlinePaths(view, outline);
  const box = linePaths(view, volumeEdges(view.query, projector));
  const handles = new Map<HandleName, HandlePlace>();
  const marks =
    options.handles && projector.kind !== "uv" && outline.length > 0
      ? addHandles(view, projector, outline, handles)
      : NO_HANDLES;
  return {
    outline: lines.seen,
    outlineHidden: lines.hidden,
    box: box.seen,
    boxHidden: box.hidden,
    ...marks,
    hover: options.hover,
    beside: "",
    handles,
  };
}

function addHandles(
  view: GizmoView,
  projector: ThrownProjector,
  outline: readonly OutlinePoint[],
  handles: Map<HandleName, HandlePlace>,
): Pick<GizmoPicture, keyof typeof NO_HANDLES> {
  const rotation = rotationOf(projector);
  const axis = (x: number, y: number, z: number): Vector3 => new Vector3(x, y, z).applyQuaternion(rotation);
  const [right, up, back] = [axis(1, 0, 0), axis(0, 1, 0), axis(0, 0, 1)];
  const top = (outline[OUTLINE_INDEX.n] as OutlinePoint).position;
  const bottom = (outline[OUTLINE_INDEX.s] as OutlinePoint).position;
  const centre = top.clone().lerp(bottom, 0.5);
  const middle = view.screen.project(centre);
  if (middle === null) return NO_HANDLES;
  // Of a label only the front is shown, too: from behind, all that can be done is to turn it by its picture.
  const facing = back.dot(view.screen.eye.sub(centre)) > 0;
  let knob = NO_KNOB;
  if (facing) {
    addScaleHandles(view, outline, middle, handles);
    knob = addKnob(view, outline, { right, up }, middle, handles);
  }
  if (projector.kind === "perspective") {
    addRangeHandles(view, projector, back, middle, handles);
    return { ...NO_HANDLES, guide: knob.stem, middle, stand: { knob: knob.place, stretch: null } };
  }
  if (!facing) return { ...NO_HANDLES, middle };
  const arrow = arrowAlong(view, centre, back, projector.depth, handles);
  if (arrow.handle !== null) handles.set("depth", arrow.handle);
  const stand = { knob: knob.place, stretch: arrow.stretch };
  return { guide: knob.stem, arrow: arrow.line, arrowHead: arrow.head, middle, stand };
}

/** On the eye's axis where it begins and ends to paint, if they leave the others free; none while the camera looks along it. */
function addRangeHandles(
  view: GizmoView,
  { position, near, far }: PerspectiveProjector,
  backward: Vector3,
  middle: ScreenPoint,
  handles: Map<HandleName, HandlePlace>,
): void {
  const at = (distance: number): Vector3 => new Vector3(...position).addScaledVector(backward, -distance);
  const [begin, end] = [view.screen.project(at(near)), view.screen.project(at(far))];
  if (begin === null || end === null || Math.hypot(end.x - begin.x, end.y - begin.y) < LEAST_ARROW) return;
  const angle = degreesOf(begin, end);
  for (const [name, place, distance] of [
    ["near", begin, near],
    ["far", end, far],
  ] as const) {
    if (!isFree(place, { middle, reach: view.reach }, handles)) continue;
    const hidden = !view.query.isClear(view.screen.eye, at(distance));
    handles.set(name, { ...place, angle, hidden, cursor: resizeCursor(angle) });
  }
}

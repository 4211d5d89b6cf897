/** What the gizmo of a projector that is no box looks like: its picture's border, its volume's edges, its handles. */
import { Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector } from "../engine/engine-api.ts";
import type { OutlinePoint } from "./decal-outline.ts";
import type { GizmoPicture, HandleName, HandlePlace } from "./gizmo-overlay.ts";
import {
  addKnob,
  addScaleHandles,
  arrowAlong,
  degreesOf,
  type GizmoView,
  LEAST_ARROW,
  linePaths,
  OUTLINE_INDEX,
  outlinePaths,
  resizeCursor,
} from "./gizmo-picture.ts";
import { volumeEdges } from "./projector-outline.ts";
import { rotationOf } from "./projector-sight.ts";

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
      : { guide: "", arrow: "", arrowHead: "" };
  return {
    outline: lines.seen,
    outlineHidden: lines.hidden,
    box: box.seen,
    boxHidden: box.hidden,
    ...marks,
    hover: options.hover,
    twin: "",
    handles,
  };
}

function addHandles(
  view: GizmoView,
  projector: ThrownProjector,
  outline: readonly OutlinePoint[],
  handles: Map<HandleName, HandlePlace>,
): Pick<GizmoPicture, "guide" | "arrow" | "arrowHead"> {
  const rotation = rotationOf(projector);
  const [y, z] = [new Vector3(0, 1, 0).applyQuaternion(rotation), new Vector3(0, 0, 1).applyQuaternion(rotation)];
  const top = (outline[OUTLINE_INDEX.n] as OutlinePoint).position;
  const bottom = (outline[OUTLINE_INDEX.s] as OutlinePoint).position;
  const middle = top.clone().lerp(bottom, 0.5);
  // Of a label only the front is shown, too: from behind, all that can be done is to turn it by its picture.
  const facing = z.dot(view.screen.eye.sub(middle)) > 0;
  let guide = "";
  if (facing) {
    addScaleHandles(view, outline, handles);
    guide = addKnob(view, top, top, y, handles);
  }
  if (projector.kind === "perspective") {
    addRangeHandles(view, projector, z, handles);
    return { guide, arrow: "", arrowHead: "" };
  }
  if (!facing) return { guide, arrow: "", arrowHead: "" };
  const arrow = arrowAlong(view, middle, z, projector.depth);
  if (arrow.handle !== null) handles.set("depth", arrow.handle);
  return { guide, arrow: arrow.line, arrowHead: arrow.head };
}

/** On the eye's axis where it begins and ends to paint; none while the camera looks along that axis. */
function addRangeHandles(
  view: GizmoView,
  { position, near, far }: PerspectiveProjector,
  backward: Vector3,
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
    const hidden = !view.query.isClear(view.screen.eye, at(distance));
    handles.set(name, { ...place, angle, hidden, cursor: resizeCursor(angle) });
  }
}

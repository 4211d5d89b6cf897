/** Drags of the handles of projectors that are no boxes: an eye's picture and range, a label's arc, height and radius. */
import { Plane, Quaternion, type Ray, Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector } from "../engine/engine-api.ts";
import type { ProjectorDrag } from "./box-drag.ts";
import { rotateByHandle, type SizeLimits, scaleByHandle } from "./decal-handles.ts";
import { type DecalPose, rollOf, wrapAngle } from "./decal-pose.ts";
import { alongAxis, formatDegrees, formatLengths, SNAP, sideOf } from "./gizmo-drag.ts";
import type { HandleName, ScaleHandleName } from "./gizmo-overlay.ts";
import { rolled } from "./projector-drag.ts";
import { rotationOf, toView } from "./projector-sight.ts";

const WIDEST_FOV = 170;
const LEAST_FOV = 0.1;
const FULL_ARC = 360;
/** The least that lies between near and far, as a share of far. */
const LEAST_RANGE = 1e-3;
const DEGREES = 180 / Math.PI;

/**
 * @param grabbed the place in the model that the handle stands at
 * @param from the pointer's ray when it took hold
 * @returns null for a handle that this kind does not have
 */
export function thrownHandleDrag(
  projector: PerspectiveProjector | CylindricalProjector,
  handle: HandleName,
  grabbed: Vector3,
  from: Ray,
  limits: SizeLimits,
): ProjectorDrag | null {
  if (projector.kind === "perspective") {
    if (handle === "near" || handle === "far") return rangeDrag(projector, handle, from, limits);
    if (handle === "depth") return null;
    const depth = -toView(projector, grabbed).z;
    return handle === "rotate" ? turnDrag(projector, depth, from) : pictureScaleDrag(projector, handle, depth, from);
  }
  if (handle === "near" || handle === "far") return null;
  if (handle === "depth") return radiusDrag(projector, from, limits);
  return handle === "rotate"
    ? turnDrag(projector, -projector.radius, from)
    : labelScaleDrag(projector, handle, from, limits);
}

/** An eye's picture grows about its middle, since its eye stays where it is. Edges change one side alone. */
function pictureScaleDrag(
  start: PerspectiveProjector,
  handle: ScaleHandleName,
  depth: number,
  from: Ray,
): ProjectorDrag {
  const side = sideOf(handle);
  const begin = onPlane(start, depth, from);
  const halfY = Math.tan(start.fov / 2 / DEGREES);
  const halfX = halfY * start.aspect;
  return {
    kind: "scale",
    material: null,
    readout: (projector) => (projector.kind === "perspective" ? degreesText(projector.fov) : null),
    move({ ray }) {
      const now = onPlane(start, depth, ray);
      if (begin === null || now === null) return null;
      const travel = { x: (now.x - begin.x) / depth, y: (now.y - begin.y) / depth };
      let [wide, high] = [1, 1];
      if (side.x !== 0 && side.y !== 0) {
        wide = 1 + (side.x * travel.x * halfX + side.y * travel.y * halfY) / (halfX ** 2 + halfY ** 2);
        high = wide;
      } else if (side.x !== 0) wide = 1 + (side.x * travel.x) / halfX;
      else high = 1 + (side.y * travel.y) / halfY;
      wide = Math.max(wide, 1e-3);
      high = Math.max(high, 1e-3);
      const fov = Math.min(WIDEST_FOV, Math.max(LEAST_FOV, 2 * Math.atan(halfY * high) * DEGREES));
      return { ...start, fov, aspect: (start.aspect * wide) / high };
    },
  };
}

/** Turned about its own +Z, in the plane `depth` metres before it. */
function turnDrag(start: PerspectiveProjector | CylindricalProjector, depth: number, from: Ray): ProjectorDrag {
  const begin = onPlane(start, depth, from);
  return {
    kind: "rotate",
    material: null,
    readout: (projector) => (projector.kind === "uv" ? null : formatDegrees(rollOf(rotationOf(projector)))),
    move({ ray, shift }) {
      const now = onPlane(start, depth, ray);
      if (begin === null || now === null) return null;
      const turn = Math.atan2(now.y, now.x) - Math.atan2(begin.y, begin.x);
      const { rotation } = rotateByHandle(unrolled(start, 1, 1), turn, shift ? SNAP : null);
      return { ...start, rotation: [rotation.x, rotation.y, rotation.z, rotation.w] };
    },
  };
}

function rangeDrag(start: PerspectiveProjector, end: "near" | "far", from: Ray, limits: SizeLimits): ProjectorDrag {
  const pose = unrolled(start, 1, 1);
  const begin = alongAxis(pose, from);
  return {
    kind: "depth",
    material: null,
    readout: (projector) => (projector.kind === "perspective" ? formatLengths([projector[end]]) : null),
    move({ ray }) {
      const now = alongAxis(pose, ray);
      if (begin === null || now === null) return null;
      // The eye looks along its own -Z.
      const wanted = start[end] - (now - begin);
      const gap = start.far * LEAST_RANGE;
      return end === "near"
        ? { ...start, near: Math.min(Math.max(wanted, limits.least), start.far - gap) }
        : { ...start, far: Math.max(wanted, start.near + gap) };
    },
  };
}

/** On the unrolled label, as a box's handles do on its rectangle: the opposite side stays, with Alt the middle. */
function labelScaleDrag(
  start: CylindricalProjector,
  handle: ScaleHandleName,
  from: Ray,
  limits: SizeLimits,
): ProjectorDrag {
  const side = sideOf(handle);
  const width = (start.radius * start.arc) / DEGREES;
  const flat = unrolled(start, width, start.height);
  let last = onLabel(start, from);
  let turned = 0;
  const begin = last;
  return {
    kind: "scale",
    material: null,
    readout: (projector) =>
      projector.kind === "cylindrical"
        ? formatLengths([(projector.radius * projector.arc) / DEGREES, projector.height])
        : null,
    move({ ray, alt }) {
      const now = onLabel(start, ray);
      if (begin === null || last === null || now === null) return null;
      // From step to step, so that a label may grow past the back, where angles begin anew.
      turned += wrapAngle(now.angle - last.angle);
      last = now;
      const travel = { x: turned * start.radius, y: now.height - begin.height };
      const { size } = scaleByHandle(flat, side, travel, alt, limits);
      const arc = Math.min(FULL_ARC, (size.x / start.radius) * DEGREES);
      const grown = { ...start, arc, height: size.y };
      return alt
        ? grown
        : rolled(grown, (side.x * (arc - start.arc)) / 2 / DEGREES, (side.y * (size.y - start.height)) / 2);
    },
  };
}

/** The label comes off its cylinder or goes into it, as wide as it was. */
function radiusDrag(start: CylindricalProjector, from: Ray, limits: SizeLimits): ProjectorDrag {
  const pose = unrolled(start, 1, 1);
  const begin = alongAxis(pose, from);
  return {
    kind: "depth",
    material: null,
    readout: (projector) => (projector.kind === "cylindrical" ? formatLengths([projector.radius]) : null),
    move({ ray }) {
      const now = alongAxis(pose, ray);
      if (begin === null || now === null) return null;
      const radius = Math.min(limits.most, Math.max(limits.least, start.radius + now - begin));
      return { ...start, radius, arc: Math.min(FULL_ARC, (start.arc * start.radius) / radius) };
    },
  };
}

/** Where a ray meets a label's cylinder: radians from +Z towards +X, metres along the axis. Beside it, its silhouette. */
function onLabel(label: CylindricalProjector, ray: Ray): { angle: number; height: number } | null {
  const origin = toView(label, ray.origin);
  const direction = ray.direction.clone().applyQuaternion(rotationOf(label).invert());
  const across = direction.x ** 2 + direction.z ** 2;
  if (across < 1e-9) return null;
  const nearest = -(origin.x * direction.x + origin.z * direction.z) / across;
  const missed = origin.x ** 2 + origin.z ** 2 - across * nearest ** 2;
  const inside = label.radius ** 2 - missed;
  const distance = nearest - (inside > 0 ? Math.sqrt(inside / across) : 0);
  const point = origin.addScaledVector(direction, distance);
  return { angle: Math.atan2(point.x, point.z), height: point.y };
}

/** Where a ray meets the plane at right angles to a projector's +Z, `depth` metres along -Z, in its own axes. */
function onPlane(projector: Exclude<Projector, { kind: "uv" }>, depth: number, ray: Ray): Vector3 | null {
  const normal = new Vector3(0, 0, 1).applyQuaternion(rotationOf(projector));
  if (Math.abs(normal.dot(ray.direction)) < 0.04) return null;
  const point = new Vector3(...projector.position).addScaledVector(normal, -depth);
  const hit = ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal, point), new Vector3());
  return hit && toView(projector, hit);
}

/** A projector's place and direction as a box's, for what boxes can do already. */
function unrolled(projector: Exclude<Projector, { kind: "uv" }>, width: number, height: number): DecalPose {
  return {
    position: new Vector3(...projector.position),
    rotation: new Quaternion().copy(rotationOf(projector)),
    size: new Vector3(width, height, 1),
  };
}

function degreesText(value: number): string {
  return `${value.toFixed(value < 10 ? 1 : 0)}°`;
}

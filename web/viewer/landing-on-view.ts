/** Where something new lies well in a view, as hands on its decals tell of it. */

import { Vector3 } from "three";
import type { DecalHands } from "./decal-hands.ts";
import { axisOf, poseOf, tupleOf } from "./decal-pose.ts";
import { landingPlace } from "./landing-place.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { ToolSurface } from "./tool-input.ts";
import type { Landing, ViewerDecal } from "./viewer-api.ts";

/** So many times as wide as something new, both ways, another picture is its background. */
const LARGE = 2;

const AXES = [0, 1, 2] as const;

/** How places of the resting surface are looked at. */
type Looks = Pick<ToolSurface, "lookAt" | "metresPerPixel">;

/**
 * `DecalViewer.landing`.
 *
 * @param looks of a model that may be posed; without them it is shown at rest
 */
export function landingOn(
  hands: DecalHands,
  query: SurfaceQuery,
  width: number,
  aspect: number,
  looks: Looks = looksAtRest(hands),
): Landing | null {
  const { width: across, height: down } = hands.screen.size;
  return landingPlace(
    {
      query,
      sampleAt: (right, below) => hands.sampleAt({ x: across * (0.5 + right), y: down * (0.5 + below) }),
      eyeOf: (hit) => new Vector3(...looks.lookAt(hit).eye),
      spanAt: (hit) => {
        const metres = looks.metresPerPixel(hit);
        return [across * metres, down * metres];
      },
      projectorAt: (hit, ...size) => hands.projectorAt(hit, ...size),
      isTaken: takenBy(hands.gizmo.decals, width),
    },
    width,
    aspect,
  );
}

/**
 * Whether something so wide would lie over another picture there. Not over what is thrown all around, and not over a large print,
 * onto which a badge is laid. As `containsPoint` and `facesNormal`, whose export alone would cost a shop's first touch 30 bytes; but axes
 * are made once, and balls come first: with 1904 decals on a sphere they bring a search from 850 ms down to 37.
 */
function takenBy(decals: readonly ViewerDecal[], width: number): (sample: SurfaceSample) => boolean {
  const others = decals.flatMap(({ visible, projector, materials }) => {
    if (!visible || projector.kind !== "planar" || Math.min(...projector.size.slice(0, 2)) >= LARGE * width) return [];
    const pose = poseOf(projector);
    const half = pose.size.clone().divideScalar(2);
    return [{ middle: pose.position, axes: AXES.map((index) => axisOf(pose, index)), half, materials }];
  });
  return ({ position, normal, material }) =>
    others.some(({ middle, axes, half, materials }) => {
      if (middle.distanceToSquared(position) > half.lengthSq() || !materials.includes(material)) return false;
      const [along = 0, up = 0, out = 0] = axes.map((axis) => Math.abs(axis.dot(position) - axis.dot(middle)));
      const faces = (axes[2]?.dot(normal) ?? 0) > 0;
      return faces && along <= half.x && up <= half.y && out <= half.z;
    });
}

const looksAtRest = ({ screen }: DecalHands): Looks => ({
  lookAt: () => ({ eye: tupleOf(screen.eye), up: tupleOf(screen.axes.up) }),
  metresPerPixel: ({ position }) => screen.metresPerPixel(new Vector3(...position)),
});

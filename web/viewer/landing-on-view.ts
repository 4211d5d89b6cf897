/** Where something new lies well in a view, as hands on its decals tell of it. */

import { Vector3 } from "three";
import type { Projector } from "../engine/engine-api.ts";
import type { DecalHands } from "./decal-hands.ts";
import { tupleOf } from "./decal-pose.ts";
import { landingPlace } from "./landing-place.ts";
import type { SurfaceQuery } from "./surface-query.ts";
import type { ToolSurface } from "./tool-input.ts";
import type { Landing } from "./viewer-api.ts";

/** So many times as wide as something new, both ways, another picture is its background. */
const LARGE = 2;

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
      isTaken: (sample) => hands.gizmo.decalsAt(sample).some(({ projector }) => isLike(projector, width)),
    },
    width,
    aspect,
  );
}

/** A badge is laid onto a shirt's large print, and onto what is thrown all around. */
function isLike(projector: Projector, width: number): boolean {
  return projector.kind === "planar" && Math.min(projector.size[0], projector.size[1]) < LARGE * width;
}

const looksAtRest = ({ screen }: DecalHands): Looks => ({
  lookAt: () => ({ eye: tupleOf(screen.eye), up: tupleOf(screen.axes.up) }),
  metresPerPixel: ({ position }) => screen.metresPerPixel(new Vector3(...position)),
});

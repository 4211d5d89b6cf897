/** Where something new lies well on what the view shows: a picture over a belt, a sword's edge or past a shoulder is moved first of all. */
import type { Vector3 } from "three";
import type { PlanarProjector } from "../engine/engine-api.ts";
import { axisOf, type DecalPose, fromLocal, poseOf } from "./decal-pose.ts";
import { hitOf } from "./surface-hit.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { Landing, SurfaceHit } from "./viewer-api.ts";

export interface LandingView {
  readonly query: SurfaceQuery;
  /** The surface at rest that is seen at a place of the view, in shares of its size from its middle; null beside the model. */
  readonly sampleAt: (right: number, below: number) => SurfaceSample | null;
  /** From where the camera looks at a place of the resting surface. */
  readonly eyeOf: (hit: SurfaceHit) => Vector3;
  /** Metres that the view is wide and high where the hit lies. */
  readonly spanAt: (hit: SurfaceHit) => readonly [width: number, height: number];
  readonly projectorAt: (hit: SurfaceHit, width: number, aspect: number) => PlanarProjector;
  /** Another picture lies there, and none that is a background. */
  readonly isTaken: (sample: SurfaceSample) => boolean;
}

/** Rings of places about the middle, and the outermost one's radius, of the view's size. */
const RINGS = 4;
const REACH = 0.24;
const AROUND = 12;
/** Of the width that is wished for; a place that has room for more of it is the better one. */
const WIDTHS = [1, 0.75, 0.55];
/** Of the view's sides, what something new takes at the most: who has come near to a detail means that. */
const MOST_OF_VIEW = 0.5;
/** What lies so well in the middle is not looked for elsewhere. */
const GOOD = 0.9;
/** Rays along each side of the picture, and how much of it they are spread over: its very rim may hang over an edge. */
const RAYS = 5;
const SPREAD = 0.9;
/** The cosine of the angle at which a picture is still seen well, and of the one up to which a place counts as lying under it. */
const WELL_SEEN = 0.7;
const LIES_UNDER = 0.4;
/** What counts of a picture that lies on another part than its middle does, as on an arm beside the chest. */
const ON_ANOTHER_PART = 0.5;
/** And what of one that lies over another picture: beside it is better, where there is room for half of the width. */
const OVER_ANOTHER = 0.1;

/** Null where nothing of the model is near the middle of the view. */
export function landingPlace(view: LandingView, width: number, aspect: number): Landing | null {
  let best: Landing | null = null;
  let most = 0;
  for (const { right, below, ring } of places()) {
    const sample = view.sampleAt(right, below);
    if (sample === null) continue;
    const hit = hitOf(sample);
    const part = view.query.shellOf(sample.triangle);
    const [across, down] = view.spanAt(hit);
    const wished = Math.min(width, MOST_OF_VIEW * across, MOST_OF_VIEW * down * aspect);
    for (const share of WIDTHS) {
      const landing = { hit, width: share * wished };
      const weight = Math.sqrt(share) * (1 - ring / (2 * RINGS));
      const worth = worthOf(view, landing, aspect, part, most / weight);
      if (ring === 0 && share === 1 && worth >= GOOD) return landing;
      if (weight * worth > most) {
        most = weight * worth;
        best = landing;
      }
    }
  }
  return best;
}

function places(): { readonly right: number; readonly below: number; readonly ring: number }[] {
  const found = [{ right: 0, below: 0, ring: 0 }];
  for (let ring = 1; ring <= RINGS; ring += 1) {
    for (let step = 0; step < AROUND; step += 1) {
      const angle = (2 * Math.PI * step) / AROUND;
      const reach = (ring / RINGS) * REACH;
      found.push({ right: reach * Math.sin(angle), below: -reach * Math.cos(angle), ring });
    }
  }
  return found;
}

/**
 * From 0 to 1: how much of the picture lies on a surface that looks its way, is seen and is free, and how well the camera sees it. 0 for
 * what cannot be worth more than `least`, of which no more is asked than tells so: a hundred places in full take a third of a second.
 */
function worthOf(view: LandingView, { hit, width }: Landing, aspect: number, part: number, least: number): number {
  if (least >= 1) return 0;
  const pose = poseOf(view.projectorAt(hit, width, aspect));
  const eye = view.eyeOf(hit);
  const facing = eye.clone().sub(pose.position).normalize().dot(axisOf(pose, 2));
  const seen = Math.min(1, facing / WELL_SEEN);
  return seen <= least ? 0 : seen * shareLying(view, pose, eye, part) ** 2;
}

function shareLying({ query, isTaken }: LandingView, pose: DecalPose, eye: Vector3, part: number): number {
  const { x: width, y: height, z: depth } = pose.size;
  const along = axisOf(pose, 2).negate();
  let lying = 0;
  for (let row = 0; row < RAYS; row += 1) {
    for (let column = 0; column < RAYS; column += 1) {
      const at = (step: number) => SPREAD * (step / (RAYS - 1) - 0.5);
      const above = fromLocal(pose, at(column) * width, at(row) * height, depth / 2);
      const met = query.raycast(above, along, depth);
      if (met !== null && -met.normal.dot(along) >= LIES_UNDER && query.isClear(eye, met.position)) {
        lying += (query.shellOf(met.triangle) === part ? 1 : ON_ANOTHER_PART) * (isTaken(met) ? OVER_ANOTHER : 1);
      }
    }
  }
  return lying / RAYS ** 2;
}

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

/** Rings of places about the middle, the outermost one's radius, of the view's size, and the places in each but the inner ones. */
const RINGS = 4;
const REACH = 0.24;
const AROUND = 12;
/** Of the width that is wished for, where that was tried everywhere; a place that has room for more of it is the better one. */
const WIDTHS = [0.75, 0.55];
/**
 * So many times what a picture was worth the next narrower one can be in the same place, as it covers a part of what that did. Most
 * need not be tried then: beside a picture in the middle, each place in each width took a slow phone two seconds.
 */
const NARROWER = 3.5;
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

interface Spot {
  readonly hit: SurfaceHit;
  readonly ring: number;
  readonly part: number;
  /** Metres. */
  readonly wished: number;
  /** What a picture there can be worth at most. */
  room: number;
}

/** Null where nothing of the model is near the middle of the view. */
export function landingPlace(view: LandingView, width: number, aspect: number): Landing | null {
  let best: Landing | null = null;
  let most = 0;
  const tryAt = (spot: Spot, share: number): number => {
    const landing = { hit: spot.hit, width: share * spot.wished };
    const weight = Math.sqrt(share) * (1 - spot.ring / (2 * RINGS));
    let worth = spot.room;
    if (weight * worth > most) {
      worth = worthOf(view, landing, aspect, spot.part, most / weight);
      if (weight * worth > most) {
        most = weight * worth;
        best = landing;
      }
    }
    spot.room = Math.min(1, NARROWER * worth);
    return worth;
  };
  const spots: Spot[] = [];
  for (const { right, below, ring } of places()) {
    const sample = view.sampleAt(right, below);
    if (sample === null) continue;
    const hit = hitOf(sample);
    const [across, down] = view.spanAt(hit);
    const wished = Math.min(width, MOST_OF_VIEW * across, MOST_OF_VIEW * down * aspect);
    const spot = { hit, ring, part: view.query.shellOf(sample.triangle), wished, room: 1 };
    if (tryAt(spot, 1) >= GOOD && ring === 0) return best;
    // Over another picture a narrower one is no better, as what is free lies at its rim; unless all is taken.
    if (most <= 2 * OVER_ANOTHER ** 2 || !view.isTaken(sample)) spots.push(spot);
  }
  for (const share of WIDTHS) for (const spot of spots) tryAt(spot, share);
  return best;
}

function places(): { readonly right: number; readonly below: number; readonly ring: number }[] {
  const found = [{ right: 0, below: 0, ring: 0 }];
  for (let ring = 1; ring <= RINGS; ring += 1) {
    const around = Math.min(AROUND, 4 * ring);
    for (let step = 0; step < around; step += 1) {
      const angle = (2 * Math.PI * step) / around;
      const reach = (ring / RINGS) * REACH;
      found.push({ right: reach * Math.sin(angle), below: -reach * Math.cos(angle), ring });
    }
  }
  return found;
}

/**
 * From 0 to 1: how much of the picture lies on a surface that looks its way, is seen and is free, and how well the camera sees it. Of
 * what cannot be worth more than `least` no more is asked than tells so: a hundred places in full take a third of a second.
 */
function worthOf(view: LandingView, { hit, width }: Landing, aspect: number, part: number, least: number): number {
  const pose = poseOf(view.projectorAt(hit, width, aspect));
  const eye = view.eyeOf(hit);
  const facing = eye.clone().sub(pose.position).normalize().dot(axisOf(pose, 2));
  const seen = Math.min(1, facing / WELL_SEEN);
  return seen <= least ? seen : seen * shareLying(view, pose, eye, part) ** 2;
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

/**
 * Where decals go by what the view shows: placed, moved by steps. On a posed model, too: what is seen there is carried to rest,
 * where everything is painted.
 */
import { Vector3 } from "three";
import type { PlanarProjector, Projector } from "../engine/engine-api.ts";
import { beneath, laidFlat, nudgeOnSurface, placeOnSurface, resized } from "./decal-placement.ts";
import { poseOf, projectorOf } from "./decal-pose.ts";
import type { HeldModel } from "./held-model.ts";
import type { ViewPoint } from "./projector-align.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { ThrownKinds } from "./thrown-kinds.ts";
import type { SurfaceHit } from "./viewer-api.ts";

export class ModelPlacement {
  readonly #model: HeldModel;
  readonly #screen: ScreenSpace;

  constructor(model: HeldModel, screen: ScreenSpace) {
    this.#model = model;
    this.#screen = screen;
  }

  /** `DecalViewer.projectorAt`. */
  at(hit: SurfaceHit, width: number, aspect: number, keep: PlanarProjector | undefined): PlanarProjector {
    const { query, concealed } = this.#model;
    const normal = new Vector3(...hit.normal);
    if (hit.isBack) normal.negate();
    const place = { position: new Vector3(...hit.position), normal };
    const kept = keep === undefined ? null : poseOf(keep);
    const pose = placeOnSurface(query, place, width, aspect, this.viewOf(place.position), kept);
    return projectorOf(concealed === null ? pose : beneath(concealed, query, laidFlat(pose, place.normal)));
  }

  /** `DecalViewer.nudge`; what is no box stays until its kind is there. */
  nudged(projector: Projector, rightMetres: number, upMetres: number, thrown: ThrownKinds | null): Projector {
    const { query } = this.#model;
    if (projector.kind === "planar") {
      const pose = poseOf(projector);
      return projectorOf(nudgeOnSurface(query, pose, this.viewOf(pose.position), rightMetres, upMetres));
    }
    if (thrown === null) return projector;
    const view = this.viewOf(thrown.box(query, projector)?.position ?? null);
    return thrown.nudged(projector, view, rightMetres, upMetres, 2 * query.bounds.radius);
  }

  /** `DecalViewer.resized`. */
  resized(before: Projector, after: Projector): Projector {
    if (before.kind !== "planar" || after.kind !== "planar") return after;
    return projectorOf(resized(this.#model.query, poseOf(before), poseOf(after)));
  }

  viewOf(position: Vector3 | null): ViewPoint {
    const view = { eye: this.#screen.eye, ...this.#screen.axes };
    return position === null ? view : this.#model.viewAtRest(position, view);
  }
}

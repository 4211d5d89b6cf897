/**
 * Where decals go by what the view shows: placed, moved by steps, thrown in another way. On a posed model, too: what is seen
 * there is carried to rest, where everything is painted.
 */
import { Vector3 } from "three";
import type { PlanarProjector, Projector } from "../engine/engine-api.ts";
import { beneath, laidFlat, nudgeOnSurface, placeOnSurface } from "./decal-placement.ts";
import { poseOf, projectorOf } from "./decal-pose.ts";
import { placeOfPicture, type SurfaceOfStamp } from "./picture-place.ts";
import type { ViewPoint } from "./projector-align.ts";
import { nudged } from "./projector-drag.ts";
import { pictureBox } from "./projector-outline.ts";
import { ProjectorPlacer } from "./projector-placer.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { ShownModel } from "./shown-model.ts";
import type { SurfaceHit } from "./viewer-api.ts";

export class ModelPlacement {
  readonly #model: ShownModel;
  readonly #screen: ScreenSpace;

  constructor(model: ShownModel, screen: ScreenSpace) {
    this.#model = model;
    this.#screen = screen;
  }

  /** `ModelViewer.projectorAt`. */
  at(hit: SurfaceHit, width: number, aspect: number, keep: PlanarProjector | undefined): PlanarProjector {
    const { query, concealed } = this.#model;
    const place = { position: new Vector3(...hit.position), normal: new Vector3(...hit.normal) };
    const kept = keep === undefined ? null : poseOf(keep);
    const pose = placeOnSurface(query, place, width, aspect, this.#viewOf(place.position), kept);
    return projectorOf(concealed === null ? pose : beneath(concealed, query, laidFlat(pose, place.normal)));
  }

  /** `ModelViewer.nudge`. */
  nudged(projector: Projector, rightMetres: number, upMetres: number): Projector {
    const { query } = this.#model;
    if (projector.kind !== "planar") {
      const view = this.#viewOf(pictureBox(query, projector)?.position ?? null);
      return nudged(projector, view, rightMetres, upMetres, 2 * query.bounds.radius);
    }
    const pose = poseOf(projector);
    return projectorOf(nudgeOnSurface(query, pose, this.#viewOf(pose.position), rightMetres, upMetres));
  }

  /** For commands on one projector, which see it as it is seen in the view. */
  placer(projector: Projector, material: number): ProjectorPlacer {
    const { query } = this.#model;
    const surfaceOfStamp: SurfaceOfStamp = (uv) => {
      const place = query.triangleAtUv(material, uv);
      return place && query.at(place.triangle, place.shares);
    };
    const place = placeOfPicture(query, projector, surfaceOfStamp);
    return new ProjectorPlacer(query, this.#viewOf(place?.position ?? null), surfaceOfStamp);
  }

  #viewOf(position: Vector3 | null): ViewPoint {
    const view = { eye: this.#screen.eye, ...this.#screen.axes };
    return position === null ? view : this.#model.viewAtRest(position, view);
  }
}

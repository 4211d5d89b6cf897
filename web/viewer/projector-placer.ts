/** Commands that change how a picture is thrown on the model: its kind, its direction. By the model at rest and the camera. */
import { Quaternion, Vector3 } from "three";
import type { PlanarProjector, Projector } from "../engine/engine-api.ts";
import { drapeOutline, POINTS_PER_EDGE } from "./decal-outline.ts";
import { fittingDepth, smoothedNear } from "./decal-placement.ts";
import { poseOf, projectorOf, tangentPart, uprightFrame } from "./decal-pose.ts";
import { type PicturePlace, placeOfPicture, type SurfaceOfStamp, stampAt } from "./picture-place.ts";
import { type Alignment, aligned, type ViewPoint } from "./projector-align.ts";
import { projectorFromView } from "./projector-from-view.ts";
import { throwOutline } from "./projector-outline.ts";
import { wrapAround } from "./projector-wrap.ts";
import type { SurfaceQuery } from "./surface-query.ts";

export type { Alignment } from "./projector-align.ts";
export type ProjectorKind = Projector["kind"];

type Corners = readonly [Vector3, Vector3, Vector3, Vector3];

export class ProjectorPlacer {
  readonly #query: SurfaceQuery;
  readonly #view: ViewPoint;
  readonly #surfaceOfStamp: SurfaceOfStamp;

  constructor(query: SurfaceQuery, view: ViewPoint, surfaceOfStamp: SurfaceOfStamp) {
    this.#query = query;
    this.#view = view;
    this.#surfaceOfStamp = surfaceOfStamp;
  }

  /**
   * The projector as another kind, its picture's place and size kept as well as the two kinds allow. To "perspective" it
   * is thrown from the camera, so that it covers what it covers on the screen now; from "perspective", too.
   * Null where it lies on no surface that the kind could take hold of, or where the camera does not see it.
   */
  converted(projector: Projector, kind: ProjectorKind): Projector | null {
    if (kind === "perspective") return this.#fromView(projector);
    if (kind === projector.kind) return projector;
    const place = this.#placeOf(projector);
    if (place === null) return null;
    if (kind === "cylindrical") return wrapAround(this.#query, place);
    return kind === "uv" ? stampAt(this.#query, place) : this.#box(projector, place);
  }

  aligned(projector: Projector, how: Alignment): Projector {
    return aligned(this.#query, projector, how, this.#view, this.#placeOf(projector));
  }

  #placeOf(projector: Projector): PicturePlace | null {
    return placeOfPicture(this.#query, projector, this.#surfaceOfStamp);
  }

  #fromView(projector: Projector): Projector | null {
    const corners = this.#cornersOf(projector);
    const { eye } = this.#view;
    // A picture that was thrown from elsewhere looks leaned from here: it takes its own proportions again.
    const aspect = projector.kind === "perspective" ? projector.aspect : null;
    return corners && projectorFromView(this.#query, corners, eye, aspect);
  }

  #cornersOf(projector: Projector): Corners | null {
    const place = this.#placeOf(projector);
    if (place === null || place.normal.dot(this.#view.eye.clone().sub(place.position)) <= 0) return null;
    if (projector.kind === "uv") {
      const at = (x: number, y: number): Vector3 =>
        place.position.clone().addScaledVector(place.right, x).addScaledVector(place.up, y);
      return [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)];
    }
    const outline =
      projector.kind === "planar" ? drapeOutline(this.#query, poseOf(projector)) : throwOutline(this.#query, projector);
    return [0, 1, 2, 3].map((corner) => outline[corner * POINTS_PER_EDGE]?.position) as unknown as Corners;
  }

  #box(projector: Projector, place: PicturePlace): PlanarProjector {
    const { position, right, up } = place;
    const size = new Vector3(right.length(), up.length(), 1);
    // What goes far round a body is no wider, flattened, than the body.
    if (projector.kind === "cylindrical") size.x = Math.min(size.x, 2 * projector.radius);
    const { normal } = smoothedNear(this.#query, place, size);
    const top = tangentPart(up, normal).lengthSq() > 1e-12 ? up : new Vector3().crossVectors(normal, right);
    const rotation = uprightFrame(normal, top.clone().normalize());
    const pose = { position, rotation: rotation ?? new Quaternion(), size };
    size.z = 0.5 * Math.max(size.x, size.y);
    size.z = fittingDepth(this.#query, pose);
    return projectorOf(pose);
  }
}

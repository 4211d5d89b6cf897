/** Commands on one projector by what the view shows. */
import type { Projector } from "../engine/engine-api.ts";
import type { HeldModel } from "./held-model.ts";
import { ModelPlacement } from "./model-placement.ts";
import { placeOfPicture, type SurfaceOfStamp } from "./picture-place.ts";
import { ProjectorPlacer } from "./projector-placer.ts";
import type { ScreenSpace } from "./screen-space.ts";

/** The placer sees the projector as it is seen in the view. `material`: in which texture a flat stamp lies. */
export function placerFor(
  model: HeldModel,
  screen: ScreenSpace,
  projector: Projector,
  material: number,
): ProjectorPlacer {
  const { query } = model;
  const surfaceOfStamp: SurfaceOfStamp = (uv) => {
    const place = query.triangleAtUv(material, uv);
    return place && query.at(place.triangle, place.shares);
  };
  const place = placeOfPicture(query, projector, surfaceOfStamp);
  const view = new ModelPlacement(model, screen).viewOf(place?.position ?? null);
  return new ProjectorPlacer(query, view, surfaceOfStamp);
}

/** What customers' decals come into line with as they slide: the product's middles, those of its print zones, and other decals. */
import { middlesOf } from "../../editor/tools/model-middles.ts";
import type { BoxZoneShape, PrintZone } from "../../engine/print-zones.ts";
import { AlignedSlides, type ModelMiddle, type Surroundings } from "../../viewer/aligned-slide.ts";
import { axisOf, type DecalPose, poseOf, tupleOf } from "../../viewer/decal-pose.ts";
import type { HeldView } from "../../viewer/decal-viewer.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import type { Desk } from "../desk/desk.ts";
import { deepestPlace } from "../desk/polygon-places.ts";
import { isPolygon } from "../desk/zone-holds.ts";
import type { ShopProduct } from "./shop-product.ts";

/** Metres: the width of a picture that lies on one point of the surface. */
const POINT = 1e-4;

/** Brings decals into line from now on, where the product is still there. */
export function alignDecals(view: HeldView, product: ShopProduct, desk: Pick<Desk, "zones">): void {
  if (product.closed) return;
  /** Of polygons: they are looked for once, and not at the beginning of each slide. */
  const deepest = new WeakMap<PrintZone, SurfaceHit | null>();
  const middlesOfZone = (zone: PrintZone): ModelMiddle[] => {
    // Across each of its axes: which of them looks out of the surface, a box does not say.
    if (!isPolygon(zone)) return middlesAcross(poseOf({ ...(zone.shape as BoxZoneShape), kind: "planar" }), [0, 1, 2]);
    const hit = deepest.get(zone) ?? deepestPlace(zone, view.surface);
    deepest.set(zone, hit);
    // As a picture would lie there, upright: how wide it is turns nothing where it is a point.
    return hit === null ? [] : middlesAcross(poseOf(view.projectorAt(hit, POINT, 1)), [0, 1]);
  };
  view.align((screen, query) => {
    const slides = new AlignedSlides(view.element, screen, query);
    slides.find = (id): Surroundings => {
      const { open, viewer } = product;
      const zones = (desk.zones?.zones ?? []).flatMap(middlesOfZone);
      const boxes = viewer.decals.flatMap((decal) =>
        decal.id !== id && decal.projector.kind === "planar" ? [decal.projector] : [],
      );
      return { middles: [...(open ? middlesOf(open.info) : []), ...zones], boxes };
    };
    return slides;
  });
}

function middlesAcross(pose: DecalPose, axes: readonly (0 | 1 | 2)[]): ModelMiddle[] {
  return axes.map((axis) => ({ point: tupleOf(pose.position), normal: tupleOf(axisOf(pose, axis)) }));
}

/** What customers' decals come into line with as they slide: the product's middles, those of its print zones, and other decals. */
import { middlesOf } from "../../editor/tools/model-middles.ts";
import type { BoxZoneShape } from "../../engine/print-zones.ts";
import { AlignedSlides, type ModelMiddle, type Surroundings } from "../../viewer/aligned-slide.ts";
import { axisOf, poseOf, tupleOf } from "../../viewer/decal-pose.ts";
import type { HeldView } from "../../viewer/decal-viewer.ts";
import type { Desk } from "../desk/desk.ts";
import type { ShopProduct } from "./shop-product.ts";

/** Brings decals into line from now on, where the product is still there. */
export function alignDecals(view: HeldView, product: ShopProduct, desk: Pick<Desk, "zones">): void {
  if (product.closed) return;
  view.align((screen, query) => {
    const slides = new AlignedSlides(view.element, screen, query);
    slides.find = (id): Surroundings => {
      const { open, viewer } = product;
      const zones = (desk.zones?.zones ?? []).flatMap(({ shape }) =>
        shape.kind === "box" ? middlesOfZone(shape) : [],
      );
      const boxes = viewer.decals.flatMap((decal) =>
        decal.id !== id && decal.projector.kind === "planar" ? [decal.projector] : [],
      );
      return { middles: [...(open ? middlesOf(open.info) : []), ...zones], boxes };
    };
    return slides;
  });
}

/** Across each of its axes: which of them looks out of the surface, a zone does not say. */
function middlesOfZone(shape: BoxZoneShape): ModelMiddle[] {
  const pose = poseOf({ ...shape, kind: "planar" });
  return ([0, 1, 2] as const).map((axis) => ({ point: shape.position, normal: tupleOf(axisOf(pose, axis)) }));
}

/** Pixel layers: small pictures laid over the whole texture, texel on texel, that the pixel tools rewrite. */
import { sameItems } from "../../engine/same-items.ts";
import {
  type DecalLayer,
  type Design,
  type DesignLayer,
  findLayer,
  freeIdIn,
  insertAt,
  type Mask,
  makeDecalLayer,
  mapLayer,
  materialsIn,
  materialsOf,
  paintsMaterial,
  topOf,
  visitOf,
  walkLayers,
} from "../document/index.ts";
import { freeName, withAsset, withoutUnusedAssets } from "../state/design-edits.ts";
import { maskBlend } from "../state/mask-edits.ts";
import type { Strings } from "../strings.ts";

const WHOLE_TEXTURE = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;

/** Whether the pixel tools can rewrite a layer: its picture is read texel by texel over the whole texture. */
export function isPixelLayer(layer: DesignLayer | undefined): layer is DecalLayer {
  if (layer?.type !== "decal" || layer.projector.kind !== "uv") return false;
  const { center, size, angle } = layer.projector;
  return (
    [...center, ...size, angle].join() ===
      [...WHOLE_TEXTURE.center, ...WHOLE_TEXTURE.size, WHOLE_TEXTURE.angle].join() &&
    layer.filter === "nearest" &&
    layer.wrap === "none" &&
    !layer.flipX &&
    !layer.flipY
  );
}

/** The pixel layer that a material's texels are painted on: the selected one, else the topmost that can be; undefined: none yet. */
export function pixelLayerFor(design: Design, selectedId: string | null, material: number): DecalLayer | undefined {
  const isFit = (layer: DesignLayer | undefined): layer is DecalLayer =>
    isPixelLayer(layer) && paintsMaterial(layer, material);
  const selected = visitOf(design, selectedId)?.layer;
  if (isFit(selected)) return selected;
  let topmost: DecalLayer | undefined;
  for (const { layer, shown, locked } of walkLayers(design, { masks: false, strokes: false })) {
    if (isFit(layer) && shown && !locked) topmost = layer;
  }
  return topmost;
}

/** What the texels of a gesture are for where a mask is painted on: they show the masked layer again, or hide it. */
export interface MaskedPixels {
  readonly layerId: string;
  readonly hides: boolean;
}

/** Whether a mask's texels of a material count: those of another reach what they were not drawn on, or nothing. */
export function masksMaterial(masked: DesignLayer, material: number): boolean {
  const painted = materialsIn(masked);
  return painted.length === 0 || painted.includes(material);
}

/** Where texels on a mask go. `over` lies above and does otherwise: there they give way, so that what is drawn now counts. */
export interface MaskPixels {
  readonly layer: DecalLayer;
  readonly over: DecalLayer | null;
}

/**
 * The pixel layer of a mask that shows, or hides, and lies above all else that does otherwise, but for one of the same texels:
 * pencil and eraser, in turn, have a layer each. Undefined where there is none.
 */
export function maskPixelLayer(mask: Mask, hides: boolean, material: number): MaskPixels | undefined {
  let over: DecalLayer | null = null;
  for (const layer of mask.layers.toReversed()) {
    if (!isPixelLayer(layer) || !isWhole(layer)) return undefined;
    const does = [hides, !hides].find((each) => layer.blend === maskBlend(mask, each));
    if (does === undefined) return undefined;
    if (!paintsMaterial(layer, material)) continue;
    if (does === hides)
      return over === null || sameItems(materialsOf(over), materialsOf(layer)) ? { layer, over } : undefined;
    if (over !== null) return undefined;
    over = layer;
  }
  return undefined;
}

const isWhole = ({ opacity, visible, mask, locked }: DecalLayer): boolean =>
  opacity === 1 && visible && mask === null && !locked;

/** Gives a pixel layer another picture; the one before goes where nothing else uses it. */
export function withPixels(
  design: Design,
  id: string,
  asset: { readonly type: "image/png"; readonly uri: string },
  strings: Strings,
): Design {
  const { design: more, key } = withAsset(design, strings.tools.pixelLayer, asset);
  return withoutUnusedAssets(mapLayer(more, id, (layer) => ({ ...layer, asset: key }) as DesignLayer));
}

/** A new pixel layer above the selected layer. */
export function addPixelLayer(
  design: Design,
  selectedId: string | null,
  material: number,
  asset: { readonly type: "image/png"; readonly uri: string },
  strings: Strings,
): { readonly design: Design; readonly id: string } {
  const { design: more, key } = withAsset(design, strings.tools.pixelLayer, asset);
  const id = freeIdIn(more);
  const layer = makeDecalLayer({
    id,
    name: freeName(more, strings.tools.pixelLayer),
    material,
    asset: key,
    projector: WHOLE_TEXTURE,
    filter: "nearest",
  });
  const visit = visitOf(design, selectedId);
  const place =
    visit?.list === "layers"
      ? { parentId: visit.parentId, list: "layers" as const, index: visit.index + 1 }
      : topOf(design);
  return { design: insertAt(more, place, layer), id };
}

/** A new pixel layer on top of a mask; null where the layer or its mask is no longer there. */
export function addMaskPixels(
  design: Design,
  { layerId, hides }: MaskedPixels,
  material: number,
  asset: { readonly type: "image/png"; readonly uri: string },
  strings: Strings,
): Design | null {
  const mask = findLayer(design, layerId)?.mask;
  if (!mask) return null;
  const { design: more, key } = withAsset(design, strings.tools.pixelLayer, asset);
  const layer = makeDecalLayer({
    id: freeIdIn(more),
    name: strings.tools.pixelLayer,
    material,
    asset: key,
    projector: WHOLE_TEXTURE,
    filter: "nearest",
    blend: maskBlend(mask, hides),
  });
  return insertAt(more, { parentId: layerId, list: "mask", index: mask.layers.length }, layer);
}

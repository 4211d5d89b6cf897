/** Which pictures layers show: those given to `Engine.setAsset`, and words. */
import type { EngineLayer, EngineMask, EnginePicture, Projector } from "./engine-api.ts";
import { paintingLayers } from "./layer-tree.ts";
import { isShippedFontAddress } from "./shipped-fonts.ts";

/** The picture that the layer itself throws; null for layers that throw none. */
export function pictureOf(layer: EngineLayer): EnginePicture | null {
  if (layer.type === "decal") return layer.asset;
  if (layer.type === "stroke" && layer.brush.tip === "picture") return layer.brush.asset;
  return null;
}

/** All pictures that layers show, in groups and masks too, words among them. */
export function* allPicturesOf(layers: readonly EngineLayer[]): Generator<EnginePicture> {
  for (const layer of paintingLayers(layers)) {
    const picture = pictureOf(layer);
    if (picture !== null) yield picture;
  }
}

/** The keys of all pictures that layers show, in groups and masks too. */
export const picturesOf = (layers: readonly EngineLayer[]): Set<string> =>
  new Set([...allPicturesOf(layers)].filter((picture) => typeof picture === "string"));

/** The keys of all fonts that the layers' words are set in, but for those that come with Texelcast. */
export function fontsOf(layers: readonly EngineLayer[]): Set<string> {
  const fonts = [...allPicturesOf(layers)].flatMap((picture) => (typeof picture === "string" ? [] : [picture.font]));
  return new Set(fonts.filter((font) => !isShippedFontAddress(font)));
}

/**
 * The layer with other pictures, in groups and masks too.
 *
 * @param change gives the picture that takes a picture's place; `projector` is where it lies, a stroke's first dab,
 * undefined for a stroke without any
 */
export function withPictures(
  layer: EngineLayer,
  change: (picture: EnginePicture, projector: Projector | undefined) => EnginePicture,
): EngineLayer {
  const own = withOwnPicture(layer, change);
  if (!own.mask) return own;
  const mask: EngineMask = { ...own.mask, layers: own.mask.layers.map((held) => withPictures(held, change)) };
  return { ...own, mask };
}

function withOwnPicture(
  layer: EngineLayer,
  change: (picture: EnginePicture, projector: Projector | undefined) => EnginePicture,
): EngineLayer {
  if (layer.type === "decal") return { ...layer, asset: change(layer.asset, layer.projector) };
  if (layer.type === "group") return { ...layer, layers: layer.layers.map((held) => withPictures(held, change)) };
  if (layer.type === "stroke" && layer.brush.tip === "picture")
    return { ...layer, brush: { ...layer.brush, asset: change(layer.brush.asset, layer.dabs[0]) } };
  return layer;
}

/** `withPictures` for whoever keeps pictures and fonts under other keys than the design: one function for both. */
export const withKeys = (layer: EngineLayer, rename: (key: string) => string): EngineLayer =>
  withPictures(layer, (picture) =>
    typeof picture === "string" ? rename(picture) : { ...picture, font: rename(picture.font) },
  );

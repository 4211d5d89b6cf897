/** Which pictures layers show: those given to `Engine.setAsset`, and words. */
import type { EngineDab, EngineLayer, EnginePicture, Projector } from "./engine-api.ts";
import { isShippedFontAddress } from "./font-address.ts";
import { paintingLayers } from "./layer-tree.ts";
import { sameItems } from "./same-items.ts";

/** The picture that the layer itself throws; null for layers that throw none. */
export function pictureOf(layer: EngineLayer): EnginePicture | null {
  if (layer.type === "decal") return layer.asset;
  if (layer.type === "stroke" && layer.brush.tip === "picture") return layer.brush.asset;
  return null;
}

/** All pictures that layers show, in groups and masks too, words among them. */
export const allPicturesOf = (layers: readonly EngineLayer[]): EnginePicture[] =>
  paintingLayers(layers)
    .map(pictureOf)
    .filter((picture) => picture !== null);

/** The keys of all pictures that layers show, in groups and masks too. */
export const picturesOf = (layers: readonly EngineLayer[]): Set<string> =>
  new Set(allPicturesOf(layers).filter((picture) => typeof picture === "string"));

/** The keys of all fonts that the layers' words are set in, but for those that come with Texelcast. */
export function fontsOf(layers: readonly EngineLayer[]): Set<string> {
  const fonts = allPicturesOf(layers).flatMap((picture) => (typeof picture === "string" ? [] : [picture.font]));
  return new Set(fonts.filter((font) => !isShippedFontAddress(font)));
}

/** Gives the picture that takes a picture's place; `projector` is where it lies, undefined for a stroke without any dab. */
export type ChangePicture = (picture: EnginePicture, projector: Projector | undefined) => EnginePicture;

/** The layer with other pictures, in groups and masks too. Equal layers stay the same objects, by which the engine knows them. */
export function withPictures(layer: EngineLayer, change: ChangePicture): EngineLayer {
  const own = pictureOf(layer);
  if (own === null && layer.type !== "group" && !layer.mask) return layer;
  const parts: ChangedParts = {
    picture: own === null ? null : change(own, layer.type === "decal" ? layer.projector : dabsOf(layer)[0]),
    held: layer.type === "group" ? layer.layers.map((one) => withPictures(one, change)) : [],
    masking: layer.mask?.layers.map((one) => withPictures(one, change)) ?? [],
  };
  const before = { picture: own, held: heldBy(layer), masking: layer.mask?.layers ?? [] };
  if (sameParts(parts, before)) return layer;
  const known = CHANGED.get(layer);
  if (known !== undefined && sameParts(parts, known)) return known.changed;
  const changed = withParts(layer, parts);
  CHANGED.set(layer, { ...parts, changed });
  return changed;
}

interface ChangedParts {
  readonly picture: EnginePicture | null;
  readonly held: readonly EngineLayer[];
  readonly masking: readonly EngineLayer[];
}

const CHANGED = new WeakMap<EngineLayer, ChangedParts & { readonly changed: EngineLayer }>();

const dabsOf = (layer: EngineLayer): readonly EngineDab[] => (layer.type === "stroke" ? layer.dabs : []);
const heldBy = (layer: EngineLayer): readonly EngineLayer[] => (layer.type === "group" ? layer.layers : []);

const sameParts = (a: ChangedParts, b: ChangedParts): boolean =>
  a.picture === b.picture && sameItems(a.held, b.held) && sameItems(a.masking, b.masking);

function withParts(layer: EngineLayer, { picture, held, masking }: ChangedParts): EngineLayer {
  const changed = { ...layer, mask: layer.mask && { ...layer.mask, layers: masking } };
  if (changed.type === "group") return { ...changed, layers: held };
  if (picture === null) return changed;
  return changed.type === "stroke"
    ? ({ ...changed, brush: { ...changed.brush, asset: picture } } as EngineLayer)
    : ({ ...changed, asset: picture } as EngineLayer);
}

/** `withPictures` for whoever keeps pictures and fonts under other keys than the design: one function for both. */
export const withKeys = (layer: EngineLayer, rename: (key: string) => string): EngineLayer =>
  withPictures(layer, (picture) => {
    if (typeof picture === "string") return rename(picture);
    const font = rename(picture.font);
    return font === picture.font ? picture : { ...picture, font };
  });

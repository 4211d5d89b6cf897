/** Fonts made known to the page, so that a list can show each name in its own. */
import { EMOJI, SHIPPED_FONTS, type ShippedFontId, shippedFontOf } from "../../engine/shipped-fonts.ts";
import type { DesignAsset } from "../document/index.ts";
import type { AssetLibrary } from "../state/asset-library.ts";

const asked = new Map<string, Promise<unknown>>();
/** Of texts in a list: one that cannot be had is not asked for at each change of the list. */
const listed = new Map<string, string>();

/** Of a font that comes with Texelcast. */
export const shippedFamily = (id: ShippedFontId): string => `texelcast-${id}`;

/** Loads them all, once; a font that cannot be had is shown in the page's own, and so are those of emoji, which lack the letters of a name. */
export function loadShippedPreviews(): void {
  for (const id of Object.keys(SHIPPED_FONTS) as ShippedFontId[]) {
    if (SHIPPED_FONTS[id].standsInFor?.includes(EMOJI)) continue;
    load(shippedFamily(id), shippedSource(id));
  }
}

/** A font of the user's; gives the family's name. */
export function loadOwnPreview(key: string, bytes: Uint8Array): string {
  const family = `texelcast-own-${key}`;
  load(family, bytes);
  return family;
}

/** Of a text's font, for some of its letters: it is loaded, as the engine needs it, too. Null for one that is not known. */
export function familyOfText(library: Pick<AssetLibrary, "font">, asset: DesignAsset | undefined): string | null {
  const id = shippedFontOf(asset?.uri ?? "");
  const own = library.font(asset);
  const key = id ?? own?.engineKey;
  if (key === undefined) return null;
  const known = listed.get(key);
  if (known !== undefined) return known;
  const family = own ? loadOwnPreview(own.engineKey, own.bytes) : shippedFamily(id as ShippedFontId);
  if (id) load(family, shippedSource(id));
  listed.set(key, family);
  return family;
}

const shippedSource = (id: ShippedFontId): string => `url("${SHIPPED_FONTS[id].file.url().href}")`;

function load(family: string, source: string | Uint8Array): void {
  if (asked.has(family)) return;
  const face = new FontFace(family, source as string);
  asked.set(
    family,
    face.load().then(
      () => document.fonts.add(face),
      () => asked.delete(family),
    ),
  );
}

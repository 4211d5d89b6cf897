/** Fonts made known to the page, so that a list can show each name in its own. */
import { EMOJI, SHIPPED_FONTS, type ShippedFontId, shippedFontOf } from "../../engine/shipped-fonts.ts";
import type { DesignAsset } from "../document/index.ts";
import type { AssetLibrary, LibraryFont } from "../state/asset-library.ts";

const asked = new Map<string, Promise<unknown>>();
/** Of texts in a list: one that cannot be had is not asked for at each change of the list. */
const listed = new Set<ShippedFontId>();
/** Of the users' own fonts. By the font, not by its key: each editor of a page has a first one. */
const own = new WeakMap<LibraryFont, string>();
/** The page would hold their bytes for good. */
const letGo = new FinalizationRegistry<FontFace>((face) => document.fonts.delete(face));
let count = 0;

/** Of a font that comes with Texelcast. */
export const shippedFamily = (id: ShippedFontId): string => `texelcast-${id}`;

/** Loads them all, once; a font that cannot be had is shown in the page's own, and so are those of emoji, which lack the letters of a name. */
export function loadShippedPreviews(): void {
  for (const id of Object.keys(SHIPPED_FONTS) as ShippedFontId[]) {
    if (SHIPPED_FONTS[id].standsInFor?.includes(EMOJI)) continue;
    load(shippedFamily(id), shippedSource(id));
  }
}

/** A font of the user's, for as long as a library has it; gives the family's name. */
export function loadOwnPreview(font: LibraryFont): string {
  const known = own.get(font);
  if (known !== undefined) return known;
  count += 1;
  const family = `texelcast-own-${count}`;
  own.set(font, family);
  const face = new FontFace(family, font.bytes as Uint8Array<ArrayBuffer>);
  void face.load().then(
    () => {
      document.fonts.add(face);
      letGo.register(font, face);
    },
    // What this browser cannot read is shown in the page's own.
    () => {},
  );
  return family;
}

/** Of a text's font, for some of its letters: it is loaded, as the engine needs it, too. Null for one that is not known. */
export function familyOfText(library: Pick<AssetLibrary, "font">, asset: DesignAsset | undefined): string | null {
  const id = shippedFontOf(asset?.uri ?? "");
  if (id === undefined) {
    const font = library.font(asset);
    return font ? loadOwnPreview(font) : null;
  }
  if (!listed.has(id)) load(shippedFamily(id), shippedSource(id));
  listed.add(id);
  return shippedFamily(id);
}

const shippedSource = (id: ShippedFontId): string => `url("${SHIPPED_FONTS[id].file.url().href}")`;

function load(family: string, source: string): void {
  if (asked.has(family)) return;
  const face = new FontFace(family, source);
  asked.set(
    family,
    face.load().then(
      () => document.fonts.add(face),
      () => asked.delete(family),
    ),
  );
}

/** Fonts made known to the page, so that a list can show each name in its own. */
import { EMOJI, SHIPPED_FONTS, type ShippedFontId } from "../../engine/shipped-fonts.ts";

const asked = new Map<string, Promise<unknown>>();

/** Of a font that comes with Texelcast. */
export const shippedFamily = (id: ShippedFontId): string => `texelcast-${id}`;

/** Loads them all, once; a font that cannot be had is shown in the page's own, and so are those of emoji, which lack the letters of a name. */
export function loadShippedPreviews(): void {
  for (const [id, { file, standsInFor }] of Object.entries(SHIPPED_FONTS)) {
    if (standsInFor?.includes(EMOJI)) continue;
    load(shippedFamily(id as ShippedFontId), `url("${file.url().href}")`);
  }
}

/** A font of the user's; gives the family's name. */
export function loadOwnPreview(key: string, bytes: Uint8Array): string {
  const family = `texelcast-own-${key}`;
  load(family, bytes);
  return family;
}

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

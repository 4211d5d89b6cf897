/** How large a drawing says that it is, where it says half of it. */
import { tagsOf } from "./xml-tags.ts";

/** An attribute with what stands before it: a value may hold what looks like another one. */
const ATTRIBUTE = /\s([^\s=]+)\s*=\s*(?:"[^"]*"|'[^']*')/g;

/**
 * The drawing without its `width` and `height` where it gives one of them as a length, and not the other, beside a `viewBox`: icons do
 * ("height='1em'"). They have the viewBox's proportions in browsers; the renderer takes the viewBox's own length for the one
 * that is not there, and lays the drawing across the middle of a strip.
 */
export function withoutHalfSize(svg: string): string {
  for (const { name, kind, attributes, start, length } of tagsOf(svg)) {
    if (name !== "svg" || kind === "end") continue;
    const [width, height] = [lengthIn(attributes.get("width")), lengthIn(attributes.get("height"))];
    const isHalf = (width === null && Number(height) > 0) || (height === null && Number(width) > 0);
    if (!isHalf || !attributes.has("viewBox")) return svg;
    const tag = svg
      .slice(start, start + length)
      .replace(ATTRIBUTE, (whole, attribute) => (/^(?:width|height)$/.test(attribute) ? "" : whole));
    return svg.slice(0, start) + tag + svg.slice(start + length);
  }
  return svg;
}

/** Its number, whatever the unit; null for a share of what is around, and for what is no length. */
function lengthIn(given = ""): number | null {
  const number = Number.parseFloat(given);
  return Number.isNaN(number) || given.includes("%") ? null : number;
}

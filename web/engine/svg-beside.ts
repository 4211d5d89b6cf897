/**
 * What lies so far beside a drawing's page that the renderer stops at it. It draws a translucent or clipped group by itself,
 * over the part of it that lies within two pages' width and height of the page's corner, and panics where there is none
 * (github.com/thx/resvg-js/issues/413): cuttings from a large sheet have such groups, and markers along a path make them.
 */
import { moved, type SvgElements } from "./svg-elements.ts";
import { isDrawnApart } from "./svg-shapes.ts";

/** Pages. A little less than the renderer's two, for what it rounds. */
const FAR = 1.9;

/**
 * A simplified document without that; null where it holds none. What a filter goes over stays, since the filter may bring it
 * back, and so does what is in a definition, whose place is not known.
 */
export function withoutBeside(simplified: string, { elements, width, height }: SvgElements): string | null {
  const kept: string[] = [];
  let filtered = { start: -1, end: -1 };
  let cutFrom = simplified.length;
  // What is around an element comes before it.
  for (const { attributes, definition, painted, matrix, start, end } of elements.toReversed()) {
    if (end > cutFrom || (start > filtered.start && end < filtered.end)) continue;
    if (attributes.has("filter")) filtered = { start, end };
    else if (definition === "" && painted !== null && isDrawnApart(attributes)) {
      const [x0, y0, x1, y1] = moved(matrix, painted);
      if (x0 < FAR * width && x1 > -FAR * width && y0 < FAR * height && y1 > -FAR * height) continue;
      kept.push(simplified.slice(end, cutFrom));
      cutFrom = start;
    }
  }
  return kept.length === 0 ? null : simplified.slice(0, cutFrom) + kept.toReversed().join("");
}

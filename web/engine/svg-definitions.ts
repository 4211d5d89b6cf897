/** How often a drawing's patterns, masks and clip paths are drawn, and how large. */
import { askersFirst, WHOLE } from "./asked-parts.ts";
import {
  type Bounds,
  DEFINITIONS,
  idsIn,
  numbersOf,
  rectangleOf,
  type SvgElement,
  type SvgElements,
  scaleOf,
  sidesOf,
} from "./svg-elements.ts";

export interface DefinitionUse {
  /** Patterns in patterns count as often as all of that comes to. */
  readonly times: number;
  /** How much it is enlarged to the document's units, at the most. */
  readonly scale: number;
  /** Of the pixels that it is drawn to, in pictures, at the most: a pattern's tile; a mask has the picture's. */
  readonly area: number;
}

interface Asking {
  count: number;
  scale: number;
  tile: number;
}

/** By id. The document itself has the id "". */
export function definitionUses({ elements, width, height }: SvgElements): Map<string, DefinitionUse> {
  const definitions = new Map<string, SvgElement>();
  for (const element of elements) {
    if (DEFINITIONS.has(element.name)) definitions.set(element.attributes.get("id") ?? "", element);
  }
  const uses = new Map<string, DefinitionUse>([[WHOLE, { times: 1, scale: 1, area: 1 }]]);
  if (definitions.size === 0) return uses;
  const asks = new Map<string, Map<string, Asking>>([[WHOLE, new Map()]]);
  for (const id of definitions.keys()) asks.set(id, new Map());
  const picture: Bounds = [0, 0, width, height];
  for (const { attributes, matrix, bounds, definition } of elements) {
    for (const name of ["fill", "stroke", "mask", "clip-path"]) {
      for (const id of idsIn(attributes.get(name))) {
        const asked = definitions.get(id);
        if (asked === undefined) continue;
        const sides = sidesOf(bounds ?? picture);
        const enlarged = scaleOf(matrix);
        const asking = asks.get(definition)?.get(id) ?? { count: 0, scale: 0, tile: 0 };
        asking.count += 1;
        asking.scale = Math.max(asking.scale, enlarged * contentScale(asked, sides));
        asking.tile = Math.max(asking.tile, (tileArea(asked, sides) * enlarged ** 2) / (width * height));
        asks.get(definition)?.set(id, asking);
      }
    }
  }
  for (const asker of askersFirst(asks)) {
    const use = uses.get(asker) ?? { times: 0, scale: 0, area: 0 };
    for (const [id, { count, scale, tile }] of asks.get(asker) ?? []) {
      const before = uses.get(id) ?? { times: 0, scale: 0, area: 0 };
      uses.set(id, {
        times: before.times + use.times * count,
        scale: Math.max(before.scale, use.scale * scale),
        area: Math.max(before.area, definitions.get(id)?.name === "pattern" ? tile * use.scale ** 2 : 1),
      });
    }
  }
  return uses;
}

/** How much what is in it is enlarged, but for transforms. `sides`: of what asks for it. */
function contentScale({ name, attributes }: SvgElement, sides: readonly [number, number]): number {
  const longest = Math.max(...sides);
  const [, , width = 0, height = 0] = numbersOf(attributes.get("viewBox") ?? "");
  if (name === "pattern" && width > 0 && height > 0) {
    const [wide, high] = sidesOf(rectangleOf(attributes));
    const fitted = Math.max(wide / width, high / height);
    return attributes.get("patternUnits") === "userSpaceOnUse" ? fitted : fitted * longest;
  }
  const units = attributes.get(name === "clipPath" ? "clipPathUnits" : `${name}ContentUnits`);
  return units === "objectBoundingBox" ? longest : 1;
}

/** In the units of what asks for it. */
function tileArea({ attributes, matrix }: SvgElement, [wide, high]: readonly [number, number]): number {
  const [width, height] = sidesOf(rectangleOf(attributes));
  const share = attributes.get("patternUnits") === "userSpaceOnUse" ? 1 : wide * high;
  return width * height * share * scaleOf(matrix) ** 2;
}

/**
 * How long an SVG would take to draw, told from the document and not by the clock, so that every machine draws the same: a
 * few bytes can ask for hours. Weights are about ten nanoseconds each on a slow machine, measured with resvg in WebAssembly.
 */
import { definitionUses } from "./svg-definitions.ts";
import type { SvgElements } from "./svg-elements.ts";
import { type FilterUse, filterUses, weightOfFilters } from "./svg-filters.ts";
import { costOfShapes, type ShapeCost, weightOfOutline, weightOfShapes } from "./svg-shapes.ts";

export interface SvgCost {
  readonly filters: readonly FilterUse[];
  readonly shapes: ShapeCost;
}

/** Of one drawing: some seconds on a usual machine. */
const MOST_WEIGHT = 2.5e9;

/** @param costOfPicture as of costOfShapes */
export function costOf(elements: SvgElements, costOfPicture: (data: string) => ShapeCost): SvgCost {
  const definitions = definitionUses(elements);
  return {
    filters: filterUses(elements, definitions),
    shapes: costOfShapes(elements, definitions, costOfPicture),
  };
}

/** Whether the filters of a drawing of so many pixels take no longer than they may. */
export const canFilter = ({ filters }: SvgCost, width: number, height: number): boolean =>
  weightOfFilters(filters, width, height) <= MOST_WEIGHT;

/** Whether the whole drawing does. */
export const canDraw = ({ filters, shapes }: SvgCost, width: number, height: number): boolean =>
  weightOfFilters(filters, width, height) + weightOfShapes(shapes, width, height) <= MOST_WEIGHT;

/** Whether an outline does, filled and stroked at any size. `heights`: its length, in heights of the picture. */
export const canOutline = (points: number, heights: number): boolean => weightOfOutline(points, heights) <= MOST_WEIGHT;

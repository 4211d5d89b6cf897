/** How long an SVG's filters take: a few bytes can ask for hours. Weights as of svg-cost.ts. */
import type { DefinitionUse } from "./svg-definitions.ts";
import {
  type Bounds,
  idsIn,
  moved,
  numbersOf,
  rectangleOf,
  type SvgElement,
  type SvgElements,
  scaleOf,
  sidesOf,
} from "./svg-elements.ts";

/** What one filter of a document comes to. */
export interface FilterUse {
  /** For each pixel, whatever its size. */
  readonly weight: number;
  /** How often it is drawn. */
  readonly times: number;
  /** The pixels that it goes over, in pictures; those beside the picture too. */
  readonly area: number;
  /** Radii of a "morphology", of the picture's width: each pixel looks at all pixels within. */
  readonly windows: readonly (readonly [number, number])[];
}

/** However small it is. */
const FILTER = 5000;
const PASS = 50;
const WEIGHTS: Readonly<Record<string, number>> = { GaussianBlur: 200, DropShadow: 400 };
const LIGHTING = 100;
const OCTAVE = 80;
const MATRIX_ENTRY = 4;
const WINDOW_PIXEL = 3;

interface Filter {
  readonly weight: number;
  /** As written. */
  readonly radii: readonly (readonly [number, number])[];
  /** Lengths of its primitives are shares of what is filtered. */
  readonly unitsAreBounds: boolean;
  readonly region: Bounds;
  /** The region is a share of what is filtered. */
  readonly regionIsOfBounds: boolean;
}

/** The filters that a document's parts ask for. */
export function filterUses(
  { elements, width, height }: SvgElements,
  definitions: ReadonlyMap<string, DefinitionUse>,
): FilterUse[] {
  const filters = filtersAmong(elements);
  if (filters.size === 0) return [];
  return elements.flatMap(({ attributes, matrix, definition, bounds }) => {
    const { times, scale } = definitions.get(definition) ?? { times: 0, scale: 0 };
    if (times === 0) return [];
    return idsIn(attributes.get("filter")).flatMap((id) => {
      const filter = filters.get(id);
      if (filter === undefined) return [];
      const filtered = bounds ?? [0, 0, width, height];
      const [x0, y0, x1, y1] = moved(matrix, regionOf(filter, filtered));
      const area = ((x1 - x0) / width) * ((y1 - y0) / height) * scale ** 2;
      const [unitX, unitY] = filter.unitsAreBounds ? sidesOf(filtered) : [1, 1];
      const share = (scaleOf(matrix) * scale) / width;
      const windows = filter.radii.map(([x, y]) => [x * unitX * share, y * unitY * share] as const);
      return [{ weight: filter.weight, times, area, windows }];
    });
  });
}

/** Of a drawing of so many pixels. */
export function weightOfFilters(uses: readonly FilterUse[], width: number, height: number): number {
  let weight = 0;
  for (const use of uses) {
    let each = use.weight;
    for (const [x, y] of use.windows) {
      // A window reaches no further than what the filter goes over.
      const most = 2 * Math.max(1, use.area);
      each += WINDOW_PIXEL * Math.min(2 * x * width + 1, width * most) * Math.min(2 * y * width + 1, height * most);
    }
    weight += use.times * (FILTER + use.area * each * width * height);
  }
  return weight;
}

/** By id. Their primitives come before them. */
function filtersAmong(elements: readonly SvgElement[]): Map<string, Filter> {
  const filters = new Map<string, Filter>();
  let weight = 0;
  let radii: [number, number][] = [];
  for (const { name, attributes } of elements) {
    if (name === "filter") {
      filters.set(attributes.get("id") ?? "", {
        weight,
        radii,
        unitsAreBounds: attributes.get("primitiveUnits") === "objectBoundingBox",
        region: rectangleOf(attributes),
        regionIsOfBounds: attributes.get("filterUnits") !== "userSpaceOnUse",
      });
      weight = 0;
      radii = [];
    }
    if (!/^fe[A-Z]/.test(name)) continue;
    const kind = name.slice(2);
    const numbers = (of: string): number[] => numbersOf(attributes.get(of) ?? "");
    if (kind === "Turbulence") weight += OCTAVE * (numbers("numOctaves")[0] ?? 1);
    else if (kind === "ConvolveMatrix")
      weight += MATRIX_ENTRY * numbers("order").reduce((area, side) => area * side, 1);
    else if (kind === "Morphology") {
      const [x = 0, y = x] = numbers("radius");
      radii.push([x, y]);
    } else weight += WEIGHTS[kind] ?? (kind.endsWith("Lighting") ? LIGHTING : PASS);
  }
  return filters;
}

/** What the filter goes over, in the units of what is filtered. */
function regionOf({ region, regionIsOfBounds }: Filter, filtered: Bounds): Bounds {
  const [width, height] = sidesOf(filtered);
  return regionIsOfBounds ? moved([width, 0, 0, height, filtered[0], filtered[1]], region) : region;
}

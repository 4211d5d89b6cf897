/**
 * How long an SVG's filters would take, told from the document and not by the clock, so that every machine draws the same:
 * a few bytes can ask for hours. Weights are about ten nanoseconds each, measured with resvg in WebAssembly.
 */
import {
  attribute,
  type Bounds,
  type FilteredGroup,
  layoutOf,
  moved,
  numbersOf,
  rectangleOf,
  scaleOf,
  sidesOf,
} from "./svg-layout.ts";

/** What one filter of a document comes to. */
export interface FilterUse {
  /** For each pixel, whatever its size. */
  readonly weight: number;
  /** How often it is drawn. */
  readonly times: number;
  /** The pixels that it goes over, in pictures: at least one, though for a small part they are fewer. */
  readonly area: number;
  /** Radii of a "morphology", of the picture's width: each pixel looks at all pixels within. */
  readonly windows: readonly (readonly [number, number])[];
}

/** Of one drawing: some seconds on a usual machine. */
const MOST_WEIGHT = 2.5e9;
const PASS = 50;
const WEIGHTS: Readonly<Record<string, number>> = { GaussianBlur: 200, DropShadow: 400 };
const LIGHTING = 100;
const OCTAVE = 80;
const MATRIX_ENTRY = 4;
const WINDOW_PIXEL = 3;

/** The filters that a document's parts ask for, each as often as it is asked for. `simplified` as for layoutOf. */
export function filterUses(simplified: string): FilterUse[] {
  const filters = new Map<string, Filter>();
  for (const [, attributes = "", body = ""] of simplified.matchAll(/<filter\b([^>]*)>([\s\S]*?)<\/filter>/g)) {
    filters.set(attribute(attributes, "id"), filterOf(attributes, body));
  }
  if (filters.size === 0) return [];
  const layout = layoutOf(simplified);
  // Patterns and masks stand in the definitions, and are drawn wherever they are asked for, as large as anything there.
  const references = 1 + (simplified.match(/(?:fill|stroke|mask|clip-path)="url\(#/g)?.length ?? 0);
  return layout.filtered.flatMap((group) => {
    const enlarged = group.isDefinition ? layout.scaleOfDefinitions : 1;
    const times = group.isDefinition ? references : 1;
    return group.filters.flatMap((id) => {
      const filter = filters.get(id);
      if (filter === undefined) return [];
      const [x0, y0, x1, y1] = moved(group.matrix, regionOf(filter, group));
      const area = ((x1 - x0) / layout.width) * ((y1 - y0) / layout.height) * enlarged ** 2;
      const [unitX, unitY] = filter.unitsAreBounds ? sidesOf(group.bounds) : [1, 1];
      const scale = (scaleOf(group.matrix) * enlarged) / layout.width;
      const windows = filter.radii.map(([x, y]) => [x * unitX * scale, y * unitY * scale] as const);
      return [{ weight: filter.weight, times, area: Math.max(1, area), windows }];
    });
  });
}

/** Whether a drawing of so many pixels takes no longer than it may. */
export function canFilter(uses: readonly FilterUse[], width: number, height: number): boolean {
  let weight = 0;
  for (const use of uses) {
    let each = use.weight;
    for (const [x, y] of use.windows) {
      // A window reaches no further than what the filter goes over.
      const across = Math.min(2 * x * width + 1, 2 * width * use.area);
      each += WINDOW_PIXEL * across * Math.min(2 * y * width + 1, 2 * height * use.area);
    }
    weight += use.times * use.area * each;
  }
  return weight * width * height <= MOST_WEIGHT;
}

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

function filterOf(attributes: string, body: string): Filter {
  let weight = 0;
  const radii: [number, number][] = [];
  for (const [, kind = "", of = ""] of body.matchAll(/<fe([A-Z]\w*)([^>]*)>/g)) {
    const numbers = (name: string): number[] => numbersOf(attribute(of, name));
    if (kind === "Turbulence") weight += OCTAVE * (numbers("numOctaves")[0] ?? 1);
    else if (kind === "ConvolveMatrix")
      weight += MATRIX_ENTRY * numbers("order").reduce((area, side) => area * side, 1);
    else if (kind === "Morphology") {
      const [x = 0, y = x] = numbers("radius");
      radii.push([x, y]);
    } else weight += WEIGHTS[kind] ?? (kind.endsWith("Lighting") ? LIGHTING : PASS);
  }
  return {
    weight,
    radii,
    unitsAreBounds: attribute(attributes, "primitiveUnits") === "objectBoundingBox",
    region: rectangleOf(attributes),
    regionIsOfBounds: attribute(attributes, "filterUnits") !== "userSpaceOnUse",
  };
}

/** What the filter goes over, in the group's units. */
function regionOf({ region, regionIsOfBounds }: Filter, { bounds }: FilteredGroup): Bounds {
  const [width, height] = sidesOf(bounds);
  return regionIsOfBounds ? moved([width, 0, 0, height, bounds[0], bounds[1]], region) : region;
}

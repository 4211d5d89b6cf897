/**
 * How long an SVG's filters would take, told from the document and not by the clock, so that every machine draws the same:
 * a few bytes can ask for hours. Weights are about ten nanoseconds each, measured with resvg in WebAssembly.
 */

/** What the filters of a document come to. */
export interface FilterUse {
  /** For each pixel, whatever its size. */
  readonly weight: number;
  /** How often it is drawn. */
  readonly times: number;
  /** Radii of a "morphology", of the drawing's width: each pixel looks at all pixels within. */
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

/**
 * The filters that a document's parts ask for, each as often as it is asked for.
 *
 * @param simplified as resvg writes a document out: nothing reused, no styles, numbers for all
 * @param size the document's own width and height
 */
export function filterUses(simplified: string, size: { readonly width: number; readonly height: number }): FilterUse[] {
  const filters = new Map<string, FilterUse>();
  for (const [, id = "", attributes = "", body = ""] of simplified.matchAll(
    /<filter id="([^"]*)"([^>]*)>([\s\S]*?)<\/filter>/g,
  )) {
    filters.set(id, useOf(body, attributes.includes('primitiveUnits="objectBoundingBox"') ? 1 : 1 / size.width));
  }
  if (filters.size === 0) return [];
  const uses: FilterUse[] = [];
  // Patterns and masks stand in the definitions, and are drawn wherever they are asked for.
  const definitionsEnd = simplified.lastIndexOf("</defs>");
  const references = 1 + (simplified.match(/(?:fill|stroke|mask|clip-path)="url\(#/g)?.length ?? 0);
  const scales = [1];
  for (const match of simplified.matchAll(/<(\/?)([\w-]+)([^>]*?)(\/?)>/g)) {
    const [, closes, , attributes = "", empty] = match;
    if (closes) {
      scales.pop();
      continue;
    }
    const scale = (scales.at(-1) ?? 1) * scaleOf(attributes);
    if (!empty) scales.push(scale);
    const asked = /\bfilter="([^"]*)"/.exec(attributes)?.[1] ?? "";
    for (const [, id = ""] of asked.matchAll(/url\(#([^)]*)\)/g)) {
      const filter = filters.get(id);
      if (filter === undefined) continue;
      const times = match.index < definitionsEnd ? references : 1;
      const windows = filter.windows.map(([x, y]) => [x * scale, y * scale] as const);
      uses.push({ weight: filter.weight, times, windows });
    }
  }
  return uses;
}

/** Whether a drawing of so many pixels takes no longer than it may. */
export function canFilter(uses: readonly FilterUse[], width: number, height: number): boolean {
  let weight = 0;
  for (const use of uses) {
    weight += use.times * use.weight;
    for (const [x, y] of use.windows) {
      // A window reaches no further than the picture.
      weight +=
        use.times * WINDOW_PIXEL * Math.min(2 * x * width + 1, 2 * width) * Math.min(2 * y * width + 1, 2 * height);
    }
  }
  return weight * width * height <= MOST_WEIGHT;
}

function useOf(body: string, unit: number): FilterUse {
  let weight = 0;
  const windows: [number, number][] = [];
  for (const [, kind = "", attributes = ""] of body.matchAll(/<fe([A-Z]\w*)([^>]*)>/g)) {
    const numbers = (name: string): number[] =>
      (new RegExp(`\\b${name}="([^"]*)"`).exec(attributes)?.[1] ?? "").split(/[\s,]+/).map(Number);
    if (kind === "Turbulence") weight += OCTAVE * (numbers("numOctaves")[0] ?? 1);
    else if (kind === "ConvolveMatrix")
      weight += MATRIX_ENTRY * numbers("order").reduce((area, side) => area * side, 1);
    else if (kind === "Morphology") {
      const [x = 0, y = x] = numbers("radius");
      windows.push([x * unit, y * unit]);
    } else weight += WEIGHTS[kind] ?? (kind.endsWith("Lighting") ? LIGHTING : PASS);
  }
  return { weight, times: 1, windows };
}

/** How much a transform enlarges at the most. */
function scaleOf(attributes: string): number {
  const transform = /\btransform="matrix\(([^)]*)\)"/.exec(attributes)?.[1];
  if (transform === undefined) return 1;
  const [a = 1, b = 0, c = 0, d = 1] = transform
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  return Math.max(Math.hypot(a, b), Math.hypot(c, d));
}

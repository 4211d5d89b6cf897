/** Where a drawing's filtered parts lie: as much of its layout as tells how many pixels their filters go over. */

export interface FilteredGroup {
  /** The ids of its filters. */
  readonly filters: readonly string[];
  /** Of what is in it, strokes left out, in its own units; the picture's where that is nothing. */
  readonly bounds: Bounds;
  /** From its own units to the document's. */
  readonly matrix: Matrix;
  /** It is part of a pattern or a mask, which is drawn in the units of what asks for it, wherever that is. */
  readonly isDefinition: boolean;
}

export interface SvgLayout {
  /** Of the picture, in the document's units. */
  readonly width: number;
  readonly height: number;
  readonly filtered: readonly FilteredGroup[];
  /** How much what is in a pattern or a mask is enlarged where it is asked for, at the most. */
  readonly scaleOfDefinitions: number;
}

/** Least x and y, greatest x and y. */
export type Bounds = readonly [number, number, number, number];
/** As SVG's matrix(a b c d e f). */
export type Matrix = readonly [number, number, number, number, number, number];

const SAME: Matrix = [1, 0, 0, 1, 0, 0];

interface OpenElement {
  readonly attributes: string;
  /** To the units of the element around it, and to the document's. */
  readonly own: Matrix;
  readonly matrix: Matrix;
  readonly isDefinition: boolean;
  bounds: Bounds | null;
}

/** @param simplified as resvg writes a document out: nothing reused, no styles, numbers for all, paths of absolute places */
export function layoutOf(simplified: string): SvgLayout {
  const [, , width = 1, height = 1] = numbersOf(attribute(/<svg\b([^>]*)>/.exec(simplified)?.[1] ?? "", "viewBox"));
  const filtered: FilteredGroup[] = [];
  const open: OpenElement[] = [];
  let largestScale = 1;
  let longestSide = 1;
  // Of patterns and masks: as a number, and as a share of what asks for them.
  let plainScale = 1;
  let shareScale = 0;
  const end = ({ attributes, own, matrix, isDefinition, bounds }: OpenElement): void => {
    const filters = [...attribute(attributes, "filter").matchAll(/url\(#([^)]*)\)/g)].map(([, id = ""]) => id);
    if (filters.length > 0) filtered.push({ filters, bounds: bounds ?? [0, 0, width, height], matrix, isDefinition });
    if (bounds === null) return;
    longestSide = Math.max(longestSide, ...sidesOf(bounds));
    const around = open.at(-1);
    if (around) around.bounds = united(around.bounds, moved(own, bounds));
  };
  for (const [, closes, name = "", attributes = "", isEmpty] of simplified.matchAll(/<(\/?)([\w-]+)([^>]*?)(\/?)>/g)) {
    if (closes) {
      const ended = open.pop();
      if (ended) end(ended);
      continue;
    }
    const around = open.at(-1);
    const own = matrixOf(attribute(attributes, "transform") || attribute(attributes, "patternTransform"));
    const matrix = product(around?.matrix ?? SAME, own);
    largestScale = Math.max(largestScale, scaleOf(matrix));
    if (name === "pattern" || name === "mask") {
      const { scale, isShare } = definitionScale(name, attributes);
      if (isShare) shareScale = Math.max(shareScale, scale);
      else plainScale = Math.max(plainScale, scale);
    }
    const isDefinition = name === "defs" || (around?.isDefinition ?? false);
    const element = { attributes, own, matrix, isDefinition, bounds: boundsOf(name, attributes) };
    if (isEmpty) end(element);
    else open.push(element);
  }
  const scaleOfDefinitions = largestScale * Math.max(plainScale, shareScale * longestSide);
  return { width, height, filtered, scaleOfDefinitions };
}

/** How much a pattern or mask enlarges what is in it; `isShare`: for each unit of length of what asks for it. */
function definitionScale(name: string, attributes: string): { scale: number; isShare: boolean } {
  const [, , width = 0, height = 0] = numbersOf(attribute(attributes, "viewBox"));
  const fitted = width > 0 && height > 0 && name === "pattern";
  const scale = fitted
    ? Math.max(Number(attribute(attributes, "width")) / width, Number(attribute(attributes, "height")) / height)
    : 1;
  const isShare = fitted
    ? attribute(attributes, "patternUnits") !== "userSpaceOnUse"
    : attribute(attributes, `${name}ContentUnits`) === "objectBoundingBox";
  return { scale, isShare };
}

/** The rectangle around a rectangle in other units. */
export function moved([a, b, c, d, e, f]: Matrix, [x0, y0, x1, y1]: Bounds): Bounds {
  const xs = [x0, x1].flatMap((x) => [y0, y1].map((y) => a * x + c * y + e));
  const ys = [x0, x1].flatMap((x) => [y0, y1].map((y) => b * x + d * y + f));
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

export const sidesOf = ([x0, y0, x1, y1]: Bounds): [width: number, height: number] => [x1 - x0, y1 - y0];

/** How much a matrix enlarges a unit of length at the most. */
export const scaleOf = ([a, b, c, d]: Matrix): number => Math.max(Math.hypot(a, b), Math.hypot(c, d));

export const attribute = (attributes: string, name: string): string =>
  new RegExp(`\\s${name}="([^"]*)"`).exec(attributes)?.[1] ?? "";

export const numbersOf = (list: string): number[] => (list.match(/[-+]?[\d.]+(?:e[-+]?\d+)?/gi) ?? []).map(Number);

/** By an element's own x, y, width and height. */
export function rectangleOf(attributes: string): Bounds {
  const [x = 0, y = 0, width = 0, height = 0] = ["x", "y", "width", "height"].map((name) =>
    Number(attribute(attributes, name)),
  );
  return [x, y, x + width, y + height];
}

function boundsOf(name: string, attributes: string): Bounds | null {
  if (name === "image") return rectangleOf(attributes);
  if (name !== "path") return null;
  // A curve stays within its control points.
  const places = numbersOf(attribute(attributes, "d"));
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let at = 0; at + 1 < places.length; at += 2) {
    const [x = 0, y = 0] = [places[at], places[at + 1]];
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  }
  return x0 <= x1 ? [x0, y0, x1, y1] : null;
}

function matrixOf(transform: string): Matrix {
  const [a, b, c, d, e, f] = numbersOf(transform.replace(/^matrix/, ""));
  return f === undefined ? SAME : [a ?? 1, b ?? 0, c ?? 0, d ?? 1, e ?? 0, f];
}

const product = ([a, b, c, d, e, f]: Matrix, [g, h, i, j, k, l]: Matrix): Matrix => [
  a * g + c * h,
  b * g + d * h,
  a * i + c * j,
  b * i + d * j,
  a * k + c * l + e,
  b * k + d * l + f,
];

const united = (a: Bounds | null, b: Bounds): Bounds =>
  a === null ? b : [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];

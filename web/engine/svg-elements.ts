/** The elements of a simplified drawing, and where they lie. */
import { tagsOf } from "./xml-tags.ts";

export interface SvgElement {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  /** From its own units to those of its definition; where it has none, to the document's with the picture's corner at 0. */
  readonly matrix: Matrix;
  /** The id of the pattern, mask or clip path that it is, or is part of; "" in the document itself. */
  readonly definition: string;
  /** Of what is in it, strokes left out, in its own units; null of nothing. */
  readonly bounds: Bounds | null;
  /** The same with strokes. */
  readonly painted: Bounds | null;
  /** Of a path. */
  readonly outline: Outline | null;
  /** Where it begins in the text, and where what follows it does. */
  readonly start: number;
  readonly end: number;
}

export interface Outline {
  /** With those that control curves. */
  readonly points: number;
  /** Along all points: no less than the path's own. */
  readonly length: number;
}

export interface SvgElements {
  /** Of the picture, in the document's units. */
  readonly width: number;
  readonly height: number;
  /** What is in an element comes before it. */
  readonly elements: readonly SvgElement[];
}

/** Least x and y, greatest x and y. */
export type Bounds = readonly [number, number, number, number];
/** As SVG's matrix(a b c d e f). */
export type Matrix = readonly [number, number, number, number, number, number];

export const DEFINITIONS: ReadonlySet<string> = new Set(["pattern", "mask", "clipPath"]);
const SAME: Matrix = [1, 0, 0, 1, 0, 0];

interface OpenElement extends SvgElement {
  /** To the units of the element around it. */
  readonly own: Matrix;
  end: number;
  bounds: Bounds | null;
  painted: Bounds | null;
}

/** @param simplified as resvg writes a document out: nothing reused, no styles, numbers for all, paths of absolute places */
export function elementsOf(simplified: string): SvgElements {
  const elements: SvgElement[] = [];
  const open: OpenElement[] = [];
  let page: Bounds = [0, 0, 1, 1];
  const end = (element: OpenElement): void => {
    elements.push(element);
    const around = open.at(-1);
    if (!around) return;
    const { own, bounds, painted } = element;
    if (bounds) around.bounds = united(around.bounds, moved(own, bounds));
    if (painted) around.painted = united(around.painted, moved(own, painted));
  };
  for (const { name, kind, attributes, start, length } of tagsOf(simplified)) {
    if (kind === "end") {
      const ended = open.pop();
      if (ended) end({ ...ended, end: start + length });
      continue;
    }
    if (name === "svg") page = pageOf(attributes);
    const around = open.at(-1);
    const own = matrixOf(attributes.get("transform") ?? attributes.get("patternTransform") ?? "");
    const matrix = product(around?.matrix ?? [1, 0, 0, 1, -page[0], -page[1]], own);
    const definition = DEFINITIONS.has(name) ? (attributes.get("id") ?? "") : (around?.definition ?? "");
    const { outline, bounds } = shapeOf(name, attributes);
    const painted = bounds && withStroke(bounds, attributes);
    const place = { start, end: start + length };
    const element = { name, attributes, own, matrix, definition, outline, bounds, painted, ...place };
    if (kind === "empty") end(element);
    else open.push(element);
  }
  const [width, height] = sidesOf(page);
  return { width, height, elements };
}

/** What the picture shows, in the document's units: its view box, and what is beside that where its proportions differ. */
function pageOf(attributes: ReadonlyMap<string, string>): Bounds {
  const [x = 0, y = 0, width = 1, height = 1] = numbersOf(attributes.get("viewBox") ?? "");
  const [scaleX, scaleY] = [Number(attributes.get("width")) / width, Number(attributes.get("height")) / height];
  const [, alignX, alignY, isSlice] =
    /^x(M[a-z]+)Y(M[a-z]+)(\s+slice)?/.exec(attributes.get("preserveAspectRatio") ?? "xMidYMid") ?? [];
  // Without an alignment it is stretched.
  if (!(scaleX > 0 && scaleY > 0) || alignX === undefined) return [x, y, x + width, y + height];
  const scale = isSlice ? Math.max(scaleX, scaleY) : Math.min(scaleX, scaleY);
  const [wide, high] = [(width * scaleX) / scale, (height * scaleY) / scale];
  const before = (align: string | undefined, rest: number): number =>
    align === "Min" ? 0 : align === "Max" ? rest : rest / 2;
  const [left, top] = [x - before(alignX, wide - width), y - before(alignY, high - height)];
  return [left, top, left + wide, top + high];
}

/** The ids that an attribute names as url(#id). */
export const idsIn = (value: string | undefined): string[] =>
  [...(value ?? "").matchAll(/url\(#([^)]*)\)/g)].map(([, id = ""]) => id);

/** The rectangle around a rectangle in other units. */
export function moved([a, b, c, d, e, f]: Matrix, [x0, y0, x1, y1]: Bounds): Bounds {
  const xs = [x0, x1].flatMap((x) => [y0, y1].map((y) => a * x + c * y + e));
  const ys = [x0, x1].flatMap((x) => [y0, y1].map((y) => b * x + d * y + f));
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** Width and height of a box. */
export const sidesOf = ([x0, y0, x1, y1]: Bounds): [width: number, height: number] => [x1 - x0, y1 - y0];

/** How much a matrix enlarges a unit of length at the most. */
export const scaleOf = ([a, b, c, d]: Matrix): number => Math.max(Math.hypot(a, b), Math.hypot(c, d));

/** The numbers in an attribute's list, whatever stands between them. */
export const numbersOf = (list: string): number[] => (list.match(/[-+]?[\d.]+(?:e[-+]?\d+)?/gi) ?? []).map(Number);

/** By an element's own x, y, width and height. */
export function rectangleOf(attributes: ReadonlyMap<string, string>): Bounds {
  const [x = 0, y = 0, width = 0, height = 0] = ["x", "y", "width", "height"].map((name) =>
    Number(attributes.get(name) ?? 0),
  );
  return [x, y, x + width, y + height];
}

/** 0 without a stroke. */
export function strokeWidthOf(attributes: ReadonlyMap<string, string>): number {
  const stroke = attributes.get("stroke");
  return stroke === undefined || stroke === "none" ? 0 : Number(attributes.get("stroke-width") ?? 1);
}

function withStroke([x0, y0, x1, y1]: Bounds, attributes: ReadonlyMap<string, string>): Bounds {
  const reach = strokeWidthOf(attributes) / 2;
  return [x0 - reach, y0 - reach, x1 + reach, y1 + reach];
}

function shapeOf(
  name: string,
  attributes: ReadonlyMap<string, string>,
): { readonly bounds: Bounds | null; readonly outline: Outline | null } {
  if (name === "image") return { bounds: rectangleOf(attributes), outline: null };
  if (name !== "path") return { bounds: null, outline: null };
  // A curve stays within its control points.
  const places = numbersOf(attributes.get("d") ?? "");
  const points = places.length >> 1;
  let [x0, y0, x1, y1, length] = [Infinity, Infinity, -Infinity, -Infinity, 0];
  for (let at = 0; at + 1 < places.length; at += 2) {
    const [x = 0, y = 0] = [places[at], places[at + 1]];
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
    if (at > 0) length += Math.hypot(x - (places[at - 2] ?? 0), y - (places[at - 1] ?? 0));
  }
  return { bounds: x0 <= x1 ? [x0, y0, x1, y1] : null, outline: { points, length } };
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

/**
 * How long an SVG's shapes, groups and pictures take. Weights as of svg-cost.ts, measured for each kind at 64, 512 and 2048
 * pixels.
 */
import type { DefinitionUse } from "./svg-definitions.ts";
import {
  idsIn,
  moved,
  numbersOf,
  type Outline,
  type SvgElement,
  type SvgElements,
  scaleOf,
  sidesOf,
  strokeWidthOf,
} from "./svg-elements.ts";

/** What shapes come to at any size. */
export interface ShapeCost {
  readonly perPixel: number;
  /** For each row of pixels. */
  readonly perRow: number;
  readonly once: number;
}

export const NO_SHAPES: ShapeCost = { perPixel: 0, perRow: 0, once: 0 };

const OPAQUE = 0.4;
const TRANSLUCENT = 2;
const GRADIENT = 6;
const PATTERN = 10;
const IMAGE = 6;
/** What is drawn apart, and then laid on the rest. */
const GROUP = 12;
const CUT_OUT = 12;
const SHAPE = 400;
const EDGE = 80;
/** An edge that goes through a row. */
const EDGE_ROW = 1.2;
/** Each edge is put in its place among all that begin in the same rows. */
const EDGE_PAIR = 0.01;
/** A stroke's outline goes along both sides, with joins. */
const STROKE_EDGES = 6;

/** @param costOfPicture what a picture's or a drawing's data comes to by itself, where it fills the picture */
export function costOfShapes(
  { elements, width, height }: SvgElements,
  definitions: ReadonlyMap<string, DefinitionUse>,
  costOfPicture: (data: string) => ShapeCost,
): ShapeCost {
  let [perPixel, perRow, once] = [0, 0, 0];
  for (const element of elements) {
    const use = definitions.get(element.definition);
    if (use === undefined || use.times === 0) continue;
    const share = shareOf(element, use, width, height);
    if (share === 0) continue;
    const { attributes, name, outline } = element;
    if (outline !== null) {
      const edges = edgesOf(element, outline, (scaleOf(element.matrix) * use.scale) / height);
      for (const paint of ["fill", "stroke"] as const) {
        perPixel += use.times * share * weightOfPaint(attributes, paint, definitions);
      }
      perRow += use.times * EDGE_ROW * edges.heights;
      once += use.times * (SHAPE + weightOfEdges(edges.count, edges.heights));
    } else if (name === "image") {
      const picture = costOfPicture(attributes.get("href") ?? "");
      perPixel += use.times * share * (IMAGE + picture.perPixel);
      perRow += use.times * picture.perRow;
      once += use.times * (SHAPE + picture.once);
    }
    perPixel += use.times * share * weightOfGroup(attributes);
  }
  return { perPixel, perRow, once };
}

/** Of an outline that is filled and stroked. `heights`: its length, in heights of the picture. */
export const weightOfOutline = (points: number, heights: number): number =>
  weightOfEdges(points * (1 + STROKE_EDGES), heights * 3);

const weightOfEdges = (count: number, heights: number): number => count * (EDGE + EDGE_PAIR * heights);

/** What a cost comes to in a picture of that many pixels. */
export const weightOfShapes = ({ perPixel, perRow, once }: ShapeCost, width: number, height: number): number =>
  perPixel * width * height + perRow * height + once;

/** The pixels that it covers at the most, in pictures: in the document itself, those of the picture. */
function shareOf(
  { painted, matrix, definition }: SvgElement,
  use: DefinitionUse,
  width: number,
  height: number,
): number {
  if (painted === null) return 0;
  const around = moved(matrix, painted);
  if (definition !== "") {
    const [wide, high] = sidesOf(around);
    return Math.min(use.area, (wide * high * use.scale ** 2) / (width * height));
  }
  const [x0, y0, x1, y1] = around;
  const wide = Math.min(x1, width) - Math.max(x0, 0);
  const high = Math.min(y1, height) - Math.max(y0, 0);
  return wide > 0 && high > 0 ? (wide * high) / (width * height) : 0;
}

function weightOfPaint(
  attributes: ReadonlyMap<string, string>,
  name: "fill" | "stroke",
  definitions: ReadonlyMap<string, DefinitionUse>,
): number {
  const paint = attributes.get(name) ?? "none";
  if (paint === "none") return 0;
  const [server] = idsIn(paint);
  if (server !== undefined) return definitions.has(server) ? PATTERN : GRADIENT;
  return Number(attributes.get(`${name}-opacity`) ?? 1) < 1 ? TRANSLUCENT : OPAQUE;
}

function weightOfGroup(attributes: ReadonlyMap<string, string>): number {
  const cutOuts = idsIn(attributes.get("mask")).length + idsIn(attributes.get("clip-path")).length;
  return (isDrawnApart(attributes) ? GROUP : 0) + cutOuts * CUT_OUT;
}

const APART = ["mask", "clip-path", "opacity", "filter", "style"];

/** Whether what has these attributes is drawn by itself, and then laid on the rest. */
export const isDrawnApart = (attributes: ReadonlyMap<string, string>): boolean =>
  APART.some((name) => attributes.has(name));

/** @param rows of a unit of length, of the picture's height */
function edgesOf(
  { attributes }: SvgElement,
  { points, length }: Outline,
  rows: number,
): { readonly count: number; readonly heights: number } {
  // No edge is drawn beyond the picture.
  const heightsOf = (edges: number, along: number): number => Math.min(along * rows, edges);
  let count = points;
  let heights = heightsOf(points, length);
  const strokeWidth = strokeWidthOf(attributes);
  if (strokeWidth > 0) {
    const dashes = numbersOf(attributes.get("stroke-dasharray") ?? "");
    const period = dashes.reduce((sum, dash) => sum + dash, 0);
    // Of more than a million dashes the renderer draws none, and does not say so: they count too, and are refused.
    const dashed = period > 0 ? ((length / period) * dashes.length) / 2 : 0;
    const parts = points + dashed;
    const edges = parts * STROKE_EDGES;
    count += edges;
    heights += heightsOf(edges, 2 * (length + parts * strokeWidth));
  }
  return { count, heights };
}

/** Paints a base texture as SVG, chart by chart, each in the metres of its own pattern. */

import type { Atlas, PlacedChart } from "../geometry/atlas.ts";
import { type Picture, renderSvg } from "./svg.ts";

export interface AtlasPainting {
  /** Where no chart lies. */
  readonly background: string;
  /** SVG definitions (gradients) that the charts' drawings share. */
  readonly definitions?: string;
  /** Texels; the atlas's own width by default. */
  readonly outputWidth?: number;
  /**
   * SVG of one chart, in metres of its pattern. It may draw past the pattern's edges: half of the spacing to the next
   * chart is kept, so that filtering finds the right colour beyond a seam.
   */
  readonly paintChart: (placed: PlacedChart) => string;
}

export function paintAtlas(atlas: Atlas, painting: AtlasPainting): Promise<Picture> {
  const { width, height } = atlas;
  const margin = atlas.spacing / 2;
  const clips: string[] = [];
  const groups: string[] = [];
  atlas.charts.forEach((placed, index) => {
    const x = placed.x - margin;
    const y = placed.y - margin;
    const clipWidth = placed.width + 2 * margin;
    const clipHeight = placed.height + 2 * margin;
    clips.push(
      `<clipPath id="chart${index}"><rect x="${x}" y="${y}" width="${clipWidth}" height="${clipHeight}"/></clipPath>`,
    );
    const scale = placed.texelsPerMetre;
    const toTexels = `translate(${placed.x} ${placed.y}) scale(${scale}) translate(${-placed.flatMin[0]} ${-placed.flatMin[1]})`;
    groups.push(`<g clip-path="url(#chart${index})"><g transform="${toTexels}">${painting.paintChart(placed)}</g></g>`);
  });
  return renderSvg(
    `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">
<defs>${painting.definitions ?? ""}${clips.join("")}</defs>
<rect width="${width}" height="${height}" fill="${painting.background}"/>
${groups.join("\n")}
</svg>`,
    painting.outputWidth ?? width,
  );
}

/** A rectangle over a chart's whole pattern and its margin. */
export function fillChart(placed: PlacedChart, fill: string): string {
  return fillBox(placed, fill, 0, 1);
}

/** A stripe over the pattern's full width, between two heights given as shares from the top. */
export function fillBox(placed: PlacedChart, fill: string, from: number, to: number): string {
  const { flatMin, flatMax, texelsPerMetre } = placed;
  const margin = 64 / texelsPerMetre;
  const height = flatMax[1] - flatMin[1];
  const top = from <= 0 ? flatMin[1] - margin : flatMin[1] + height * from;
  const bottom = to >= 1 ? flatMax[1] + margin : flatMin[1] + height * to;
  const width = flatMax[0] - flatMin[0] + 2 * margin;
  return `<rect x="${flatMin[0] - margin}" y="${top}" width="${width}" height="${bottom - top}" fill="${fill}"/>`;
}

/** The benchmark's picture: time against the texture's size and against texels painted, ours and the plain method's. */
import type { Circumstances, Row } from "../report.ts";
import {
  drawLegend,
  drawPanel,
  drawSvg,
  PANEL_HEIGHT,
  PANEL_WIDTH,
  type Panel,
  type Series,
  text,
} from "./line-plot.ts";

export interface PlotInput extends Circumstances {
  readonly rounds: number;
  readonly rows: readonly Row[];
}

/** Told apart by most kinds of colour blindness (Okabe and Ito). */
const LOOKS = [
  { name: "plain method, native", color: "#d55e00", mark: "M-4.5-4.5h9v9h-9z" },
  { name: "plain method, WebAssembly", color: "#8a8f98", mark: "M0-6L5.5 4.5h-11z" },
  { name: "Texelcast", color: "#0072b2", mark: "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0" },
];
const PAINTING = ["local1", "local10", "whole"];
const MARGIN = 16;
const HEADER = 74;

/** An SVG, a row of panels for each mesh; null where no line would have a point. */
export function plotFigures(input: PlotInput): string | null {
  const meshes = [...new Set(input.rows.map(({ mesh }) => mesh))];
  const rows = meshes
    .map((mesh) => panelsOf(input.rows.filter((row) => row.mesh === mesh)))
    .filter((row) => row.length);
  if (rows.length === 0) return null;
  const width = MARGIN * 2 + PANEL_WIDTH * Math.max(...rows.map(({ length }) => length));
  const height = HEADER + rows.length * PANEL_HEIGHT + MARGIN;
  const { machine, versions, date, rounds } = input;
  const origin = `${date.slice(0, 10)}, ${versions.texelcast}, node ${versions.node}, ${machine}`;
  return drawSvg("Time of a bake and of a step of a drag, Texelcast and the plain method", width, height, [
    text(
      MARGIN,
      24,
      `Median of ${rounds} rounds, one thread each; bars from the shortest to the longest`,
      `font-size="15"`,
    ),
    text(MARGIN, 42, origin, `fill="#5a616c"`),
    drawLegend(LOOKS, MARGIN, 60),
    ...rows.flatMap((panels, row) =>
      panels.map((panel, column) => drawPanel(panel, MARGIN + column * PANEL_WIDTH, HEADER + row * PANEL_HEIGHT)),
    ),
  ]);
}

/** Of one mesh. */
function panelsOf(rows: readonly Row[]): Panel[] {
  const mesh = rows[0].mesh;
  const sizes = [...new Set(rows.map(({ size }) => size))];
  const middle = sizes.includes(2048) ? 2048 : sizes[0];
  const bySize = { xTitle: "texture, texels along a side", xTicks: sizes, formatX: (size: number) => `${size}²` };
  const bakes = rows.filter(({ work }) => work === "bake");
  const drags = rows.filter(({ work }) => work === "local10");
  const painted = rows.filter(({ work, size }) => PAINTING.includes(work) && size === middle);
  const yValues = [...bakes, ...drags, ...painted].flatMap(({ min, max }) => [min, max]);
  const shared = { yTitle: "milliseconds", yValues, formatY: (value: number) => String(Number(value.toPrecision(2))) };
  const panels: Panel[] = [
    { ...shared, ...bySize, title: `Bake, ${mesh}`, series: seriesOf(bakes, ({ size }) => size) },
    { ...shared, ...bySize, title: `A step of a drag (local10), ${mesh}`, series: seriesOf(drags, ({ size }) => size) },
    {
      ...shared,
      title: `A step of a drag at ${middle}², ${mesh}`,
      xTitle: "texels painted (local1, local10, whole)",
      formatX: shortCount,
      series: seriesOf(painted, ({ texels }) => texels),
    },
  ];
  return panels.filter(({ series }) => series.length > 0);
}

function seriesOf(rows: readonly Row[], xOf: (row: Row) => number): Series[] {
  return LOOKS.map((look) => ({
    ...look,
    points: rows
      .filter(({ engine, texels }) => engine === look.name && texels > 0)
      .map((row) => ({ x: xOf(row), y: row.median, low: row.min, high: row.max }))
      .sort((a, b) => a.x - b.x),
  })).filter(({ points }) => points.length > 0);
}

/** 30 k, 1 M. */
function shortCount(count: number): string {
  if (count >= 1e6) return `${count / 1e6} M`;
  return count >= 1000 ? `${count / 1000} k` : String(count);
}

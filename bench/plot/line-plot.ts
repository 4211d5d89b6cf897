/** One panel of a plot as SVG: lines over two logarithmic axes, with the spread of each point. */
import { logScale } from "./log-scale.ts";

export interface Point {
  readonly x: number;
  readonly y: number;
  readonly low: number;
  readonly high: number;
}

export interface Series {
  readonly name: string;
  readonly color: string;
  /** SVG path of the mark around (0, 0): told apart without colours too. */
  readonly mark: string;
  readonly points: readonly Point[];
}

export interface Panel {
  readonly title: string;
  readonly xTitle: string;
  readonly yTitle: string;
  readonly series: readonly Series[];
  /** What the axes must reach at least, so that panels can be compared. */
  readonly yValues: readonly number[];
  /** Ticks of their own where the x values are steps and not measures. */
  readonly xTicks?: readonly number[];
  readonly formatX: (value: number) => string;
  readonly formatY: (value: number) => string;
}

export const PANEL_WIDTH = 400;
export const PANEL_HEIGHT = 330;
const INSET = { left: 62, right: 18, top: 34, bottom: 50 };
const INK = "#20242b";
const QUIET = "#5a616c";
const GRID = "#e3e6ea";

export function drawPanel(panel: Panel, x: number, y: number): string {
  const [left, right] = [INSET.left, PANEL_WIDTH - INSET.right];
  const [top, bottom] = [INSET.top, PANEL_HEIGHT - INSET.bottom];
  const xScale = logScale(
    panel.series.flatMap(({ points }) => points.map((point) => point.x)),
    left,
    right,
  );
  const yScale = logScale(panel.yValues, bottom, top);
  const parts = [text(left, 20, panel.title, `font-weight="600"`)];
  for (const tick of yScale.ticks) {
    const at = round(yScale.at(tick));
    parts.push(`<path d="M${left} ${at}H${right}" stroke="${GRID}"/>`);
    parts.push(text(left - 8, at + 4, panel.formatY(tick), `text-anchor="end" fill="${QUIET}"`));
  }
  for (const tick of panel.xTicks ?? xScale.ticks) {
    const at = round(xScale.at(tick));
    parts.push(`<path d="M${at} ${bottom}v5" stroke="${QUIET}"/>`);
    parts.push(text(at, bottom + 19, panel.formatX(tick), `text-anchor="middle" fill="${QUIET}"`));
  }
  parts.push(`<path d="M${left} ${top}V${bottom}H${right}" fill="none" stroke="${QUIET}"/>`);
  parts.push(text((left + right) / 2, PANEL_HEIGHT - 12, panel.xTitle, `text-anchor="middle" fill="${QUIET}"`));
  parts.push(
    text(
      0,
      0,
      panel.yTitle,
      `text-anchor="middle" fill="${QUIET}" transform="translate(16 ${(top + bottom) / 2}) rotate(-90)"`,
    ),
  );
  for (const { color, mark, points } of panel.series) {
    const places = points.map((point) => ({
      x: round(xScale.at(point.x)),
      y: round(yScale.at(point.y)),
      low: round(yScale.at(point.low)),
      high: round(yScale.at(point.high)),
    }));
    parts.push(
      ...places.map((place) => `<path d="M${place.x} ${place.low}V${place.high}" stroke="${color}" opacity="0.4"/>`),
      `<polyline points="${places.map((place) => `${place.x},${place.y}`).join(" ")}" fill="none" stroke="${color}" stroke-width="2"/>`,
      ...places.map((place) => `<path d="${mark}" transform="translate(${place.x} ${place.y})" fill="${color}"/>`),
    );
  }
  return `<g transform="translate(${x} ${y})">${parts.join("")}</g>`;
}

/** The names of the lines in a row. */
export function drawLegend(series: readonly Omit<Series, "points">[], x: number, y: number): string {
  const entries = series.map(
    ({ name, color, mark }, index) =>
      `<g transform="translate(${x + index * 220} ${y})"><path d="M0 0H26" stroke="${color}" stroke-width="2"/>` +
      `<path d="${mark}" transform="translate(13 0)" fill="${color}"/>${text(34, 4, name)}</g>`,
  );
  return entries.join("");
}

/** @param title what readers hear who do not see it */
export function drawSvg(title: string, width: number, height: number, parts: readonly string[]): string {
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"` +
    ` font-family="system-ui, sans-serif" font-size="12">\n<title>${escaped(title)}</title>\n` +
    `<rect width="${width}" height="${height}" fill="#fff"/>\n${parts.join("\n")}\n</svg>\n`
  );
}

export function text(x: number, y: number, words: string, attributes = ""): string {
  const fill = attributes.includes("fill=") ? "" : ` fill="${INK}"`;
  return `<text x="${round(x)}" y="${round(y)}"${fill} ${attributes}>${escaped(words)}</text>`;
}

function escaped(words: string): string {
  return words.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}

function round(pixels: number): number {
  return Math.round(pixels * 10) / 10;
}

/**
 * Words to outlines: lines shaped by HarfBuzz, set one below the other or bent along an arc. Glyphs come as paths, so that
 * whatever draws them needs no fonts, and a text's own characters never reach a drawing's markup. Only + - * / and square
 * roots, so that every engine sets a text alike (spec.md, 7).
 */
import type { Buffer as HarfBuzzBuffer } from "harfbuzzjs";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { EngineText } from "./engine-api.ts";
import { type Turn, turnBy } from "./exact-turn.ts";
import { canOutline } from "./svg-cost.ts";
import { type FontShelf, loadedHarfBuzz, type TextFont } from "./text-fonts.ts";
import { cleanText, missingCharacters, runsOf, type TextRun } from "./text-runs.ts";
import { takesSpacing } from "./text-script.ts";

/** What decides a text's shape. */
export type TextStyle = Pick<EngineText, "text" | "font" | "letterSpacing" | "align" | "curve">;

/** Em, y down, the first line's baseline at 0. */
export interface TextBounds {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

export interface TextLayout {
  /** SVG path data in thousandths of an em, y down. */
  readonly path: string;
  /** Of the lines and of all that the glyphs paint. */
  readonly bounds: TextBounds;
  /** Characters that no font has; each is shown as its font's sign for that. */
  readonly missing: readonly string[];
}

/** A glyph on its line; em. */
interface PlacedGlyph {
  readonly font: TextFont;
  readonly glyph: number;
  /** Where its origin lies. */
  readonly x: number;
  /** Up. */
  readonly y: number;
  /** The middle of the letter that it is a part of: on an arc, a letter turns about it as a whole. */
  readonly middle: number;
}

interface Line {
  readonly glyphs: readonly PlacedGlyph[];
  readonly width: number;
}

const UNITS = 1000;
/** Lines of a bent text must not meet the middle of their circle. */
const LEAST_RADIUS = 0.5;

/** Of one text's letters: ten thousand of any script have fewer. */
const MOST_POINTS = 2e6;

/**
 * Sets a text. The fonts that `fontsFor` names must be on the shelf. Throws "bad-font" naming the text where its letters have
 * so many points that they would take minutes to draw.
 */
export function layOutText(style: TextStyle, shelf: FontShelf): TextLayout {
  const { font: key, letterSpacing } = style;
  const text = cleanText(style.text);
  const runsByLine = text.split("\n").map((line) => runsOf(line, key, shelf));
  const metrics = metricsOf(shelf.get(key));
  const lines = runsByLine.map((runs) => setLine(runs, letterSpacing));
  const width = Math.max(0, ...lines.map((line) => line.width));
  const pen = new PathPen();
  let points = 0;
  for (const glyph of lines.flatMap((line) => line.glyphs)) points += pen.pointsOf(glyph);
  if (points > MOST_POINTS) throw tooManyPoints(text);
  lines.forEach((line, index) => {
    const start = style.align === "left" ? 0 : (width - line.width) * (style.align === "center" ? 0.5 : 1);
    const baseline = index * metrics.lineHeight;
    for (const glyph of line.glyphs) {
      pen.draw(glyph, placementOf(glyph, start - width / 2, baseline, style.curve, width));
    }
  });
  const depth = (lines.length - 1) * metrics.lineHeight;
  // A bent text's lines are no box: there, what is painted counts alone.
  const isStraight = style.curve === 0 || pen.bounds === null;
  const box: TextBounds | null = isStraight
    ? { left: -width / 2, top: -metrics.ascender, right: width / 2, bottom: depth - metrics.descender }
    : null;
  const bounds = union(box, pen.bounds);
  if (!canOutline(points, pen.length / (bounds.bottom - bounds.top || 1))) throw tooManyPoints(text);
  return { path: pen.path, bounds, missing: missingCharacters(text, key, shelf) };
}

function tooManyPoints(text: string): TexelcastError {
  const subject = text.length > 40 ? `${text.slice(0, 40)}…` : text;
  return new TexelcastError("bad-font", `“${subject}” cannot be drawn: its letters have too many points.`, {
    subject,
    reason: "too-many-points",
    hint: "Use another font, or fewer words.",
  });
}

interface Metrics {
  readonly ascender: number;
  /** Below 0. */
  readonly descender: number;
  readonly lineHeight: number;
}

/**
 * How the text's own font spaces lines; em. Kept within what looks like text: fonts with marks above marks ask for lines
 * twice the em, in which a word would be lost. What a glyph paints beyond counts by itself.
 */
function metricsOf(own: TextFont | undefined): Metrics {
  if (own === undefined) return { ascender: 1, descender: -0.25, lineHeight: 1.25 };
  const { unitsPerEm } = own;
  const ascender = clamp(own.ascender / unitsPerEm, 0.7, 1.1);
  const descender = clamp(own.descender / unitsPerEm, -0.4, -0.15);
  return { ascender, descender, lineHeight: clamp(ascender - descender + own.lineGap / unitsPerEm, 1, 1.5) };
}

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

function setLine(runs: readonly TextRun[], letterSpacing: number): Line {
  const hb = loadedHarfBuzz();
  const buffer = new hb.Buffer();
  const glyphs: PlacedGlyph[] = [];
  let x = 0;
  let trailing = 0;
  for (const run of runs) {
    const spacing = takesSpacing(run.script) ? letterSpacing : 0;
    for (const letter of shapeRun(run, buffer, spacing !== 0)) {
      for (const { glyph, dx, dy } of letter.glyphs) {
        glyphs.push({ font: run.font, glyph, x: x + dx, y: dy, middle: x + letter.advance / 2 });
      }
      x += letter.advance + spacing;
      trailing = spacing;
    }
  }
  // Space stands between letters, not behind the last one.
  return { glyphs, width: Math.max(0, x - trailing) };
}

interface Letter {
  advance: number;
  readonly cluster: number;
  readonly glyphs: { readonly glyph: number; readonly dx: number; readonly dy: number }[];
}

/** The run's letters from left to right, each with its marks; em. */
function shapeRun(run: TextRun, buffer: HarfBuzzBuffer, apart: boolean): Letter[] {
  const hb = loadedHarfBuzz();
  const { font, unitsPerEm } = run.font;
  buffer.reset();
  buffer.addText(run.text);
  buffer.setDirection(run.rightToLeft ? hb.Direction.RTL : hb.Direction.LTR);
  buffer.setScript(run.script);
  buffer.setLanguage("und");
  // Letters set apart must not be joined into one sign.
  hb.shape(font, buffer, apart ? [new hb.Feature("liga", 0), new hb.Feature("clig", 0)] : []);
  const letters: Letter[] = [];
  const positions = buffer.getGlyphPositions();
  buffer.getGlyphInfos().forEach(({ codepoint, cluster }, index) => {
    const { xAdvance = 0, xOffset = 0, yOffset = 0 } = positions[index] ?? {};
    let letter = letters.at(-1);
    if (letter?.cluster !== cluster) {
      letter = { advance: 0, cluster, glyphs: [] };
      letters.push(letter);
    }
    letter.glyphs.push({ glyph: codepoint, dx: letter.advance + xOffset / unitsPerEm, dy: yOffset / unitsPerEm });
    letter.advance += xAdvance / unitsPerEm;
  });
  return letters;
}

/** How a glyph's own coordinates (em, y up) go to the text's (em, y down): turned, then moved. */
interface Placement {
  readonly turn: Turn;
  readonly x: number;
  readonly y: number;
}

const UPRIGHT: Turn = { sin: 0, cos: 1 };

/** `left`: where the line begins; the whole text's middle is 0. */
function placementOf(glyph: PlacedGlyph, left: number, baseline: number, curve: number, width: number): Placement {
  if (curve === 0 || width === 0) return { turn: UPRIGHT, x: left + glyph.x, y: baseline - glyph.y };
  const sign = curve > 0 ? 1 : -1;
  const radius = width / ((Math.abs(curve) * Math.PI) / 180);
  // In an arch lower lines lie further in, in a bowl further out.
  const own = Math.max(LEAST_RADIUS, radius - sign * baseline);
  const turn = turnBy((sign * (left + glyph.middle)) / own);
  const [alongX, alongY] = [glyph.x - glyph.middle, -glyph.y];
  return {
    turn,
    x: sign * own * turn.sin + alongX * turn.cos - alongY * turn.sin,
    y: sign * (radius - own * turn.cos) + alongX * turn.sin + alongY * turn.cos,
  };
}

interface Glyph {
  readonly outline: ReturnType<TextFont["font"]["glyphToJson"]>;
  readonly points: number;
}

function glyphOf({ font }: TextFont, index: number): Glyph {
  const outline = font.glyphToJson(index);
  return { outline, points: outline.reduce((sum, { values }) => sum + values.length / 2, 0) };
}

/** Collects outlines and what they reach. */
class PathPen {
  readonly #parts: string[] = [];
  readonly #glyphs = new Map<TextFont, Map<number, Glyph>>();
  /** Along all points of each glyph; em. */
  length = 0;
  #left = Number.POSITIVE_INFINITY;
  #top = Number.POSITIVE_INFINITY;
  #right = Number.NEGATIVE_INFINITY;
  #bottom = Number.NEGATIVE_INFINITY;

  get path(): string {
    return this.#parts.join("");
  }

  /** Em; null when nothing was drawn. */
  get bounds(): TextBounds | null {
    if (this.#right < this.#left) return null;
    return { left: this.#left, top: this.#top, right: this.#right, bottom: this.#bottom };
  }

  draw({ font, glyph }: PlacedGlyph, { turn, x, y }: Placement): void {
    const scale = 1 / font.unitsPerEm;
    let before: readonly [x: number, y: number] | null = null;
    for (const { type, values } of this.#glyph(font, glyph).outline) {
      this.#parts.push(type);
      for (let index = 0; index + 1 < values.length; index += 2) {
        const [along, up] = [(values[index] ?? 0) * scale, (values[index + 1] ?? 0) * scale];
        if (before) this.length += Math.hypot(along - before[0], up - before[1]);
        before = [along, up];
        this.#point(x + along * turn.cos + up * turn.sin, y + along * turn.sin - up * turn.cos);
      }
    }
  }

  /** With those that control curves. */
  pointsOf({ font, glyph }: PlacedGlyph): number {
    return this.#glyph(font, glyph).points;
  }

  #glyph(font: TextFont, index: number): Glyph {
    const known = this.#glyphs.get(font) ?? new Map<number, Glyph>();
    this.#glyphs.set(font, known);
    const glyph = known.get(index) ?? glyphOf(font, index);
    known.set(index, glyph);
    return glyph;
  }

  /** Control points lie outside the outline, if anywhere: what they reach holds all of it. */
  #point(x: number, y: number): void {
    this.#left = Math.min(this.#left, x);
    this.#right = Math.max(this.#right, x);
    this.#top = Math.min(this.#top, y);
    this.#bottom = Math.max(this.#bottom, y);
    this.#parts.push(`${(x * UNITS).toFixed(2)} ${(y * UNITS).toFixed(2)} `);
  }
}

function union(a: TextBounds | null, b: TextBounds | null): TextBounds {
  if (a === null || b === null) return a ?? b ?? { left: 0, top: 0, right: 0, bottom: 0 };
  return {
    left: Math.min(a.left, b.left),
    top: Math.min(a.top, b.top),
    right: Math.max(a.right, b.right),
    bottom: Math.max(a.bottom, b.bottom),
  };
}

/** A text as an SVG drawing that fills its layer's box, and how much room it asks for. */
import type { EngineColor, EngineText, TextMeasure } from "./engine-api.ts";
import type { FontShelf } from "./text-fonts.ts";
import { layOutText, type TextBounds, type TextLayout } from "./text-layout.ts";

const UNITS = 1000;
/** Nothing is measured smaller, so that a box can be made of it; em. */
const LEAST_SIDE = 0.05;

/** The fonts that `fontsFor` names must be on the shelf. */
export function measureText(look: EngineText, shelf: FontShelf): TextMeasure {
  const { bounds, missing } = outlined(layOutText(look, shelf), look);
  return { width: bounds.right - bounds.left, height: bounds.bottom - bounds.top, missing };
}

/**
 * The text in a box of this many pixels, beside the side that `align` says and in the middle of its height.
 *
 * @param aspect Of the box as it lies on the surface, width by height: pixels may be oblong.
 */
export function drawText(look: EngineText, shelf: FontShelf, width: number, height: number, aspect: number): string {
  const { path, bounds } = outlined(layOutText(look, shelf), look);
  const [own, high] = [bounds.right - bounds.left, bounds.bottom - bounds.top];
  // The box in em.
  const boxHeight = Math.max(1 / look.fontSize, high, own / aspect);
  const boxWidth = boxHeight * aspect;
  const spare = boxWidth - own;
  const left = bounds.left - (look.align === "left" ? 0 : spare * (look.align === "center" ? 0.5 : 1));
  const top = bounds.top - (boxHeight - high) / 2;
  const viewBox = [left, top, boxWidth, boxHeight].map((length) => (length * UNITS).toFixed(3)).join(" ");
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="${viewBox}" preserveAspectRatio="none">`,
    look.outline === null ? "" : outlinePath(path, look.outline),
    path === "" ? "" : `<path d="${path}" ${paint("fill", look.color)}/>`,
    "</svg>",
  ].join("");
}

/** Below the letters, so that it never thins them, and all of it below all of them. */
function outlinePath(path: string, { color, width }: NonNullable<EngineText["outline"]>): string {
  if (path === "") return "";
  const stroke = `stroke-width="${(2 * width * UNITS).toFixed(2)}" stroke-linejoin="round" ${paint("stroke", color)}`;
  return `<path d="${path}" fill="none" ${stroke}/>`;
}

function paint(what: "fill" | "stroke", [red, green, blue, alpha]: EngineColor): string {
  const byte = (share: number): number => Math.round(share * 255);
  return `${what}="rgb(${byte(red)},${byte(green)},${byte(blue)})" ${what}-opacity="${alpha}"`;
}

function outlined(layout: TextLayout, { outline }: EngineText): TextLayout {
  const out = outline?.width ?? 0;
  const { left, top, right, bottom } = layout.bounds;
  const [width, height] = [Math.max(LEAST_SIDE, right - left + 2 * out), Math.max(LEAST_SIDE, bottom - top + 2 * out)];
  const [x, y] = [(left + right) / 2, (top + bottom) / 2];
  const bounds: TextBounds = { left: x - width / 2, top: y - height / 2, right: x + width / 2, bottom: y + height / 2 };
  return { ...layout, bounds };
}

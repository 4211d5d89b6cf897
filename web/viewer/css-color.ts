/** A computed CSS colour as numbers for the GPU. */

/** sRGB with alpha, each 0 to 1, not premultiplied. */
export type CssColor = readonly [number, number, number, number];

/**
 * Reads a custom property of an element as a colour: the browser resolves names, nested properties and mixes, this reads
 * `rgb(…)` and `color(srgb …)`, the forms in which it answers.
 */
export function readCssColor(element: HTMLElement, property: string, fallback: string): CssColor {
  const probe = document.createElement("span");
  probe.style.color = `var(${property}, ${fallback})`;
  element.append(probe);
  const computed = getComputedStyle(probe).color;
  probe.remove();
  return parseCssColor(computed) ?? parseCssColor(fallback) ?? [0.5, 0.5, 0.5, 1];
}

/** Null for forms other than `rgb(…)`, `rgba(…)` and `color(srgb …)`. */
export function parseCssColor(text: string): CssColor | null {
  const [, form, list] = /^(rgba?|color)\(\s*(.*?)\s*\)$/.exec(text) ?? [];
  if (form === undefined || list === undefined || (form === "color" && !list.startsWith("srgb "))) {
    return null;
  }
  const numbers = (list.match(/-?[\d.]+(?:e-?\d+)?%?/g) ?? []).map((number) =>
    number.endsWith("%") ? Number.parseFloat(number) / 100 : Number.parseFloat(number),
  );
  const [red, green, blue, alpha = 1] = numbers;
  if (red === undefined || green === undefined || blue === undefined) {
    return null;
  }
  const scale = form === "color" ? 1 : 1 / 255;
  return [red * scale, green * scale, blue * scale, alpha];
}

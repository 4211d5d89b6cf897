/** SVG drawings over a view, which change in each frame of a drag. */

const SVG = "http://www.w3.org/2000/svg";

/** An empty drawing that fills `root`, hidden from assistive technology. */
export function makeOverlay(...classNames: readonly string[]): SVGSVGElement {
  const overlay = document.createElementNS(SVG, "svg");
  overlay.classList.add("tcv-overlay", ...classNames);
  overlay.setAttribute("aria-hidden", "true");
  // Nothing is seen of it: it keeps the drawing's bounds what they are. Where they change, Chromium sorts all of the page
  // into layers anew, in each frame (0.9 ms against 0.4; with `will-change: transform` alone on the drawing, 1.1). With `contain: strict`
  // as well (gizmo-style.ts), 0.15: what stands over the views is not recorded anew with the lines.
  overlay.append(makeSvg("rect", { width: "100%", height: "100%", fill: "transparent", "pointer-events": "none" }));
  return overlay;
}

export function makeSvg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Readonly<Record<string, string>>,
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  return element;
}

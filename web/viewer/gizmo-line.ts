/** One line of the gizmo's drawing. */
import { makeSvg } from "./svg-overlay.ts";

/**
 * A path, and polylines that take its place in a gesture, one for each of its pieces: a path's data is a property of style in
 * Chromium, so that a new one has it work out the path's style before it lays it out, in each frame of a drag (0.20 ms of a
 * frame in which the outline moves, with polylines 0.05, and 0.03 more of layout).
 */
export class GizmoLine {
  readonly element: SVGGElement;
  readonly #className: string;
  readonly #path: SVGPathElement;
  readonly #polylines: { readonly element: SVGPolylineElement; drawn: string }[] = [];
  #drawn = "";

  constructor(className: string) {
    this.#className = className;
    this.element = makeSvg("g", {});
    this.#path = makeSvg("path", { class: className });
    this.element.append(this.#path);
  }

  /** @param path path data; "" draws nothing */
  draw(path: string, inGesture: boolean): void {
    const pieces = inGesture ? piecesOf(path) : [];
    const whole = pieces.length > 0 ? "" : path;
    if (this.#drawn !== whole) {
      this.#drawn = whole;
      this.#path.setAttribute("d", whole);
    }
    while (this.#polylines.length < pieces.length) {
      const element = makeSvg("polyline", { class: this.#className });
      this.#polylines.push({ element, drawn: "" });
      this.element.append(element);
    }
    for (const [at, polyline] of this.#polylines.entries()) {
      const points = pieces[at] ?? "";
      if (polyline.drawn !== points) {
        polyline.drawn = points;
        polyline.element.setAttribute("points", points);
      }
    }
  }
}

/** The points of a path's pieces, where they are open lines of straight pieces; none for any other path. */
export function piecesOf(path: string): string[] {
  return path === "" || path.includes("Z") ? [] : path.slice(1).replaceAll("L", " ").split("M");
}

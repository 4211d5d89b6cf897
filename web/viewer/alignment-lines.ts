/** Lines over a view that show what a decal has come into line with. */
import { adoptStyle } from "./adopt-style.ts";
import type { ScreenPoint } from "./screen-space.ts";
import { makeOverlay, makeSvg } from "./svg-overlay.ts";

export type AlignmentLine = readonly [ScreenPoint, ScreenPoint];

/** CSS pixels: so near to a line what is dragged goes onto it. */
export const ALIGNMENT_REACH = 7;

const STYLE = /* css */ `
.tcv-alignment-casing { stroke: rgb(255 255 255 / 0.6); stroke-width: 2.5; }
.tcv-alignment-line { stroke: #d6187c; stroke-width: 1; }
`;

export class AlignmentLines {
  readonly #element = makeOverlay("tcv-alignment");
  readonly #paths: readonly SVGPathElement[];
  #drawn = "";

  constructor(root: HTMLElement) {
    this.#paths = ["tcv-alignment-casing", "tcv-alignment-line"].map((name) => {
      const element = makeSvg("path", { class: name });
      this.#element.append(element);
      return element;
    });
    root.append(this.#element);
    adoptStyle(root, STYLE);
  }

  /** CSS pixels of the view; none draws nothing. */
  draw(lines: readonly AlignmentLine[]): void {
    const path = lines.map(([from, to]) => `M${text(from)}L${text(to)}`).join("");
    if (path === this.#drawn) return;
    this.#drawn = path;
    for (const element of this.#paths) element.setAttribute("d", path);
  }

  dispose(): void {
    this.#element.remove();
  }
}

function text({ x, y }: ScreenPoint): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}

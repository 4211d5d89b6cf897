/** Names of a texture's places over the flat view: an outline around each, and its name where there is room. */
import type { TextureCamera } from "./texture-camera.ts";
import type { GuideEntry } from "./viewer-api.ts";

const SVG = "http://www.w3.org/2000/svg";
/** Width of a letter and height of a line, pixels; a name that does not fit is left out. */
const LETTER = 6;
/** Of a part's name, which is bold. */
const PART_LETTER = 7;
const LINE = 15;
const PADDING = 4;

interface Place {
  readonly entry: GuideEntry;
  readonly box: SVGRectElement;
  readonly name: SVGTextElement;
}

/** A part of several faces: its name stands at the foot of them all. */
interface Part {
  readonly name: string;
  readonly uv: GuideEntry["uv"];
  readonly text: SVGTextElement;
}

export class TextureGuide {
  readonly #element = document.createElementNS(SVG, "svg");
  #places: readonly Place[] = [];
  #parts: readonly Part[] = [];

  constructor(root: HTMLElement) {
    this.#element.classList.add("tcv-overlay", "tcv-guide-names");
    this.#element.setAttribute("aria-hidden", "true");
    root.append(this.#element);
  }

  show(guide: readonly GuideEntry[]): void {
    this.#places = guide.map((entry) => ({
      entry,
      box: document.createElementNS(SVG, "rect"),
      name: document.createElementNS(SVG, "text"),
    }));
    this.#parts = facedParts(guide).map(({ name, uv }) => {
      const text = document.createElementNS(SVG, "text");
      text.classList.add("tcv-part");
      return { name, uv, text };
    });
    this.#element.replaceChildren(
      ...this.#places.map(({ box }) => box),
      ...this.#places.map(({ name }) => name),
      ...this.#parts.map(({ text }) => text),
    );
  }

  place(camera: TextureCamera): void {
    for (const { entry, box, name } of this.#places) {
      const { x: left, y: top } = camera.pixelOf([entry.uv[0], entry.uv[1]]);
      const { x: right, y: bottom } = camera.pixelOf([entry.uv[2], entry.uv[3]]);
      const [width, height] = [right - left, bottom - top];
      for (const [attribute, value] of Object.entries({ x: left, y: top, width, height })) {
        box.setAttribute(attribute, value.toFixed(1));
      }
      name.textContent = fittingName(entry, width, height);
      name.setAttribute("x", ((left + right) / 2).toFixed(1));
      name.setAttribute("y", ((top + bottom) / 2).toFixed(1));
    }
    this.#placeParts(camera);
  }

  #placeParts(camera: TextureCamera): void {
    for (const { name, uv, text } of this.#parts) {
      const { x: left } = camera.pixelOf([uv[0], uv[1]]);
      const { x: right, y: bottom } = camera.pixelOf([uv[2], uv[3]]);
      text.textContent = name.length * PART_LETTER <= right - left ? name : "";
      text.setAttribute("x", ((left + right) / 2).toFixed(1));
      text.setAttribute("y", (bottom - LINE / 2).toFixed(1));
    }
  }

  dispose(): void {
    this.#element.remove();
  }
}

/** The parts that have several faces, each with the box around them all. */
export function facedParts(guide: readonly GuideEntry[]): { readonly name: string; readonly uv: GuideEntry["uv"] }[] {
  const boxes = new Map<string, GuideEntry["uv"]>();
  for (const { part, face, uv } of guide) {
    if (face !== undefined) {
      const [left, top, right, bottom] = boxes.get(part) ?? uv;
      boxes.set(part, [Math.min(left, uv[0]), Math.min(top, uv[1]), Math.max(right, uv[2]), Math.max(bottom, uv[3])]);
    }
  }
  return [...boxes].map(([name, uv]) => ({ name, uv }));
}

/** What a place is called in a box of this many pixels; "" where that does not fit. */
export function fittingName({ part, face }: GuideEntry, width: number, height: number): string {
  const name = face ?? part;
  return name.length * LETTER + 2 * PADDING <= width && LINE <= height ? name : "";
}

/** Draws the gizmo: an SVG over the 3D view. Knows pixels only; what is where is decided in gizmo-picture.ts. */
import { GizmoLine } from "./gizmo-line.ts";
import { FINGER_REACH, handleUnder, MOUSE_REACH } from "./handle-under.ts";
import type { ScreenPoint } from "./screen-space.ts";
import { makeSvg as make, makeOverlay } from "./svg-overlay.ts";

export const HANDLES = ["nw", "ne", "se", "sw", "n", "e", "s", "w", "rotate", "depth", "near", "far"] as const;
export type HandleName = (typeof HANDLES)[number];
/** Those that sit on a picture's border. */
export type ScaleHandleName = Exclude<HandleName, "rotate" | "depth" | "near" | "far">;

export interface HandlePlace {
  /** CSS pixels in the view. */
  readonly x: number;
  readonly y: number;
  /** Degrees clockwise on the screen: how the mark lies. */
  readonly angle: number;
  /** Behind the model: drawn faint. */
  readonly hidden: boolean;
  readonly cursor: string;
}

/** Where handles stand that may stand at several places. */
export interface HandleStand {
  /** The side of the outline at which the one that turns stands, and the share of its stem's usual length. */
  readonly knob: { readonly side: "n" | "s" | "e" | "w"; readonly share: number } | null;
  /** CSS pixels that the arrow is longer by than it had to be; null where there is none. */
  readonly stretch: number | null;
}

/** SVG path data in CSS pixels; "" draws nothing. */
export interface GizmoPicture {
  readonly outline: string;
  readonly outlineHidden: string;
  readonly box: string;
  readonly boxHidden: string;
  readonly guide: string;
  readonly arrow: string;
  readonly arrowHead: string;
  readonly hover: string;
  /** The outlines of its mirrored copy and of what is chosen with it. */
  readonly beside: string;
  /** What a press nearer to it than to any handle takes hold of is the decal itself; null where it is out of sight. */
  readonly middle: ScreenPoint | null;
  readonly stand: HandleStand | null;
  /** Handles that are left out are not shown. */
  readonly handles: ReadonlyMap<HandleName, HandlePlace>;
}

export interface Readout {
  readonly text: string;
  /** Where the pointer is. */
  readonly at: ScreenPoint;
  /** The view's size, CSS pixels. */
  readonly view: { readonly width: number; readonly height: number };
}

/** From the pointer to its label, and what the label needs, CSS pixels. */
const POINTER_GAP = 18;
const FINGER_GAP = 40;
const READOUT_ROOM = 28;

type PathName = Exclude<keyof GizmoPicture, "handles" | "middle" | "stand">;

/** In drawing order, with class names; casings share the data of the line that they lie under. */
const PATHS: readonly { readonly data: PathName; readonly className: string }[] = [
  { data: "boxHidden", className: "tcv-box-hidden" },
  { data: "box", className: "tcv-box" },
  { data: "beside", className: "tcv-beside" },
  { data: "outlineHidden", className: "tcv-outline-hidden" },
  { data: "hover", className: "tcv-casing" },
  { data: "hover", className: "tcv-hover" },
  { data: "outline", className: "tcv-casing" },
  { data: "outline", className: "tcv-outline" },
  { data: "guide", className: "tcv-guide" },
  { data: "arrow", className: "tcv-casing" },
  { data: "arrow", className: "tcv-arrow" },
  { data: "arrowHead", className: "tcv-arrow-head" },
];

export class GizmoOverlay {
  readonly element = makeOverlay();
  readonly #paths: { readonly line: GizmoLine; readonly data: PathName }[] = [];
  readonly #handles = new Map<HandleName, SVGGElement>();
  readonly #readout = document.createElement("div");
  readonly #coarse = matchMedia("(pointer: coarse)");
  readonly #root: HTMLElement;
  #picture: GizmoPicture | null = null;
  #lit: HandleName | null = null;
  #gesture: { readonly handle: HandleName | null } | null = null;
  /** Nothing is shown, no handle either: that is not said to the document again in each frame. */
  #isEmpty = false;

  constructor(root: HTMLElement) {
    this.#root = root;
    for (const { data, className } of PATHS) {
      const line = new GizmoLine(className);
      this.#paths.push({ line, data });
      this.element.append(line.element);
    }
    for (const name of HANDLES) {
      const handle = this.#makeHandle(name);
      this.#handles.set(name, handle);
      this.element.append(handle);
    }
    this.#readout.className = "tcv-readout";
    this.#readout.hidden = true;
    root.append(this.element, this.#readout);
  }

  /** Shows a picture; null shows nothing. */
  draw(picture: GizmoPicture | null): void {
    if (picture === null && this.#isEmpty) {
      return;
    }
    // In a gesture handles stay where they are.
    this.#isEmpty = picture === null && this.#gesture === null;
    this.#picture = picture;
    for (const { line, data } of this.#paths) {
      line.draw(picture?.[data] ?? "", this.#gesture !== null);
    }
    for (const [name, handle] of this.#handles) {
      // The others fade out where they were grabbed from, and need not be moved unseen.
      if (this.#gesture !== null && this.#gesture.handle !== name) {
        continue;
      }
      const place = picture?.handles.get(name);
      handle.toggleAttribute("hidden", place === undefined);
      handle.style.display = place === undefined ? "none" : "";
      if (place !== undefined) {
        handle.setAttribute(
          "transform",
          `translate(${round(place.x)} ${round(place.y)}) rotate(${round(place.angle)})`,
        );
        handle.toggleAttribute("data-hidden", place.hidden);
      }
    }
  }

  get picture(): GizmoPicture | null {
    return this.#picture;
  }

  /** How far from its middle a handle is caught by this page's main pointer, CSS pixels. */
  get reach(): number {
    return this.#coarse.matches ? FINGER_REACH : MOUSE_REACH;
  }

  /** The handle that a pointer at this point of the view takes hold of. */
  handleAt(at: ScreenPoint, pointerType: string): HandleName | null {
    const { handles = [], middle = null } = this.#picture ?? {};
    return handleUnder(at, handles, middle, pointerType === "touch" ? FINGER_REACH : MOUSE_REACH);
  }

  /** Lights up the handle that a press would take, and has its cursor at hand for the view (`data-cursor="handle"`). */
  hover(name: HandleName | null): void {
    if (name !== this.#lit) {
      for (const [candidate, handle] of this.#handles) handle.toggleAttribute("data-lit", candidate === name);
      this.#lit = name;
    }
    const place = name !== null && this.#picture?.handles.get(name);
    if (place) this.#root.style.setProperty("--tcv-handle-cursor", place.cursor);
  }

  /** A drag began: its handle, if it has one, stays highlighted, and the others stay behind until it ends. */
  startGesture(handle: HandleName | null): void {
    this.#gesture = { handle };
    this.#highlight(handle);
  }

  endGesture(): void {
    this.#gesture = null;
    this.#highlight(null);
  }

  /** A small label by the pointer, within the view, that says what a gesture has come to; null hides it. */
  setReadout(readout: Readout | null): void {
    if (this.#readout.hidden !== (readout === null)) {
      this.#readout.hidden = readout === null;
    }
    if (readout !== null) {
      const { text, at, view } = readout;
      const finger = this.#coarse.matches;
      // A finger hides what is below it.
      const above = finger ? at.y > FINGER_GAP + READOUT_ROOM : at.y > view.height - POINTER_GAP - READOUT_ROOM;
      const gap = finger ? FINGER_GAP : POINTER_GAP;
      const top = above ? `calc(${round(at.y - gap)}px - 100%)` : `${round(at.y + gap)}px`;
      // As much of it is left of the pointer as the pointer has of the view on its left.
      this.#readout.textContent = text;
      this.#readout.style.transform = `translate(calc(${round(at.x)}px - ${round((100 * at.x) / view.width)}%), ${top})`;
    }
  }

  dispose(): void {
    this.element.remove();
    this.#readout.remove();
  }

  #highlight(active: HandleName | null): void {
    for (const [name, handle] of this.#handles) {
      handle.toggleAttribute("data-active", name === active);
    }
  }

  #makeHandle(name: HandleName): SVGGElement {
    const handle = make("g", { class: "tcv-handle", "data-handle": name });
    handle.append(...marksOf(name));
    handle.style.display = "none";
    return handle;
  }
}

/** Corners are squares, edges are bars along their edge, the knob turns, diamonds pull along a line. */
function marksOf(name: HandleName): SVGElement[] {
  switch (name) {
    case "rotate":
      return [
        make("circle", { class: "tcv-mark-shadow", r: "9.5", cy: "1" }),
        make("circle", { class: "tcv-mark", r: "8.5" }),
        // Three quarters of a turn, and the tip of its arrow.
        make("path", { class: "tcv-glyph", d: "M3.6 -1.2A3.8 3.8 0 1 0 3.3 2M4.4 -4.2L3.7 -1.1L0.7 -1.8" }),
      ];
    case "depth":
    case "near":
    case "far":
      return [
        make("rect", {
          class: "tcv-mark-shadow",
          x: "-6",
          y: "-5",
          width: "12",
          height: "12",
          rx: "2",
          transform: "rotate(45)",
        }),
        make("path", { class: "tcv-mark", d: "M0 -7.5L7.5 0L0 7.5L-7.5 0Z" }),
      ];
    case "n":
    case "s":
    case "e":
    case "w":
      return [
        make("rect", { class: "tcv-mark-shadow", x: "-9", y: "-2.5", width: "18", height: "7", rx: "3.5" }),
        make("rect", { class: "tcv-mark", x: "-8", y: "-3", width: "16", height: "6", rx: "3" }),
      ];
    default:
      return [
        make("rect", { class: "tcv-mark-shadow", x: "-6", y: "-5", width: "12", height: "12", rx: "3" }),
        make("rect", { class: "tcv-mark", x: "-5", y: "-5", width: "10", height: "10", rx: "2.5" }),
      ];
  }
}

function round(value: number): number {
  return Math.round(value * 10) / 10;
}

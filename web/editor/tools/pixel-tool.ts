/** Pencil, pixel eraser, line, rectangle and bucket: each gesture changes one pixel layer, in one step of the history. */
import { type IconNode, Minus, PaintBucket, Pencil, Square } from "lucide";
import type { SurfaceHit, ToolInput, ToolSample } from "../../viewer/viewer-api.ts";
import { bracketOf } from "../state/bracket-key.ts";
import { tellShownAlready } from "../state/mask-edits.ts";
import type { Strings } from "../strings.ts";
import { PaintCursor } from "./paint-cursor.ts";
import { CLEAR, type PixelCanvas, type PixelColor, pixelColorOf } from "./pixel-canvas.ts";
import { fillFrom } from "./pixel-fill.ts";
import type { PixelGesture } from "./pixel-gesture.ts";
import {
  blockCorners,
  byMaterial,
  type GridPlace,
  joined,
  type MaterialPlace,
  placeOf,
  placeOfUv,
  texelAt,
  texelsAlong,
} from "./pixel-places.ts";
import type { PixelProbe } from "./pixel-probe.ts";
import type { PixelSession, PixelSize } from "./pixel-session.ts";
import { squared, type Texel, texelLine, texelRectangle, tipCorner } from "./pixel-shapes.ts";
import { PointerPath } from "./pointer-path.ts";
import { surfaceJoins } from "./surface-joins.ts";
import type { Tool, ToolOption } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";
import { MOST_PIXEL_SIZE, withRecent } from "./tool-settings.ts";

export type PixelKind = "pencil" | "eraser" | "line" | "rectangle" | "bucket";

const KINDS: Readonly<
  Record<PixelKind, { readonly icon: IconNode; readonly shortcut: string; readonly options: readonly ToolOption[] }>
> = {
  pencil: { icon: Pencil, shortcut: "N", options: ["color", "pixelSize", "alphaLock"] },
  eraser: { icon: Pencil, shortcut: "E", options: ["pixelSize"] },
  line: { icon: Minus, shortcut: "U", options: ["color", "pixelSize", "alphaLock"] },
  rectangle: { icon: Square, shortcut: "U", options: ["color", "filled", "pixelSize", "alphaLock"] },
  bucket: { icon: PaintBucket, shortcut: "G", options: ["color", "tolerance", "contiguous", "alphaLock"] },
};

/** Pixels of the screen between two looks at the model: texels may be small there. */
const LOOK = 1.5;

interface Stroke {
  readonly gesture: PixelGesture;
  readonly color: PixelColor;
  readonly first: ToolSample;
  readonly start: MaterialPlace;
  readonly path: PointerPath;
  last: MaterialPlace | null;
}

export class PixelTool implements Tool {
  readonly id: PixelKind;
  readonly label: (strings: Strings) => string;
  readonly icon: IconNode;
  readonly shortcut: string;
  readonly options: readonly ToolOption[];
  readonly input: ToolInput;
  readonly #context: ToolContext;
  readonly #pixels: PixelSession;
  readonly #probe: PixelProbe;
  readonly #cursor: PaintCursor;
  #stroke: Stroke | null = null;
  #picking = false;
  #keyed: PixelGesture | null = null;
  /** Where the newest line ended in the flat view, in texels: Shift draws a straight line from there. */
  #lastPlace: MaterialPlace | null = null;

  constructor(kind: PixelKind, context: ToolContext, pixels: PixelSession, probe: PixelProbe) {
    this.id = kind;
    this.label = ({ tools }) => tools[kind];
    ({ icon: this.icon, shortcut: this.shortcut, options: this.options } = KINDS[kind]);
    this.#context = context;
    this.#pixels = pixels;
    this.#probe = probe;
    this.#cursor = new PaintCursor(context, {
      stepAt: (hit) => this.#texelWidth(hit),
      moved: (hit) => this.#showHit(hit),
      begin: (hit) => this.#beginByKey(hit),
      extend: (hit) => this.#extendByKey(hit),
      end: () => this.#endByKey(),
    });
    this.input = {
      cursor: "crosshair",
      down: (sample) => this.#down(sample),
      move: (samples) => this.#move(samples),
      up: (sample) => this.#up(sample),
      interrupted: (reason) => {
        if (reason === "pinch") this.cancel();
        else this.#finish();
      },
      hover: (sample) => this.#hover(sample),
    };
  }

  readonly offered = (): boolean => this.id === "eraser" || this.#context.tools.pixelMode;

  cancel(): boolean {
    const gesture = this.#stroke?.gesture ?? this.#keyed;
    this.#stroke = null;
    this.#keyed = null;
    this.#picking = false;
    gesture?.cancel();
    return gesture !== null;
  }

  finish(): void {
    this.#finish();
    this.#endByKey();
  }

  deactivate(): void {
    this.cancel();
    this.#cursor.hide();
    this.#showRing(null, null);
  }

  forget(): void {
    this.cancel();
    this.#cursor.hide();
    this.#lastPlace = null;
  }

  key(event: KeyboardEvent, view: "model" | "texture" | null): boolean {
    if (this.#cursor.key(event, view !== null)) return true;
    const direction = bracketOf(event);
    if (direction === null || event.shiftKey) return false;
    const { tools } = this.#context;
    const pixelSize = Math.min(MOST_PIXEL_SIZE, Math.max(1, tools.settings.pixelSize + direction));
    tools.configure({ pixelSize });
    return true;
  }

  #down(sample: ToolSample): boolean {
    this.#cursor.hide();
    const material = this.#materialOf(sample);
    if (material === null) return false;
    if (sample.alt) {
      this.#picking = true;
      this.#probe.pick(sample.hit);
      return true;
    }
    if (this.#pixels.tellBare(material)) return true;
    const size = this.#sizeOf(material);
    const at = size && placeOf(sample, material, size);
    if (size === null || at === null) return false;
    if (!isInside(at, size)) return false;
    const gesture = this.#begin(material);
    if (gesture === null) return true;
    const joins = surfaceJoins(this.#context.viewer.surface, 0);
    const path = new PointerPath(sample, { rope: 0, look: LOOK, joined: joins });
    const start = { material, at };
    this.#stroke = { gesture, color: this.#color(gesture), first: sample, start, path, last: start };
    if (this.id === "bucket") this.#fill(gesture, material, at);
    else if (this.#drags) {
      const from = sample.shift && this.#lastPlace?.material === material ? this.#lastPlace.at : null;
      path.first(sample);
      this.#stamp(this.#stroke, material, from === null ? [at] : [from, ...joined(from, at)]);
    } else this.#shape(this.#stroke, sample);
    return true;
  }

  #move(samples: readonly ToolSample[]): void {
    const newest = samples.at(-1);
    if (newest === undefined) return;
    if (this.#picking) this.#probe.pick(newest.hit);
    const stroke = this.#stroke;
    if (stroke === null) return;
    if (this.#drags) for (const sample of samples) this.#follow(stroke, sample);
    else if (this.id !== "bucket") this.#shape(stroke, newest);
    this.#showPlace(newest);
  }

  #up(sample: ToolSample): void {
    this.#picking = false;
    const stroke = this.#stroke;
    if (stroke === null) return;
    if (this.#drags) this.#follow(stroke, sample);
    else if (this.id !== "bucket") this.#shape(stroke, sample);
    this.#finish();
  }

  /** Pencil and eraser follow the pointer; the others draw a shape between two places. */
  get #drags(): boolean {
    return this.id === "pencil" || this.id === "eraser";
  }

  #follow(stroke: Stroke, sample: ToolSample): void {
    const { gesture, path, start } = stroke;
    const size = gesture.sizeOf(start.material);
    if (sample.view.kind === "texture") {
      const at = size && placeOf(sample, start.material, size);
      if (at !== null) this.#stamp(stroke, start.material, stroke.last === null ? [at] : joined(stroke.last.at, at));
      stroke.last = at && { material: start.material, at };
      return;
    }
    const { places, last } = texelsAlong(path.add(sample), (material) => gesture.sizeOf(material), stroke.last);
    stroke.last = last;
    for (const [material, part] of byMaterial(places)) this.#stamp(stroke, material, part);
  }

  #stamp({ gesture, color }: Pick<Stroke, "gesture" | "color">, material: number, places: readonly GridPlace[]): void {
    if (places.length === 0) return;
    const { pixelSize } = this.#context.tools.settings;
    gesture.draw(material, (canvas) => stampAll(canvas, places, pixelSize, color));
  }

  /** The shape from where the pointer was pressed to where it is now, in place of the one before. */
  #shape({ gesture, color, first, start }: Stroke, sample: ToolSample): void {
    const { filled } = this.#context.tools.settings;
    const { material } = start;
    if (this.id === "line" && sample.view.kind === "model") {
      const joins = surfaceJoins(this.#context.viewer.surface, 0);
      const path = new PointerPath(first, { rope: 0, look: LOOK, joined: joins });
      const steps = [...path.first(first), ...path.finish(sample)];
      const { places } = texelsAlong(steps, (met) => gesture.sizeOf(met), null);
      gesture.restart();
      for (const [met, part] of byMaterial(places)) this.#stamp({ gesture, color }, met, part);
      return;
    }
    const size = gesture.sizeOf(material);
    const place = size && placeOf(sample, material, size);
    if (place === null) return;
    const from = texelAt(start.at);
    const to = sample.shift ? squared(from, texelAt(place), this.id === "line") : texelAt(place);
    const texels = this.id === "line" ? texelLine(from, to) : texelRectangle(from, to, filled);
    gesture.restart();
    this.#stamp({ gesture, color }, material, texels.map(centreOf));
  }

  #fill(gesture: PixelGesture, material: number, at: GridPlace): void {
    const { tolerance, contiguous } = this.#context.tools.settings;
    fillFrom(gesture, this.#pixels, material, texelAt(at), this.#color(gesture), { tolerance, contiguous });
  }

  #begin(material: number): PixelGesture | null {
    const { tools } = this.#context;
    const gesture = this.#pixels.begin(material, this.#pixels.masked(this.id === "eraser"));
    if (gesture !== null && this.id !== "eraser") {
      tools.configure({ recent: withRecent(tools.settings.recent, tools.settings.color) });
    }
    return gesture;
  }

  #finish(): void {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke === null) return;
    if (stroke.last !== null) this.#lastPlace = stroke.last;
    this.#record(stroke.gesture);
  }

  #record(gesture: PixelGesture): void {
    const { session, store, board } = this.#context;
    this.#pixels.finish(gesture, this.#context.board.strings.tools.steps[this.id], (id) => {
      if (store.state.selectedId !== id) session.select(id);
      board.announce(this.#context.board.strings.tools.painted[this.id]);
      if (gesture.ink !== null && this.id !== "eraser") tellShownAlready(session.recordedDesign, id, board);
    });
  }

  #beginByKey(hit: SurfaceHit): void {
    this.#keyed = this.#begin(hit.material);
    const size = this.#keyed?.sizeOf(hit.material);
    if (this.#keyed && size && this.id === "bucket") this.#fill(this.#keyed, hit.material, placeOfUv(hit.uv, size));
    else this.#extendByKey(hit);
  }

  #extendByKey(hit: SurfaceHit): void {
    const gesture = this.#keyed;
    const size = gesture?.sizeOf(hit.material);
    if (!gesture || !size || this.id === "bucket") return;
    this.#stamp({ gesture, color: this.#color(gesture) }, hit.material, [placeOfUv(hit.uv, size)]);
  }

  #endByKey(): void {
    const keyed = this.#keyed;
    this.#keyed = null;
    if (keyed !== null) this.#record(keyed);
  }

  #hover(sample: ToolSample | null): void {
    if (sample !== null) this.#cursor.hide();
    else if (this.#cursor.shown) return;
    if (sample === null) this.#showRing(null, null);
    else this.#showPlace(sample);
  }

  #showPlace(sample: ToolSample): void {
    const material = this.#materialOf(sample);
    const size = material === null ? null : this.#sizeOf(material);
    const place = material === null || size === null ? null : placeOf(sample, material, size);
    this.#showRing(sample.hit, size && place && this.#block(place, size));
  }

  #showHit(hit: SurfaceHit): void {
    const size = this.#sizeOf(hit.material);
    this.#showRing(hit, size && this.#block(placeOfUv(hit.uv, size), size));
  }

  #block([x, y]: GridPlace, size: PixelSize): ReturnType<typeof blockCorners> {
    const across = this.id === "bucket" ? 1 : this.#context.tools.settings.pixelSize;
    return blockCorners(tipCorner(x, y, across), across, size);
  }

  /** The texels that would be painted, as a square in both views. */
  #showRing(hit: SurfaceHit | null, corners: ReturnType<typeof blockCorners> | null): void {
    const { viewer, textureView, store } = this.#context;
    viewer.setRing(hit && corners && { hit, radius: 0, inner: 1, corners: viewer.surface.placesInModel(hit, corners) });
    const shown = hit === null || hit.material === store.state.material;
    textureView.setRing(corners !== null && shown ? [corners] : null);
  }

  #materialOf(sample: ToolSample): number | null {
    return sample.view.kind === "model" ? (sample.hit?.material ?? null) : this.#context.store.state.material;
  }

  #color({ ink }: PixelGesture): PixelColor {
    return ink ?? (this.id === "eraser" ? CLEAR : pixelColorOf(this.#context.tools.settings.color));
  }

  #sizeOf(material: number): PixelSize | null {
    return this.#pixels.sizeOf(material, this.#pixels.masked(this.id === "eraser"));
  }

  #texelWidth(hit: SurfaceHit): number {
    const size = this.#sizeOf(hit.material);
    if (size === null) return 0;
    const [u, v] = hit.uv;
    const [a, b] = this.#context.viewer.surface.placesInModel(hit, [hit.uv, [u + 1 / size.width, v]]);
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : 0;
  }
}

function stampAll(canvas: PixelCanvas, places: readonly GridPlace[], size: number, color: PixelColor): void {
  for (const [x, y] of places) canvas.stamp(tipCorner(x, y, size), size, color);
}

const centreOf = ([x, y]: Texel): GridPlace => [x + 0.5, y + 0.5];

const isInside = ([x, y]: GridPlace, { width, height }: PixelSize): boolean =>
  x >= 0 && y >= 0 && x < width && y < height;

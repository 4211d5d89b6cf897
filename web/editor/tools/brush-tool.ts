/** Brushes: strokes over the model or over its flat texture, by pointer or by keys. */
import type { TemplateResult } from "lit";
import type { IconNode } from "lucide";
import type { SurfaceHit, ToolInput, ToolSample } from "../../viewer/viewer-api.ts";
import { hasRoom } from "../document/layer-tree.ts";
import type { Strings } from "../strings.ts";
import { BrushPreview } from "./brush-preview.ts";
import { PaintCursor } from "./paint-cursor.ts";
import { PenPressure } from "./pen-pressure.ts";
import { type PathStep, PointerPath, ropeOf } from "./pointer-path.ts";
import { handleBrushKey } from "./size-keys.ts";
import type { PaintGesture } from "./stroke-gesture.ts";
import { surfaceJoins } from "./surface-joins.ts";
import type { Tool, ToolId, ToolOption } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

/** A stroke whose finger went less far than this, pixels, when a second one came was meant as the beginning of a pinch. */
const PINCH_SLOP = 16;

/** Of the brush's size: how far an arrow key moves its cursor. */
const KEY_STEP = 0.25;

/** Layers that a stroke may bring: mirrored and cloned, a group, two pictures in it and their masks. */
const MOST_NEW = 5;

/** Where a stroke begins; `hit` is null beside the charts of the flat texture, and `uv` beside the model. */
export interface StrokeStart {
  readonly view: "model" | "texture";
  readonly hit: SurfaceHit | null;
  readonly uv: readonly [number, number] | null;
}

/** What is special to one of the brushes. */
export interface BrushKind {
  readonly id: ToolId;
  readonly label: (strings: Strings) => string;
  readonly icon: IconNode;
  readonly shortcut: string;
  readonly options: readonly ToolOption[];
  /** Of the radius, where the brush begins to fade. */
  inner(): number;
  /** What a press with Alt does, and each move until its release; without it, Alt means nothing. */
  readonly alt?: (start: StrokeStart) => void;
  /** Whether a press without Alt means one with it. */
  readonly armed?: () => boolean;
  /** Null where nothing can be painted; the user is told why. */
  begin(start: StrokeStart): PaintGesture | null;
  /** The brush is over a place now, or over none. */
  readonly over?: (hit: SurfaceHit | null) => void;
  readonly key?: (event: KeyboardEvent) => boolean;
  readonly activate?: () => void;
  readonly deactivate?: () => void;
  readonly renderOptions?: () => TemplateResult;
}

export class BrushTool implements Tool {
  readonly id: ToolId;
  readonly label: (strings: Strings) => string;
  readonly icon: IconNode;
  readonly shortcut: string;
  readonly options: readonly ToolOption[];
  readonly input: ToolInput;
  readonly renderOptions?: () => TemplateResult;
  readonly #kind: BrushKind;
  readonly #context: ToolContext;
  readonly #preview: BrushPreview;
  readonly #cursor: PaintCursor;
  readonly #pen = new PenPressure();
  #gesture: PaintGesture | null = null;
  /** None yet while the stroke's first samples are held back. */
  #path: PointerPath | null = null;
  #start: ToolSample | null = null;
  #wandered = 0;
  #picking = false;
  /** Where the newest stroke ended: Shift draws a straight line from there. */
  #lastPlace: SurfaceHit | null = null;

  constructor(kind: BrushKind, context: ToolContext) {
    ({ id: this.id, label: this.label, icon: this.icon, shortcut: this.shortcut, options: this.options } = kind);
    if (kind.renderOptions) this.renderOptions = kind.renderOptions;
    this.#kind = kind;
    this.#context = context;
    this.#preview = new BrushPreview(context, () => kind.inner());
    this.#cursor = new PaintCursor(context, {
      stepAt: (hit) => Math.max(this.#size() * KEY_STEP, context.viewer.surface.metresPerPixel(hit) * 3),
      moved: (hit) => this.#show(hit),
      begin: (hit) => this.#beginByKey(hit),
      extend: (hit) => this.#extend(hit),
      end: () => this.#finish(),
    });
    this.input = {
      cursor: "crosshair",
      down: (sample) => this.#down(sample),
      move: (samples) => this.#move(samples),
      up: (sample) => this.#up(sample),
      interrupted: (reason) => this.#interrupted(reason),
      hover: (sample) => this.#hover(sample),
    };
  }

  activate(): void {
    this.#kind.activate?.();
  }

  cancel(): boolean {
    const gesture = this.#gesture;
    this.#gesture = null;
    this.#path = null;
    this.#pen.begin();
    gesture?.cancel();
    return gesture !== null;
  }

  finish(): void {
    if (this.#gesture !== null) this.#finish();
  }

  deactivate(): void {
    this.cancel();
    this.#cursor.hide();
    this.#show(null);
    this.#kind.deactivate?.();
  }

  forget(): void {
    this.cancel();
    this.#cursor.hide();
    this.#lastPlace = null;
  }

  key(event: KeyboardEvent, view: "model" | "texture" | null): boolean {
    if (this.#cursor.key(event, view !== null) || this.#kind.key?.(event)) return true;
    const { tools } = this.#context;
    if (!handleBrushKey(event, tools)) return false;
    this.#preview.refresh();
    return true;
  }

  #down(sample: ToolSample): boolean {
    this.#cursor.hide();
    // In the flat view a stroke may begin beside the charts and go on into one.
    if (sample.hit === null && (sample.view.kind === "model" || !isInTexture(sample))) return false;
    const { alt, armed } = this.#kind;
    if (alt && (sample.alt || armed?.())) {
      this.#picking = true;
      alt(startOf(sample));
      return true;
    }
    // A locked layer keeps the press too: the camera turning instead would be a surprise.
    this.#gesture = this.#begin(startOf(sample));
    if (this.#gesture === null) return true;
    this.#start = sample;
    this.#wandered = 0;
    this.#pen.begin();
    this.#paint(this.#pen.take([sample]));
    this.#follow(sample);
    return true;
  }

  #paint(samples: readonly ToolSample[]): void {
    for (const sample of samples) this.#gesture?.extend(this.#path ? this.#path.add(sample) : this.#firstSteps(sample));
  }

  #firstSteps(sample: ToolSample): readonly PathStep[] {
    const { stabiliser, spacing } = this.#context.tools.settings;
    this.#path = new PointerPath(sample, {
      rope: ropeOf(stabiliser),
      joined: surfaceJoins(this.#context.viewer.surface, this.#size() * spacing),
    });
    const straight = sample.shift && this.#lastPlace !== null;
    return straight ? this.#path.lineFrom(this.#lastPlace as SurfaceHit, sample) : this.#path.first(sample);
  }

  #move(samples: readonly ToolSample[]): void {
    const newest = samples.at(-1);
    if (this.#picking && newest !== undefined) this.#kind.alt?.(startOf(newest));
    if (this.#gesture === null || newest === undefined) return;
    this.#paint(this.#pen.take(samples));
    for (const sample of samples) {
      const from = this.#start?.at ?? sample.at;
      this.#wandered = Math.max(this.#wandered, Math.hypot(sample.at.x - from.x, sample.at.y - from.y));
    }
    this.#follow(newest);
  }

  #up(sample: ToolSample): void {
    this.#picking = false;
    if (this.#gesture === null) return;
    this.#paint(this.#pen.end());
    if (this.#path !== null) this.#gesture.extend(this.#path.finish(sample));
    this.#follow(sample);
    this.#finish();
  }

  #interrupted(reason: "lost" | "pinch"): void {
    this.#picking = false;
    if (this.#gesture === null) return;
    // What was painted before the system took the pointer is the user's work.
    if (reason === "pinch" && this.#wandered < PINCH_SLOP) this.cancel();
    else this.#finish();
  }

  #hover(sample: ToolSample | null): void {
    if (sample !== null) this.#cursor.hide();
    else if (this.#cursor.shown) return;
    this.#show(sample?.hit ?? null);
  }

  #follow({ hit }: ToolSample): void {
    this.#show(this.#path === null ? hit : this.#path.last);
  }

  #show(hit: SurfaceHit | null): void {
    this.#preview.show(hit);
    this.#kind.over?.(hit);
  }

  #beginByKey(hit: SurfaceHit): void {
    const start = { view: "model", hit, uv: hit.uv } as const;
    if (this.#kind.alt && this.#kind.armed?.()) {
      this.#kind.alt(start);
      return;
    }
    this.#gesture = this.#begin(start);
    this.#extend(hit);
  }

  #begin(start: StrokeStart): PaintGesture | null {
    const { session, board } = this.#context;
    if (hasRoom(session.recordedDesign, MOST_NEW)) return this.#kind.begin(start);
    board.info(board.strings.tools.fullDesign);
    return null;
  }

  #extend(hit: SurfaceHit): void {
    this.#gesture?.extend([{ hit, pressure: 1 }]);
    this.#lastPlace = hit;
  }

  #finish(): void {
    this.#paint(this.#pen.end());
    const gesture = this.#gesture;
    this.#lastPlace = this.#path?.last ?? this.#lastPlace;
    this.#gesture = null;
    this.#path = null;
    if (gesture === null) return;
    gesture.end();
    const { board } = this.#context;
    if (gesture.full) board.info(board.strings.tools.fullStroke);
  }

  #size(): number {
    return this.#context.tools.settings.size ?? 1;
  }
}

function startOf({ view, at, hit }: ToolSample): StrokeStart {
  return { view: view.kind, hit, uv: view.uvAt(at) };
}

function isInTexture({ view, at }: ToolSample): boolean {
  const uv = view.uvAt(at);
  return uv?.every((part) => part >= 0 && part <= 1) ?? false;
}

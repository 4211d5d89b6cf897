/** Brush and eraser: strokes over the model or over its flat texture, by pointer or by keys. */
import { Brush as BrushIcon, Eraser, type IconNode } from "lucide";
import type { SurfaceHit, ToolInput, ToolSample } from "../../viewer/viewer-api.ts";
import type { Brush } from "../document/index.ts";
import { strings } from "../strings.ts";
import { BrushPreview } from "./brush-preview.ts";
import { mirrorOf } from "./mirror-setting.ts";
import { PaintCursor } from "./paint-cursor.ts";
import { paintTargetOf } from "./paint-target.ts";
import type { PixelProbe } from "./pixel-probe.ts";
import { PointerPath, ropeOf } from "./pointer-path.ts";
import { handleBrushKey } from "./size-keys.ts";
import { StrokeGesture } from "./stroke-gesture.ts";
import { surfaceJoins } from "./surface-joins.ts";
import type { Tool, ToolOption } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";
import { withRecent } from "./tool-settings.ts";

/** A stroke whose finger went less far than this, pixels, when a second one came was meant as the beginning of a pinch. */
const PINCH_SLOP = 16;

/** Of the brush's size: how far an arrow key moves its cursor. */
const KEY_STEP = 0.25;

const KINDS = {
  brush: { icon: BrushIcon, shortcut: "B" },
  eraser: { icon: Eraser, shortcut: "E" },
} as const satisfies Record<string, { icon: IconNode; shortcut: string }>;

export class BrushTool implements Tool {
  readonly id: "brush" | "eraser";
  readonly label: string;
  readonly icon: IconNode;
  readonly shortcut: string;
  readonly options: readonly ToolOption[];
  readonly input: ToolInput;
  readonly #context: ToolContext;
  readonly #probe: PixelProbe;
  readonly #preview: BrushPreview;
  readonly #cursor: PaintCursor;
  #gesture: StrokeGesture | null = null;
  #path: PointerPath | null = null;
  #start: ToolSample | null = null;
  #wandered = 0;
  #picking = false;
  /** Where the newest stroke ended: Shift draws a straight line from there. */
  #lastPlace: SurfaceHit | null = null;

  constructor(id: "brush" | "eraser", context: ToolContext, probe: PixelProbe) {
    this.id = id;
    this.label = strings.tools[id];
    this.icon = KINDS[id].icon;
    this.shortcut = KINDS[id].shortcut;
    const common = ["size", "hardness", "flow", "opacity", "spacing", "stabiliser", "pressure", "mirror"] as const;
    this.options = id === "brush" ? ["color", "tip", ...common, "alphaLock"] : common;
    this.#context = context;
    this.#probe = probe;
    this.#preview = new BrushPreview(context, () => this.#innerShare());
    this.#cursor = new PaintCursor(context, {
      stepAt: (hit) => Math.max(this.#size() * KEY_STEP, context.viewer.surface.metresPerPixel(hit) * 3),
      moved: (hit) => this.#preview.show(hit),
      begin: (hit) => this.#begin() && this.#extend(hit),
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

  deactivate(): void {
    this.#cancel();
    this.#cursor.hide();
    this.#preview.show(null);
  }

  key(event: KeyboardEvent, view: "model" | "texture" | null): boolean {
    if (event.key === "Escape" && this.#gesture !== null) {
      this.#cancel();
      return true;
    }
    if (this.#cursor.key(event, view !== null)) return true;
    const { tools } = this.#context;
    if (!handleBrushKey(event, tools)) return false;
    this.#preview.refresh();
    return true;
  }

  #down(sample: ToolSample): boolean {
    this.#cursor.hide();
    // In the flat view a stroke may begin beside the charts and go on into one.
    if (sample.hit === null && (sample.view.kind === "model" || !isInTexture(sample))) return false;
    if (sample.alt && this.id === "brush") {
      this.#picking = true;
      this.#probe.pick(sample.hit);
      return true;
    }
    // A locked layer keeps the press too: the camera turning instead would be a surprise.
    if (!this.#begin()) return true;
    this.#start = sample;
    this.#wandered = 0;
    const { stabiliser } = this.#context.tools.settings;
    const size = this.#size();
    const { spacing } = this.#context.tools.settings;
    this.#path = new PointerPath(sample, {
      rope: ropeOf(stabiliser),
      joined: surfaceJoins(this.#context.viewer.surface, size * spacing),
    });
    const straight = sample.shift && this.#lastPlace !== null;
    const steps = straight ? this.#path.lineFrom(this.#lastPlace as SurfaceHit, sample) : this.#path.first(sample);
    this.#gesture?.extend(steps);
    this.#follow();
    return true;
  }

  #move(samples: readonly ToolSample[]): void {
    const newest = samples.at(-1);
    if (this.#picking) this.#probe.pick(newest?.hit ?? null);
    if (this.#gesture === null || this.#path === null) return;
    for (const sample of samples) {
      this.#gesture.extend(this.#path.add(sample));
      const from = this.#start?.at ?? sample.at;
      this.#wandered = Math.max(this.#wandered, Math.hypot(sample.at.x - from.x, sample.at.y - from.y));
    }
    this.#follow();
  }

  #up(sample: ToolSample): void {
    this.#picking = false;
    if (this.#gesture === null || this.#path === null) return;
    this.#gesture.extend(this.#path.finish(sample));
    this.#follow();
    this.#finish();
  }

  #interrupted(reason: "lost" | "pinch"): void {
    this.#picking = false;
    if (this.#gesture === null) return;
    // What was painted before the system took the pointer is the user's work.
    if (reason === "pinch" && this.#wandered < PINCH_SLOP) this.#cancel();
    else this.#finish();
  }

  #hover(sample: ToolSample | null): void {
    if (sample !== null) this.#cursor.hide();
    else if (this.#cursor.shown) return;
    this.#preview.show(sample?.hit ?? null);
  }

  #follow(): void {
    this.#preview.show(this.#path?.last ?? null);
  }

  #extend(hit: SurfaceHit): void {
    this.#gesture?.extend([{ hit, pressure: 1 }]);
    this.#lastPlace = hit;
  }

  /** False where nothing can be painted; the user is told why. */
  #begin(): boolean {
    const { session, store, board, tools, reach } = this.#context;
    const erases = this.id === "eraser";
    const { selectedId, editingMask } = store.state;
    const target = paintTargetOf(session.recordedDesign, selectedId, erases, editingMask);
    if (target.kind === "refused") {
      board.info({
        ...strings.tools.refusals[target.reason],
        title: strings.tools.refusals[target.reason].title(target.name),
      });
      return false;
    }
    const { spacing, pressure, opacity, alphaLock, color, recent, mirror } = tools.settings;
    tools.configure({ recent: erases ? recent : withRecent(recent, color) });
    this.#gesture = new StrokeGesture({
      brush: this.#brush(),
      name: this.label,
      size: this.#size(),
      spacing,
      pressure,
      opacity,
      erases,
      alphaLock: alphaLock && !erases,
      mirror: mirrorOf(mirror, store.state.model?.info ?? null),
      target,
      session,
      reach,
    });
    return true;
  }

  #finish(): void {
    const { session, store, board } = this.#context;
    const gesture = this.#gesture;
    this.#lastPlace = this.#path?.last ?? this.#lastPlace;
    this.#gesture = null;
    this.#path = null;
    const layerId = gesture?.end(strings.tools.steps[this.id]) ?? null;
    if (layerId === null) return;
    if (store.state.selectedId !== layerId) session.select(layerId);
    board.announce(strings.tools.painted[this.id]);
  }

  #cancel(): void {
    this.#gesture?.cancel();
    this.#gesture = null;
    this.#path = null;
  }

  #brush(): Brush {
    const { color, flow, hardness, tip, tinted } = this.#context.tools.settings;
    const { assets } = this.#context.session.recordedDesign;
    if (tip !== null && this.id === "brush" && Object.hasOwn(assets, tip)) {
      return { tip: "picture", asset: tip, color: tinted ? color : null, flow };
    }
    return { tip: "round", color: this.id === "eraser" ? "#000000" : color, hardness, flow };
  }

  #size(): number {
    return this.#context.tools.settings.size ?? 1;
  }

  #innerShare(): number {
    const { tip, hardness } = this.#context.tools.settings;
    return tip !== null && this.id === "brush" ? 1 : hardness;
  }
}

function isInTexture({ view, at }: ToolSample): boolean {
  const uv = view.uvAt(at);
  return uv?.every((part) => part >= 0 && part <= 1) ?? false;
}

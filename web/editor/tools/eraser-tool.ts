/** The eraser: of texels on a pixel layer and on the mask that is painted on in pixel mode, of paint and of what a mask shows elsewhere. */
import { Eraser } from "lucide";
import type { ToolInput } from "../../viewer/viewer-api.ts";
import { findLayer } from "../document/index.ts";
import type { Strings } from "../strings.ts";
import { isPixelLayer } from "./pixel-layer.ts";
import type { Tool, ToolOption } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

type InputTool = Tool & { readonly input: ToolInput };

export class EraserTool implements Tool {
  readonly id = "eraser";
  readonly label = (strings: Strings): string => strings.tools.eraser;
  readonly icon = Eraser;
  readonly shortcut = "E";
  readonly input: ToolInput;
  readonly #context: ToolContext;
  readonly #ofPaint: InputTool;
  readonly #ofPixels: InputTool;
  /** The one that has the gesture under way. */
  #held: InputTool | null = null;

  constructor(context: ToolContext, ofPaint: InputTool, ofPixels: InputTool) {
    this.#context = context;
    this.#ofPaint = ofPaint;
    this.#ofPixels = ofPixels;
    this.input = {
      cursor: ofPaint.input.cursor,
      down: (sample) => {
        this.#held = this.#fitting;
        return this.#held.input.down(sample);
      },
      move: (samples) => this.#held?.input.move(samples),
      up: (sample) => this.#held?.input.up(sample),
      interrupted: (reason) => this.#held?.input.interrupted(reason),
      hover: (sample) => this.#fitting.input.hover(sample),
    };
  }

  get options(): readonly ToolOption[] {
    return this.#fitting.options;
  }

  cancel(): boolean {
    const ended = [this.#ofPaint, this.#ofPixels].filter((tool) => tool.cancel?.());
    return ended.length > 0;
  }

  finish(): void {
    this.#held?.finish?.();
  }

  deactivate(): void {
    this.#ofPaint.deactivate?.();
    this.#ofPixels.deactivate?.();
  }

  forget(): void {
    this.#ofPaint.forget?.();
    this.#ofPixels.forget?.();
  }

  key(event: KeyboardEvent, view: "model" | "texture" | null): boolean {
    return this.#fitting.key?.(event, view) ?? false;
  }

  get #fitting(): InputTool {
    const { session, store, tools } = this.#context;
    const { selectedId, editingMask } = store.state;
    const selected = findLayer(session.recordedDesign, selectedId);
    // On a mask it takes back what the pencil shows there, texel by texel too.
    const meansTexels = tools.pixelMode && (editingMask !== null || selected === undefined || isPixelLayer(selected));
    return meansTexels ? this.#ofPixels : this.#ofPaint;
  }
}

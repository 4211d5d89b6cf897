/** A clone stroke under way: what it copies is read while the pointer already moves, and cut to the stroke at its end. */
import { encodePng } from "../../engine/png-encoder.ts";
import type { CloneCopy } from "./clone-copy.ts";
import { type ClonePatch, type CloneTarget, cloneTargetOf, withClone } from "./clone-layer.ts";
import type { PathStep } from "./pointer-path.ts";
import { type PaintGesture, StrokeGesture, type StrokeGestureOptions } from "./stroke-gesture.ts";
import type { ToolContext } from "./tool-context.ts";

const LIVE_SLOT = "clone";

export interface CloneGestureOptions extends Omit<StrokeGestureOptions, "put"> {
  readonly copy: CloneCopy;
  readonly filter: ClonePatch["filter"];
  /** The material that a copy in the flat texture lies on; null: all that the stroke meets. */
  readonly material: number | null;
  /** Takes the work after the release in line. */
  readonly finish: (work: Promise<string | null>) => void;
}

export class CloneGesture implements PaintGesture {
  readonly #context: ToolContext;
  readonly #options: CloneGestureOptions;
  readonly #stroke: StrokeGesture;
  readonly #begun: Promise<void>;
  #shown: Pick<ClonePatch, "asset" | "projector"> | null = null;
  #over = false;
  #target: CloneTarget | null = null;

  /** @param ready when the strokes before are recorded, which are copied too */
  constructor(context: ToolContext, options: CloneGestureOptions, ready: Promise<unknown>) {
    this.#context = context;
    this.#options = options;
    this.#stroke = new StrokeGesture({
      ...options,
      opacity: 1,
      put: (design, stroke) => {
        const [shown, target] = [this.#shown, this.#target];
        return (
          shown &&
          target &&
          withClone(design, target, stroke, this.#patch(shown, stroke.material), this.#context.board.strings.clone)
        );
      },
    });
    this.#begun = ready.then(() => this.#begin());
    // Whoever ends the gesture hears of a fault; here it must not go unhandled.
    this.#begun.catch(() => {});
  }

  get full(): boolean {
    return this.#stroke.full;
  }

  extend(steps: readonly PathStep[]): void {
    this.#stroke.extend(steps);
  }

  end(): void {
    const stroke = this.#stroke.finish();
    if (stroke !== null) this.#options.finish(this.#record(stroke));
    else this.#over = true;
  }

  cancel(): void {
    this.#over = true;
    this.#stroke.cancel();
  }

  async #begin(): Promise<void> {
    const { session, store } = this.#context;
    const target = cloneTargetOf(session.recordedDesign, store.state.selectedId);
    // What the stroke before this one was put into may have been locked since; then this one is a layer of its own.
    this.#target = target.kind === "refused" ? (cloneTargetOf(session.recordedDesign, null) as CloneTarget) : target;
    const { picture, projector } = await this.#options.copy.begin();
    if (this.#over) return;
    const { asset } = await this.#context.library.setLive(await encodePng(picture), LIVE_SLOT);
    if (this.#over) return;
    this.#shown = { asset, projector };
    this.#stroke.refresh();
  }

  /** The group's id; null where nothing was to be copied. */
  async #record(stroke: ReturnType<StrokeGesture["finish"]> & object): Promise<string | null> {
    const { session, library } = this.#context;
    try {
      await this.#begun;
      this.#over = true;
      const thrown = this.#options.copy.end(stroke);
      const target = this.#target;
      if (target === null || thrown === null || thrown.picture.rgba.every((value) => value === 0)) {
        session.cancelPreview();
        return null;
      }
      const { asset } = await library.add(this.#context.board.strings.clone.name, await encodePng(thrown.picture));
      const patch = this.#patch({ asset, projector: thrown.projector }, stroke.material);
      const { design, layerId } = withClone(
        session.recordedDesign,
        target,
        stroke,
        patch,
        this.#context.board.strings.clone,
      );
      session.record(design, this.#context.board.strings.clone.step);
      library.release([asset]);
      return layerId;
    } catch (thrown) {
      session.cancelPreview();
      throw thrown;
    }
  }

  #patch(shown: Pick<ClonePatch, "asset" | "projector">, met: ClonePatch["material"]): ClonePatch {
    const { filter, opacity, mirror, material } = this.#options;
    return { ...shown, material: material ?? met, filter, opacity, mirror };
  }
}

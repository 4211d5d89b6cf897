/** Keys for tools that take a place: arrows move a mark over the surface, Space or Enter takes what lies there. */
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { PaintCursor } from "./paint-cursor.ts";
import type { ToolContext } from "./tool-context.ts";

/** Pixels of the screen that an arrow key goes. */
const STEP = 12;

export class PickCursor {
  readonly #context: Pick<ToolContext, "viewer" | "textureView" | "board" | "store">;
  readonly #cursor: PaintCursor;

  /** `moved`: the mark is at a place now, which is not taken yet. */
  constructor(
    context: Pick<ToolContext, "viewer" | "textureView" | "board" | "store">,
    pick: (hit: SurfaceHit) => void,
    moved: (hit: SurfaceHit) => void = () => {},
  ) {
    this.#context = context;
    this.#cursor = new PaintCursor(context, {
      stepAt: (hit) => context.viewer.surface.metresPerPixel(hit) * STEP,
      moved: (hit) => {
        this.#mark(hit);
        moved(hit);
      },
      begin: pick,
      extend: () => {},
      end: () => {},
    });
  }

  /** `focused`: the focus is in one of the views. True when the key was the cursor's. */
  key(event: KeyboardEvent, focused: boolean): boolean {
    return this.#cursor.key(event, focused);
  }

  get shown(): boolean {
    return this.#cursor.shown;
  }

  hide(): void {
    if (!this.#cursor.shown) return;
    this.#cursor.hide();
    this.#mark(null);
  }

  #mark(hit: SurfaceHit | null): void {
    const { viewer, textureView, store } = this.#context;
    viewer.setMarker(hit);
    textureView.setMarker(hit?.material === store.state.material ? (hit?.uv ?? null) : null);
  }
}

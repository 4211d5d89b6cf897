/** Painting by keys: arrows move a cursor over the surface, Space or Enter paints where it is, for as long as it is held. */
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { windowOf } from "../../viewer/window-of.ts";
import type { ToolContext } from "./tool-context.ts";

export interface PaintCursorHooks {
  /** How far one key press goes, metres. */
  stepAt(hit: SurfaceHit): number;
  moved(hit: SurfaceHit): void;
  begin(hit: SurfaceHit): void;
  extend(hit: SurfaceHit): void;
  end(): void;
}

const DIRECTIONS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** With Shift. */
const COARSE = 4;

export class PaintCursor {
  readonly #context: Pick<ToolContext, "viewer" | "board">;
  readonly #hooks: PaintCursorHooks;
  #hit: SurfaceHit | null = null;
  #heldKey: string | null = null;
  /** Where the held key comes up again: that in which it went down. */
  #window: Window | null = null;

  constructor(context: Pick<ToolContext, "viewer" | "board">, hooks: PaintCursorHooks) {
    this.#context = context;
    this.#hooks = hooks;
  }

  get shown(): boolean {
    return this.#hit !== null;
  }

  hide(): void {
    this.#release();
    this.#hit = null;
  }

  /** `focused`: the focus is in one of the views. True when the key was the cursor's. */
  key(event: KeyboardEvent, focused: boolean): boolean {
    const direction = DIRECTIONS[event.key];
    if (direction !== undefined) {
      if (focused) this.#step(direction, event.shiftKey);
      return true;
    }
    if (event.key !== "Enter" && event.key !== " ") return false;
    if (!focused) return false;
    if (this.#hit === null) {
      // Space may be held for the camera.
      if (event.key === "Enter") this.#show();
      return event.key === "Enter";
    }
    if (this.#heldKey === null) {
      this.#window = windowOf(event.target as Element);
      this.#press(event.key, this.#hit);
    }
    return true;
  }

  #step([right, up]: readonly [number, number], coarse: boolean): void {
    if (this.#hit === null) {
      this.#show();
      return;
    }
    const { viewer } = this.#context;
    const step = this.#hooks.stepAt(this.#hit) * (coarse ? COARSE : 1);
    const lying = viewer.projectorAt(this.#hit, step, 1);
    const moved = viewer.nudge(lying, right * step, up * step);
    const next = moved.kind === "planar" ? viewer.surface.near(moved.position) : null;
    if (next === null) return;
    this.#hit = next;
    if (this.#heldKey !== null) this.#hooks.extend(next);
    this.#hooks.moved(next);
  }

  #show(): void {
    const { viewer, board } = this.#context;
    this.#hit = viewer.surfaceAtCentre();
    if (this.#hit === null) return;
    board.announce(board.strings.tools.cursorShown);
    this.#hooks.moved(this.#hit);
  }

  #press(key: string, hit: SurfaceHit): void {
    this.#heldKey = key;
    this.#window?.addEventListener("keyup", this.#keyUp, { capture: true });
    this.#window?.addEventListener("blur", this.#release);
    this.#hooks.begin(hit);
  }

  readonly #keyUp = (event: KeyboardEvent): void => {
    if (event.key === this.#heldKey) this.#release();
  };

  readonly #release = (): void => {
    if (this.#heldKey === null) return;
    this.#heldKey = null;
    this.#window?.removeEventListener("keyup", this.#keyUp, { capture: true });
    this.#window?.removeEventListener("blur", this.#release);
    this.#hooks.end();
  };
}

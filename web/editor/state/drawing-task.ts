/**
 * Says that the layers are being painted where that lasts: a design of a thousand long strokes takes tens of seconds, and the
 * picture is not whole until then.
 */
import type { Engine } from "../../engine/engine-api.ts";
import type { Tasks } from "./tasks.ts";

/** Milliseconds of drawing before it is a task: most steps take none that anybody sees. */
const PATIENCE = 1000;

export interface DrawingTaskParts {
  readonly engine: Pick<Engine, "idle">;
  readonly tasks: Pick<Tasks, "run">;
  /** In the editor's language of the moment. */
  readonly label: () => string;
}

export class DrawingTask {
  readonly #parts: DrawingTaskParts;
  /** Layers were sent since it was asked last whether all is drawn. */
  #behind = false;
  #following = false;

  constructor(parts: DrawingTaskParts) {
    this.#parts = parts;
  }

  /** To be called when layers were sent that stay: not in each frame of a drag, as each call asks the worker. */
  follow(): void {
    this.#behind = true;
    if (!this.#following) void this.#untilDrawn();
  }

  async #untilDrawn(): Promise<void> {
    const { engine, tasks, label } = this.#parts;
    this.#following = true;
    let end = (): void => {};
    const ended = new Promise<void>((resolve) => {
      end = resolve;
    });
    let timer: ReturnType<typeof setTimeout> | undefined;
    let shown = false;
    while (this.#behind) {
      this.#behind = false;
      // Of many quick steps in a row none is a task, however long they go on.
      clearTimeout(timer);
      timer = setTimeout(() => {
        if (!shown) void tasks.run(label(), () => ended, { cancellable: false });
        shown = true;
      }, PATIENCE);
      // What cannot be drawn the engine tells by itself.
      await engine.idle().catch(() => undefined);
    }
    clearTimeout(timer);
    this.#following = false;
    end();
  }
}

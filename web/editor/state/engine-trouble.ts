/**
 * What the page says of its engine's faults. An engine that had to be started again and cannot be, for want of a connection,
 * is told once, and tried again until it is back. Layers that ask for more memory than there is are told until they no longer do.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Engine } from "../../engine/engine-api.ts";
import { RETRY_MS } from "../../engine/retry-pause.ts";
import type { Design } from "../document/index.ts";
import { ToldError } from "../strings/told-error.ts";
import type { EditorState } from "./editor-state.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { lacksScript } from "./notices.ts";
import type { Store } from "./store.ts";

export interface EngineTroubleParts {
  readonly engine: Pick<Engine, "idle" | "stats">;
  readonly board: NoticeBoard;
  readonly store: Pick<Store<EditorState>, "state" | "subscribe">;
  /** Gives the engine the layers anew, which starts one again that stands still. */
  readonly send: () => void;
  readonly undo: () => void;
}

export class EngineTrouble {
  readonly #parts: EngineTroubleParts;
  /** Says that the engine was started again. */
  #restarted: number | null = null;
  /** Says that it cannot be. */
  #away: number | null = null;
  /** Says that there is no memory for all layers. */
  #full: number | null = null;
  /** The design that was asked of last whether there is; null where that is not told. */
  #tooLarge: Design | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(parts: EngineTroubleParts) {
    this.#parts = parts;
    parts.store.subscribe(() => void this.#lookForRoom());
  }

  /** A crash is over when it is told: the engine's client has brought everything back, or says that it cannot. */
  tell(error: Error): void {
    const { board, store, undo } = this.#parts;
    const { errors, notices } = board.strings;
    const code = error instanceof TexelcastError ? error.code : "";
    if (code === "engine-crashed") {
      this.#restarted = board.info({ title: notices.engineRestarted, message: notices.engineRestartedBody });
    } else if (lacksScript(error)) {
      this.#wait();
    } else if (code === "engine-halted") {
      board.error(errors.engineHalted, error, { label: notices.undoLast, run: undo });
    } else {
      void this.#hasStopped(error).then((stopped) => {
        if (stopped) this.#wait();
        else if (code === "out-of-budget") {
          this.#full = board.error(errors.tooManyLayers, error, { label: notices.undoLast, run: undo });
          this.#tooLarge ??= store.state.design;
        } else board.error(errors.engineFault, error);
      });
    }
  }

  /** Once the design is another, and again after each change that does not make it small enough. */
  async #lookForRoom(): Promise<void> {
    const { board, engine, store } = this.#parts;
    const { design } = store.state;
    if (this.#tooLarge === null || this.#tooLarge === design) return;
    this.#tooLarge = design;
    // Another change may have come meanwhile, which is asked of by itself.
    const fits = await engine.idle().then(
      () => true,
      () => false,
    );
    if (!fits || this.#tooLarge !== design || this.#full === null) return;
    board.dismiss(this.#full);
    this.#full = null;
    this.#tooLarge = null;
  }

  /** Whether the engine stands still because of that error; with others it goes on. */
  async #hasStopped(error: Error): Promise<boolean> {
    return await this.#parts.engine.stats().then(
      () => false,
      (reason: unknown) => reason === error,
    );
  }

  #wait(): void {
    const { board } = this.#parts;
    const { engineAway, engineAwayBody, engineAwayHint, tryAgain } = board.strings.notices;
    if (this.#away === null) {
      // It was too early to say so.
      if (this.#restarted !== null) board.dismiss(this.#restarted);
      this.#restarted = null;
      const told = new ToldError("missing-file", engineAwayBody, { hint: engineAwayHint });
      this.#away = board.error(engineAway, told, { label: tryAgain, run: this.#again });
      addEventListener("online", this.#again);
    }
    clearTimeout(this.#timer);
    this.#timer = setTimeout(this.#again, RETRY_MS);
  }

  /** A try that fails is reported as the first was. */
  readonly #again = (): void => {
    clearTimeout(this.#timer);
    this.#parts.send();
    void this.#look();
  };

  async #look(): Promise<void> {
    const { engine, board } = this.#parts;
    try {
      // What cannot be drawn is no matter of this.
      await engine.idle().catch(() => undefined);
      await engine.stats();
    } catch (reason) {
      if (reason instanceof TexelcastError && reason.code === "disposed") this.#stop();
      return;
    }
    if (this.#away === null) return;
    board.dismiss(this.#away);
    this.#stop();
    board.announce(board.strings.notices.engineBack);
  }

  #stop(): void {
    this.#away = null;
    clearTimeout(this.#timer);
    removeEventListener("online", this.#again);
  }
}

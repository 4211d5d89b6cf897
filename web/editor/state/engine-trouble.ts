/**
 * What the page says of its engine's faults. An engine that had to be started again and cannot be, for want of a connection,
 * is told once, and tried again until it is back.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Engine } from "../../engine/engine-api.ts";
import { RETRY_MS } from "../../engine/retry-pause.ts";
import { ToldError } from "../strings/told-error.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { lacksScript } from "./notices.ts";

export interface EngineTroubleParts {
  readonly engine: Pick<Engine, "idle" | "stats">;
  readonly board: NoticeBoard;
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
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(parts: EngineTroubleParts) {
    this.#parts = parts;
  }

  /** A crash is over when it is told: the engine's client has brought everything back, or says that it cannot. */
  tell(error: Error): void {
    const { board, undo } = this.#parts;
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
        else board.error(errors.engineFault, error);
      });
    }
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

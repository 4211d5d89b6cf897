/** Calls through a MessagePort, both ways: numbered, each answered once or given up, malformed messages ignored and counted. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { type ChannelMessage, readChannelMessage } from "./messages.ts";

export interface PortCallsParts {
  /** Answers the other side's requests, for which nobody waits when `end` is aborted. Throw a TexelcastError to refuse one. */
  readonly answer: (method: string, args: readonly unknown[], end: AbortSignal) => unknown;
  readonly onEvent: (name: string, detail: unknown) => void;
  /** A message was ignored. */
  readonly onIgnored: () => void;
}

interface Waiting {
  readonly resolve: (value: unknown) => void;
  readonly reject: (error: TexelcastError) => void;
  readonly timer: ReturnType<typeof setTimeout>;
}

export class PortCalls {
  readonly #port: MessagePort;
  readonly #parts: PortCallsParts;
  readonly #waiting = new Map<number, Waiting>();
  #nextId = 1;
  #newestAsked = 0;
  readonly #end = new AbortController();

  constructor(port: MessagePort, parts: PortCallsParts) {
    this.#port = port;
    this.#parts = parts;
    port.onmessage = ({ data }) => this.#receive(data);
    port.onmessageerror = () => parts.onIgnored();
  }

  /**
   * Asks the other side. Rejects with the error that it answers, and with "timeout" when it does not answer in time: what
   * it answers later is ignored and counted.
   */
  call(method: string, args: readonly unknown[], timeoutMs: number): Promise<unknown> {
    const { signal } = this.#end;
    if (signal.aborted) return Promise.reject(signal.reason);
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => {
        this.#waiting.delete(id);
        reject(
          new TexelcastError("timeout", `The editor did not answer “${method}” within ${timeoutMs / 1000} seconds.`, {
            field: method,
            value: String(timeoutMs),
            hint: "Try again, or allow more time by “timeoutMs”.",
          }),
        );
      }, timeoutMs);
      this.#waiting.set(id, { resolve, reject, timer });
      try {
        this.#send({ kind: "request", id, method, args });
      } catch (cause) {
        clearTimeout(timer);
        this.#waiting.delete(id);
        const message = `What was given to “${method}” cannot be sent to another page.`;
        reject(new TexelcastError("bad-argument", message, { field: method, hint: "Give plain data.", cause }));
      }
    });
  }

  /** Tells the other side something that has no answer. */
  tell(name: string, detail: unknown): void {
    if (!this.#end.signal.aborted) this.#send({ kind: "event", name, detail });
  }

  /** Closes the channel; what waits, and every later call, rejects with the error. */
  end(error: TexelcastError): void {
    if (this.#end.signal.aborted) return;
    this.#end.abort(error);
    this.#port.close();
    for (const { reject, timer } of this.#waiting.values()) {
      clearTimeout(timer);
      reject(error);
    }
    this.#waiting.clear();
  }

  #send(message: ChannelMessage): void {
    this.#port.postMessage(message);
  }

  #receive(data: unknown): void {
    const message = readChannelMessage(data);
    // Ids only grow: a request that came before is a repetition.
    if (message === null || (message.kind === "request" && message.id <= this.#newestAsked)) {
      this.#parts.onIgnored();
    } else if (message.kind === "event") {
      this.#parts.onEvent(message.name, message.detail);
    } else if (message.kind === "request") {
      this.#newestAsked = message.id;
      void this.#answer(message.id, message.method, message.args);
    } else {
      this.#settle(message);
    }
  }

  #settle(answer: Extract<ChannelMessage, { kind: "result" | "failure" }>): void {
    const waiting = this.#waiting.get(answer.id);
    if (waiting === undefined) {
      this.#parts.onIgnored();
      return;
    }
    this.#waiting.delete(answer.id);
    clearTimeout(waiting.timer);
    if (answer.kind === "result") waiting.resolve(answer.value);
    else waiting.reject(TexelcastError.from(answer.error));
  }

  async #answer(id: number, method: string, args: readonly unknown[]): Promise<void> {
    const { signal } = this.#end;
    try {
      const value = await this.#parts.answer(method, args, signal);
      if (!signal.aborted) this.#send({ kind: "result", id, value });
    } catch (thrown) {
      const error = isOurs(thrown)
        ? thrown
        : new TexelcastError("internal", `“${method}” failed: ${String(thrown)}`, { cause: thrown });
      if (!signal.aborted) this.#send({ kind: "failure", id, error: error.toJSON() });
    }
  }
}

/**
 * A TexelcastError of any copy of the package: an editor's page may take the element from standalone.js, whose class is another
 * than this script's.
 */
function isOurs(thrown: unknown): thrown is Pick<TexelcastError, "toJSON"> {
  return thrown instanceof Error && /^(Texelcast|Abort)Error$/.test(thrown.name) && "toJSON" in thrown;
}

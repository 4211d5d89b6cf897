/** A worker without a thread: the engine's server on the other end of a MessageChannel, so messages are really cloned. */
import type { ClientMessage } from "../../web/engine/engine-protocol.ts";
import { type ServerPort, serveEngine } from "../../web/engine/engine-server.ts";

export class ThreadWorker {
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  onmessageerror: ((event: MessageEvent) => void) | null = null;
  /** What the client sent, in order. */
  readonly received: ClientMessage[] = [];
  terminated = false;
  readonly #channel = new MessageChannel();

  /** `serve` false makes a worker that never answers. */
  constructor(serve = true) {
    this.#channel.port1.onmessage = (event) => this.onmessage?.(event);
    if (serve) serveEngine(this.#channel.port2 as unknown as ServerPort);
  }

  postMessage(message: ClientMessage): void {
    this.received.push(message);
    this.#channel.port1.postMessage(message);
  }

  terminate(): void {
    this.terminated = true;
    this.#channel.port1.close();
    this.#channel.port2.close();
  }

  /** From here on it neither hears nor says anything, as a thread that was ended. */
  silence(): void {
    this.#channel.port1.onmessage = null;
    this.#channel.port2.close();
  }

  /** What a browser reports when a worker's script fails. */
  fail(message: string): void {
    this.onerror?.({ message } as ErrorEvent);
  }
}

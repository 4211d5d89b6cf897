/** A call of the engine's client that its worker has not answered yet. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import type { Call } from "./engine-protocol.ts";

export interface CallOptions {
  readonly onProgress?: ((share: number) => void) | undefined;
  readonly signal?: AbortSignal | undefined;
  readonly replay?: boolean;
}

export interface PendingCall {
  readonly call: Call;
  readonly resolve: (value: never) => void;
  readonly reject: (error: TexelcastError) => void;
  readonly onProgress?: ((share: number) => void) | undefined;
  readonly signal?: AbortSignal | undefined;
  /** Part of a replay: a later crash replays anew. */
  readonly replay: boolean;
  attempts: number;
}

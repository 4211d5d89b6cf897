/** A worker that unwraps one model: to cut and pack charts takes seconds, and ends when the page says so. */
import { TexelcastError, type TexelcastErrorJson } from "../../core/texelcast-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { unwrapModel } from "../../engine/unwrap/unwrap-model.ts";

export interface UnwrapWork {
  readonly source: ModelSource;
  readonly materials: readonly number[];
  readonly size: number;
}

export type UnwrapAnswer =
  | { readonly share: number }
  | { readonly glb: Uint8Array<ArrayBuffer> }
  | { readonly error: TexelcastErrorJson };

const port = self as unknown as Pick<Worker, "postMessage"> & {
  onmessage: ((event: MessageEvent<UnwrapWork>) => void) | null;
};

port.onmessage = async ({ data: { source, materials, size } }) => {
  const answer = (message: UnwrapAnswer, transfer: Transferable[] = []): void => port.postMessage(message, transfer);
  try {
    const { glb } = await unwrapModel(source, { materials, size, onProgress: (share) => answer({ share }) });
    answer({ glb }, [glb.buffer]);
  } catch (thrown) {
    answer({ error: TexelcastError.wrap(thrown, "internal", String(thrown)).toJSON() });
  }
};

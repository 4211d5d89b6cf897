/** Unwraps models beside the page's thread, which is loaded when it is first asked for: few models need it. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import type { UnwrapAnswer, UnwrapWork } from "./unwrap-worker.ts";
import { workerFault } from "./worker-fault.ts";

/** The unwrapped model as a GLB. Rejects with a TexelcastError; once aborted, with "cancelled". */
export async function unwrapInWorker(
  source: ModelSource,
  options: { readonly materials: readonly number[]; readonly size: number },
  task: { readonly signal: AbortSignal; progress(share: number): void },
  strings: Strings,
): Promise<Uint8Array<ArrayBuffer>> {
  const { unwrapFailed, cancelled } = strings.errors;
  const worker = new Worker(new URL("./unwrap-worker.ts", import.meta.url), {
    type: "module",
    name: "texelcast-unwrap",
  });
  try {
    return await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<UnwrapAnswer>) => {
        if ("share" in data) task.progress(data.share);
        else if ("glb" in data) resolve(data.glb);
        else reject(TexelcastError.from(data.error));
      };
      worker.onerror = (event) => reject(workerFault(event, unwrapFailed, source.name, strings));
      worker.onmessageerror = () => reject(new ToldError("internal", unwrapFailed(""), { subject: source.name }));
      const cancel = (): void => reject(new ToldError("cancelled", cancelled));
      if (task.signal.aborted) cancel();
      task.signal.addEventListener("abort", cancel);
      worker.postMessage({ source, ...options } satisfies UnwrapWork);
    });
  } finally {
    worker.terminate();
  }
}

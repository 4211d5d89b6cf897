/** Packs projects beside the page's thread. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { strings } from "../strings.ts";
import type { PackingAnswer, ProjectToPack } from "./project-packing.ts";

/**
 * The bytes of a project's file. Rejects with a TexelcastError: what is wrong with the project, "internal" where the worker
 * cannot run, and "cancelled".
 */
export async function packInWorker(project: ProjectToPack, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer>> {
  // A worker of the page's own, not of a blob: address, which a shop's content security policy refuses.
  const worker = new Worker(new URL("./project-packer-worker.ts", import.meta.url), {
    type: "module",
    name: "texelcast-project",
  });
  try {
    const answer = await new Promise<PackingAnswer>((resolve, reject) => {
      const fail = (reason: string): void =>
        reject(new TexelcastError("internal", strings.projects.packerFailed(reason), { subject: project.name }));
      worker.onmessage = ({ data }: MessageEvent<PackingAnswer>) => resolve(data);
      worker.onerror = (event) => fail(event.message);
      worker.onmessageerror = () => fail("");
      signal.addEventListener("abort", () => reject(new TexelcastError("cancelled", strings.errors.cancelled)));
      worker.postMessage(project);
    });
    if ("error" in answer) throw TexelcastError.from(answer.error);
    return answer.bytes;
  } finally {
    worker.terminate();
  }
}

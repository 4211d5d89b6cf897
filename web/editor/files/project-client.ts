/** Packs and unpacks projects and archives beside the page's thread. */

import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import type { UnzippedFile } from "./archive-files.ts";
import type { ProjectAnswer, ProjectToPack, ProjectWork, UnpackedProject } from "./project-packing.ts";
import { workerFault } from "./worker-fault.ts";

/**
 * The bytes of a project's file. Rejects with a TexelcastError: what is wrong with the project, "internal" where the worker
 * cannot run, "missing-file" where its script cannot be fetched, and "cancelled".
 */
export async function packInWorker(
  project: ProjectToPack,
  signal: AbortSignal,
  strings: Strings,
): Promise<Uint8Array<ArrayBuffer>> {
  const { packerFailed: failed } = strings.projects;
  const answer = await askWorker({ pack: project }, project.name, failed, signal, strings);
  if ("packed" in answer) return answer.packed;
  throw new ToldError("internal", failed(""), { subject: project.name });
}

/** A project's file, all of it inflated and checked. Rejects as `packInWorker`, with what is wrong with the file. */
export async function unpackInWorker(
  bytes: Uint8Array,
  fileName: string,
  signal: AbortSignal,
  strings: Strings,
): Promise<UnpackedProject> {
  const work = { unpack: { bytes, fileName } };
  const { unpackerFailed: failed } = strings.projects;
  const answer = await askWorker(work, fileName, failed, signal, strings);
  if ("unpacked" in answer) return answer.unpacked;
  throw new ToldError("internal", failed(""), { subject: fileName });
}

/** What `unzipFiles` finds in an archive. Rejects as `packInWorker`, with what is wrong with the archive. */
export async function unzipInWorker(
  bytes: Uint8Array<ArrayBuffer>,
  path: string,
  signal: AbortSignal,
  strings: Strings,
): Promise<readonly UnzippedFile[]> {
  const { couldNotUnzip: failed } = strings.errors;
  const answer = await askWorker({ unzip: { bytes, path } }, path, failed, signal, strings);
  if ("unzipped" in answer) return answer.unzipped;
  throw new ToldError("internal", failed(""), { subject: path });
}

async function askWorker(
  work: ProjectWork,
  subject: string,
  failed: (reason: string) => string,
  signal: AbortSignal,
  strings: Strings,
): Promise<Exclude<ProjectAnswer, { error: unknown }>> {
  // A worker of the page's own, not of a blob: address, which a shop's content security policy refuses.
  const worker = new Worker(new URL("./project-worker.ts", import.meta.url), {
    type: "module",
    name: "texelcast-project",
  });
  try {
    const answer = await new Promise<ProjectAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<ProjectAnswer>) => resolve(data);
      worker.onerror = (event) => reject(workerFault(event, failed, subject, strings));
      worker.onmessageerror = () => reject(new ToldError("internal", failed(""), { subject }));
      const cancel = (): void => reject(new ToldError("cancelled", strings.errors.cancelled));
      if (signal.aborted) cancel();
      signal.addEventListener("abort", cancel);
      worker.postMessage(work);
    });
    if ("error" in answer) throw TexelcastError.from(answer.error);
    return answer;
  } finally {
    worker.terminate();
  }
}

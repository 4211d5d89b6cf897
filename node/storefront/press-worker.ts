/** The press's thread: one job after the other, its answer or its error as plain data. It reads no files and knows no shop. */
import { parentPort } from "node:worker_threads";
import { TexelcastError, type TexelcastErrorJson } from "../../web/core/texelcast-error.ts";
import type { PrintFile, PrintReport } from "../../web/engine/print-report.ts";
import { checkPrint, type PrintAsset, type PrintSubject, renderPrint } from "../print.ts";

export interface PressJob {
  readonly kind: "print" | "measure";
  readonly subject: PrintSubject & { readonly assets: readonly PrintAsset[] };
  /** glTF index of the material that is printed. */
  readonly material: number;
}

export type PressAnswer = { readonly value: PrintFile | PrintReport } | { readonly error: TexelcastErrorJson };

const work = ({ kind, subject, material }: PressJob): Promise<PrintFile | PrintReport> =>
  kind === "print" ? renderPrint({ ...subject, material }) : checkPrint(subject);

parentPort?.on("message", async (job: PressJob) => {
  let answer: PressAnswer;
  try {
    answer = { value: await work(job) };
  } catch (thrown) {
    const error = TexelcastError.wrap(thrown, "press-failed", `the press could not ${job.kind} it: ${String(thrown)}`);
    answer = { error: error.toJSON() };
  }
  parentPort?.postMessage(answer);
});

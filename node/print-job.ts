/** A design on a model, ready in an engine to be printed or measured: what the command line and the package share. */
import { checkAsset } from "../web/editor/document/asset-check.ts";
import type { Design } from "../web/editor/document/index.ts";
import type { EngineLayer, ModelInfo, ModelSource } from "../web/engine/engine-api.ts";
import { cancelled } from "../web/engine/engine-faults.ts";
import type { EngineHost } from "../web/engine/engine-host.ts";
import { fontsOf, picturesOf } from "../web/engine/layer-picture.ts";
import type { PrintZones } from "../web/engine/print-zones.ts";
import { checkFit } from "./check-fit.ts";
import { namingModel } from "./name-model.ts";
import { namingText } from "./name-text.ts";
import { openEngine } from "./open-engine.ts";

export interface PrintJob {
  readonly model: ModelSource;
  readonly design: Design;
  /** What errors call the design. */
  readonly file: string;
  /** The design's. */
  readonly layers: readonly EngineLayer[];
  /** Bytes of one of the design's pictures or fonts. */
  readonly readAsset: (key: string) => Promise<{ readonly name: string; readonly bytes: Uint8Array }>;
  readonly zones: PrintZones | null;
  /** Who has enough of it waits for no file any more. */
  readonly signal?: AbortSignal | undefined;
}

/** Runs `use` on an engine that has the model, the pictures, the layers and the zones; what it reports is thrown. */
export async function withPrintJob<Result>(
  job: PrintJob,
  use: (engine: EngineHost, model: ModelInfo) => Promise<Result>,
): Promise<Result> {
  const engine = openEngine();
  try {
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    const model = await namingModel(job.model.name, engine.loadModel(job.model));
    checkFit(model, job.design, job.file);
    const layers: readonly EngineLayer[] = job.layers.filter((layer) => layer.visible);
    for (const key of picturesOf(layers)) await engine.setAsset(key, await readChecked(job, key));
    for (const key of fontsOf(layers)) await engine.setFont(key, await readChecked(job, key));
    await engine.setZones(job.zones);
    engine.setLayers(layers, 1);
    const work = async (): Promise<Result> => {
      const result = await namingModel(job.model.name, use(engine, model));
      if (errors[0] !== undefined) throw errors[0];
      return result;
    };
    return await namingText(job.design, job.file, work());
  } finally {
    engine.dispose();
  }
}

/** How large a picture may be is the shop's own affair, and in the end the engine's budget. */
const UNLIMITED = { bytes: Number.POSITIVE_INFINITY, megapixels: Number.POSITIVE_INFINITY };

/** What the page would not take is not printed either, whoever wrote the design; what it takes is the same bytes. */
async function readChecked({ design, readAsset, signal }: PrintJob, key: string): ReturnType<PrintJob["readAsset"]> {
  const { name, bytes } = await unlessCancelled(signal, () => readAsset(key));
  const asset = design.assets[key];
  return { name, bytes: asset === undefined ? bytes : await checkAsset(key, asset, bytes, UNLIMITED, name) };
}

/** What `work` gives, which is not begun where the signal is aborted already, and not waited for once it is. */
async function unlessCancelled<Result>(signal: AbortSignal | undefined, work: () => Promise<Result>): Promise<Result> {
  if (signal === undefined) return work();
  if (signal.aborted) throw cancelled();
  let stop = (): void => {};
  const end = new Promise<never>((_, reject) => {
    stop = () => reject(cancelled());
  });
  signal.addEventListener("abort", stop);
  try {
    return await Promise.race([work(), end]);
  } finally {
    signal.removeEventListener("abort", stop);
  }
}

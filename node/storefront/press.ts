/**
 * The engine at work for the shop, on a thread of its own: print files, and what of a product is printed. The page's own bytes and
 * numbers. A job that ends the thread, or never ends, is an error of that job; the next one gets a new thread.
 */
import { Worker } from "node:worker_threads";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { Design } from "../../web/editor/document/index.ts";
import type { PrintFile, PrintReport } from "../../web/engine/print-report.ts";
import type { Product } from "../../web/storefront/api/shop-api.ts";
import type { AssetStore } from "./asset-store.ts";
import type { Catalogue } from "./catalogue.ts";
import { fileOfAddress } from "./line-intake.ts";
import type { PressAnswer, PressJob } from "./press-worker.ts";

export interface PressOptions {
  /** The thread's script; default: the one that is built beside this one. */
  readonly script?: URL;
  /** Milliseconds that a job may take; default ten minutes for a print, and one for a measurement, which somebody waits for. */
  readonly patience?: number;
}

const PATIENCE_MS = { print: 600_000, measure: 60_000 } as const;
/** Mebibytes of JavaScript's own memory; the engine's lies outside of it, and has a budget of its own. */
const HEAP_MIB = 2048;
const HINT = "Nothing was printed. Ask the shop, with the order's number.";

export class Press {
  readonly #catalogue: Catalogue;
  readonly #store: AssetStore;
  readonly #script: URL;
  readonly #patience: Readonly<Record<PressJob["kind"], number>>;
  #worker: Worker | null = null;
  #ended = false;
  #last: Promise<unknown> = Promise.resolve();

  constructor(catalogue: Catalogue, store: AssetStore, { script, patience }: PressOptions = {}) {
    this.#catalogue = catalogue;
    this.#store = store;
    this.#script = script ?? new URL("./storefront-press.mjs", import.meta.url);
    this.#patience = patience === undefined ? PATIENCE_MS : { print: patience, measure: patience };
  }

  /**
   * The print file of a design as a cart keeps it: its assets' addresses are those of stored files. Throws as
   * `renderPrint` does; "press-failed" where the thread ended, "timeout" where it was ended.
   */
  async print(product: Product, design: Design): Promise<PrintFile> {
    return (await this.#inTurn("print", product, design)) as PrintFile;
  }

  /** What becomes of each layer on the product. Throws as `checkPrint` does, and as `print`. */
  async measure(product: Product, design: Design): Promise<PrintReport> {
    return (await this.#inTurn("measure", product, design)) as PrintReport;
  }

  /** Ends the thread; what it works on fails, and so does what waits for it: nobody is there to take it. */
  async end(): Promise<void> {
    this.#ended = true;
    await this.#worker?.terminate();
  }

  /** One after the other: each takes a core and some hundred megabytes. */
  #inTurn(kind: PressJob["kind"], product: Product, design: Design): Promise<PrintFile | PrintReport> {
    const work = async () =>
      this.#run({ kind, material: product.material, subject: await this.#subject(product, design) });
    const done = this.#last.then(work, work);
    this.#last = done.catch(() => undefined);
    return done;
  }

  /** All that the thread needs, so that what reads files is here alone. */
  async #subject(product: Product, design: Design): Promise<PressJob["subject"]> {
    const [model, zones] = [await this.#catalogue.modelOf(product), await this.#catalogue.zonesOf(product)];
    const files = new Map<string, string>();
    for (const { uri } of Object.values(design.assets)) {
      const file = fileOfAddress(uri);
      if (file !== null) files.set(uri, file);
    }
    const assets = [...files].map(async ([name, file]) => ({ name, bytes: await this.#store.read(file) }));
    return { model, zones, design, assets: await Promise.all(assets) };
  }

  #run(job: PressJob): Promise<PrintFile | PrintReport> {
    if (this.#ended) return Promise.reject(pressFailed("the press was ended with the server"));
    this.#worker ??= this.#start();
    const worker = this.#worker;
    const patience = this.#patience[job.kind];
    return new Promise((resolve, reject) => {
      const settle = (end: () => void): void => {
        clearTimeout(timer);
        worker.off("message", answered).off("error", failed).off("exit", ended).unref();
        end();
      };
      const answered = (answer: PressAnswer): void =>
        settle(() => ("error" in answer ? reject(TexelcastError.from(answer.error)) : resolve(answer.value)));
      const failed = (error: Error): void =>
        settle(() => reject(pressFailed(`the press failed: ${error.message}`, error)));
      const ended = (code: number): void => settle(() => reject(pressFailed(`the press ended with code ${code}`)));
      const timer = setTimeout(() => {
        this.#worker = null;
        const message = `the press was ended after ${patience / 1000} seconds`;
        settle(() => reject(new TexelcastError("timeout", message, { field: job.kind, hint: HINT })));
        void worker.terminate();
      }, patience);
      // While it works it keeps the process; while it waits it does not.
      worker.on("message", answered).on("error", failed).on("exit", ended).ref();
      worker.postMessage(job);
    });
  }

  #start(): Worker {
    const worker = new Worker(this.#script, { resourceLimits: { maxOldGenerationSizeMb: HEAP_MIB } });
    const gone = (): void => {
      if (this.#worker === worker) this.#worker = null;
    };
    // Also where no job waits: an error that nobody hears would end the server.
    return worker.on("error", gone).on("exit", gone);
  }
}

const pressFailed = (message: string, cause?: Error): TexelcastError =>
  new TexelcastError("press-failed", message, { hint: HINT, cause });

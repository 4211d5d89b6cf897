/**
 * The engine as the page sees it: the same interface as the host's, served by a worker, so that the page's thread never
 * waits. The client remembers what the engine was told (model, pictures, targets, layers); a worker that crashes, ends or
 * hangs is replaced and told again, and asked again what it had not answered yet.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { CoreSource } from "../core/wasm-module.ts";
import { checkFile } from "./check-file.ts";
import type {
  Engine,
  EngineLayer,
  EngineStats,
  EngineText,
  ExpectedChange,
  MapView,
  ModelInfo,
  ModelSource,
  Picture,
  TargetInfo,
  TargetOptions,
  TargetUpdate,
  TextMeasure,
} from "./engine-api.ts";
import { cancelled, crashError, disposed, haltError, notSendable } from "./engine-faults.ts";
import type { Call, CallArguments, CallName, CallResult, ClientMessage, WorkerMessage } from "./engine-protocol.ts";
import { foreignWorker, isForeign } from "./foreign-worker.ts";
import type { CallOptions, PendingCall } from "./pending-call.ts";
import type { PrintFile, PrintFileOptions, PrintMapKind, PrintReport } from "./print-report.ts";
import type { PrintZones } from "./print-zones.ts";
import { LayerSender } from "./sent-layers.ts";
import { tellAll } from "./tell-all.ts";
import { sendable } from "./worker-address.ts";
import { WorkerWatch } from "./worker-watch.ts";

export interface EngineClientOptions {
  /**
   * The core's WebAssembly: an address relative to the page, its bytes, or compiled. Default: texelcast.wasm beside the
   * worker's script.
   */
  readonly wasm?: CoreSource;
  /** What the engine may hold at once, MiB; default 1024. */
  readonly memoryBudgetMib?: number;
  /** Makes the worker; default: engine-worker.ts as a module worker, in a form that bundlers recognise. */
  readonly createWorker?: () => Worker;
}

/** Starts an engine in a worker of its own. */
export function createEngineClient(options: EngineClientOptions = {}): Engine {
  return new EngineClient(options);
}

/** So many crashes within this time, none of them followed by a whole picture, are not cured by another restart. */
const MAX_CRASHES = 3;
const CRASH_WINDOW_MS = 60_000;
/** A call that was under way in two crashes is taken for their reason. */
const MAX_ATTEMPTS = 2;

/** A copy of a file that its caller may go on to change. */
function ownFile(file: { readonly name: string; readonly bytes: Uint8Array }): { name: string; bytes: Uint8Array } {
  checkFile(file);
  return { name: file.name, bytes: copyOf(file.bytes) };
}

/** What was given away to another thread has no length and no copy: that it cannot be sent is told when it is. */
const copyOf = (bytes: Uint8Array): Uint8Array => (bytes.length ? bytes.slice() : bytes);

class EngineClient implements Engine {
  readonly #options: EngineClientOptions;
  #worker: Worker | null = null;
  #ended: TexelcastError | null = null;
  #nextId = 1;
  readonly #pending = new Map<number, PendingCall>();
  readonly #updateListeners = new Set<(update: TargetUpdate) => void>();
  readonly #errorListeners = new Set<(error: Error) => void>();

  // What a new worker must be told.
  #model: ModelSource | null = null;
  readonly #assets = new Map<string, { readonly name: string; readonly bytes: Uint8Array }>();
  readonly #fonts = new Map<string, { readonly name: string; readonly bytes: Uint8Array }>();
  readonly #targets = new Map<number, TargetOptions>();
  #zones: PrintZones | null = null;
  #layers: { readonly layers: readonly EngineLayer[]; readonly revision: number } | null = null;

  #expected: ExpectedChange | null = null;

  /** What the worker has of the layers. */
  #sender = new LayerSender();
  /** The worker has a list of layers that it has not drawn yet; waiting is one that was not sent yet. */
  #layersUnderWay = false;
  #layersWaiting = false;
  /** Times of crashes since a worker last drew everything. */
  #crashes: number[] = [];
  /** Why no worker is started until there is something else to draw. */
  #halted: TexelcastError | null = null;
  #watch: WorkerWatch | null = null;

  constructor(options: EngineClientOptions) {
    this.#options = options;
    this.#startWorker();
  }

  async loadModel(source: ModelSource): Promise<ModelInfo> {
    const kept = {
      ...ownFile(source),
      resources: new Map([...(source.resources ?? [])].map(([uri, bytes]) => [uri, copyOf(bytes)] as const)),
    };
    const halted = this.#halted !== null;
    const model = this.#model;
    const layers = this.#layers;
    if (halted) {
      // Another model: nothing of the old one is told again, unless the other cannot be loaded.
      this.#model = null;
      this.#layers = null;
      this.#restart();
    }
    try {
      const info = await this.#call("loadModel", [kept]);
      this.#model = kept;
      this.#targets.clear();
      return info;
    } catch (error) {
      if (halted) {
        this.#model = model;
        this.#layers ??= layers;
        this.#replay();
      }
      throw error;
    }
  }

  async setAsset(
    key: string,
    asset: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ width: number; height: number }> {
    const kept = ownFile(asset);
    const size = await this.#call("setAsset", [key, kept]);
    this.#assets.set(key, kept);
    return size;
  }

  async removeAsset(key: string): Promise<void> {
    await this.#call("removeAsset", [key]);
    this.#assets.delete(key);
    this.#fonts.delete(key);
  }

  async setFont(
    key: string,
    font: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ readonly name: string }> {
    const kept = ownFile(font);
    const info = await this.#call("setFont", [key, kept]);
    this.#fonts.set(key, kept);
    return info;
  }

  measureText(text: EngineText): Promise<TextMeasure> {
    return this.#call("measureText", [text]);
  }

  async openTarget(
    options: TargetOptions,
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
  ): Promise<TargetInfo> {
    const base = options?.base as ModelSource;
    const kept: TargetOptions = { ...options, ...("bytes" in Object(base) && { base: ownFile(base) }) };
    const info = await this.#call("openTarget", [kept], { onProgress, signal });
    this.#targets.set(kept.material, kept);
    return info;
  }

  async closeTarget(material: number): Promise<void> {
    await this.#call("closeTarget", [material]);
    this.#targets.delete(material);
  }

  setLayers(layers: readonly EngineLayer[], revision: number): void {
    if (this.#ended !== null) return;
    const other = layers !== this.#layers?.layers;
    this.#layers = { layers, revision };
    this.#layersWaiting = true;
    if (this.#halted !== null) {
      // Something else to draw: what crashed before may be gone (an undo).
      if (other) this.#restart();
      return;
    }
    if (!this.#layersUnderWay) this.#sendLayers();
  }

  expect(change: ExpectedChange | null): void {
    this.#expected = change;
    this.#send({ type: "expect", change });
  }

  onUpdate(listener: (update: TargetUpdate) => void): () => void {
    this.#updateListeners.add(listener);
    return () => this.#updateListeners.delete(listener);
  }

  onError(listener: (error: Error) => void): () => void {
    this.#errorListeners.add(listener);
    return () => this.#errorListeners.delete(listener);
  }

  idle(): Promise<void> {
    return this.#call("idle", []);
  }

  viewMap(material: number, view: MapView): Promise<Picture> {
    return this.#call("viewMap", [material, view]);
  }

  uvTriangles(material: number): Promise<Float32Array> {
    return this.#call("uvTriangles", [material]);
  }

  readTexels(material: number, x: number, y: number, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
    return this.#call("readTexels", [material, x, y, width, height]);
  }

  layerMiniature(id: string, of: "layer" | "mask", side: number): Promise<Uint8Array<ArrayBuffer> | null> {
    return this.#call("layerMiniature", [id, of, side]);
  }

  hash(material: number, region?: { x: number; y: number; width: number; height: number }): Promise<string> {
    return this.#call("hash", [material, region]);
  }

  exportPng(material: number): Promise<Uint8Array<ArrayBuffer>> {
    return this.#call("exportPng", [material]);
  }

  exportGlb(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>> {
    return this.#call("exportGlb", [materials]);
  }

  exportUsdz(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>> {
    return this.#call("exportUsdz", [materials]);
  }

  async setZones(zones: PrintZones | null): Promise<void> {
    await this.#call("setZones", [zones]);
    this.#zones = zones;
  }

  printReport(): Promise<PrintReport> {
    return this.#call("printReport", []);
  }

  printMap(material: number, kind: PrintMapKind): Promise<Picture> {
    return this.#call("printMap", [material, kind]);
  }

  exportPrint(
    options: PrintFileOptions = {},
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
  ): Promise<PrintFile> {
    return this.#call("exportPrint", [options], { onProgress, signal });
  }

  stats(): Promise<EngineStats> {
    return this.#call("stats", []);
  }

  dispose(): void {
    this.#ended = disposed();
    this.#rejectAll(this.#ended);
    this.#updateListeners.clear();
    this.#errorListeners.clear();
  }

  #call<Name extends CallName>(
    name: Name,
    args: CallArguments<Name>,
    { onProgress, signal, replay = false }: CallOptions = {},
  ): Promise<CallResult<Name>> {
    const dead = this.#ended ?? this.#halted;
    if (dead !== null) return Promise.reject(dead);
    if (signal?.aborted) return Promise.reject(cancelled());
    // The call must see the newest layers, also those that wait for their turn.
    if (this.#layersWaiting) this.#sendLayers();
    const id = this.#nextId++;
    const cancel = (): void => this.#send({ type: "cancel", id });
    signal?.addEventListener("abort", cancel);
    const call = { name, args } as unknown as Call;
    const result = new Promise<CallResult<Name>>((resolve, reject) => {
      const settle = resolve as (value: never) => void;
      this.#pending.set(id, { call, resolve: settle, reject, onProgress, signal, replay, attempts: 1 });
    });
    try {
      this.#send({ type: "call", id, call });
    } catch (thrown) {
      this.#settle(id)?.reject(notSendable(name, thrown));
    }
    return result.finally(() => signal?.removeEventListener("abort", cancel));
  }

  #send(message: ClientMessage): void {
    this.#worker?.postMessage(message);
  }

  #sendLayers(): void {
    if (this.#layers === null) return;
    this.#layersWaiting = false;
    const { layers, revision } = this.#layers;
    try {
      this.#send({ type: "layers", layers: this.#sender.pack(layers), revision });
    } catch {
      // No layers, or such as no worker can be sent: with functions, or a framework's proxies. What is plain of them goes.
      this.#sender = new LayerSender();
      let plain: unknown;
      try {
        plain = JSON.parse(JSON.stringify(layers));
      } catch {
        // What holds itself has no plain form: nothing goes, and is refused as no list.
      }
      this.#send({ type: "unreadable", layers: plain as EngineLayer[], revision });
    }
    this.#layersUnderWay = true;
  }

  #startWorker(): void {
    const { createWorker, wasm, memoryBudgetMib } = this.#options;
    const worker =
      createWorker?.() ??
      (isForeign()
        ? foreignWorker({ type: "module", name: "texelcast" })
        : new Worker(new URL("./engine-worker.ts", import.meta.url), { type: "module", name: "texelcast" }));
    worker.onmessage = ({ data }: MessageEvent<WorkerMessage>) => this.#receive(data);
    // Without a message it never began, which whoever waits for it is told.
    worker.onerror = ({ message }) =>
      this.#crash(crashError(message || "its script could not be loaded (see worker-src)"), !message);
    worker.onmessageerror = () => this.#crash(crashError("one of its messages could not be read"));
    this.#worker = worker;
    this.#watch = new WorkerWatch({
      ping: () => this.#send({ type: "ping" }),
      waitsFor: () => this.#waitsFor(),
      lost: (reason) => (reason ? this.#crash(crashError(reason)) : this.#restart()),
    });
    this.#sender = new LayerSender();
    this.#send({
      type: "start",
      ...(wasm !== undefined && { wasm: sendable(wasm) }),
      ...(memoryBudgetMib !== undefined && { memoryBudgetMib }),
    });
  }

  /** Names of what the worker has been asked and has not answered. */
  #waitsFor(): readonly (CallName | "layers")[] {
    const calls = [...this.#pending.values()].map(({ call }) => call.name);
    return this.#layersUnderWay ? [...calls, "layers"] : calls;
  }

  #receive(message: WorkerMessage): void {
    // Of a "pong" this is all.
    this.#watch?.heard();
    switch (message.type) {
      case "alive":
        this.#watch?.guard(message.lock);
        break;
      case "result":
        this.#settle(message.id)?.resolve(message.value as never);
        break;
      case "progress":
        this.#pending.get(message.id)?.onProgress?.(message.share);
        break;
      case "update":
        tellAll(this.#updateListeners, message.update);
        break;
      case "failure":
      case "error": {
        const error = TexelcastError.from(message.error);
        if (error.code === "engine-crashed") this.#crash(error);
        else if (message.type === "error") this.#report(error);
        else this.#settle(message.id)?.reject(error);
        break;
      }
      case "drawn":
        this.#layersUnderWay = false;
        if (this.#layersWaiting) this.#sendLayers();
        break;
    }
  }

  #settle(id: number): PendingCall | undefined {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    return pending;
  }

  #report(error: Error): void {
    tellAll(this.#errorListeners, error);
  }

  #stopWorker(): void {
    this.#watch?.stop();
    const worker = this.#worker;
    if (worker === null) return;
    worker.onmessage = null;
    worker.onerror = null;
    worker.onmessageerror = null;
    worker.terminate();
    this.#worker = null;
  }

  /** Stops, and rejects whatever waits. */
  #rejectAll(error: TexelcastError): void {
    this.#stopWorker();
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(error);
  }

  #crash(error: TexelcastError, silently = false): void {
    const now = Date.now();
    this.#crashes = [...this.#crashes.filter((time) => now - time < CRASH_WINDOW_MS), now];
    if (this.#crashes.length >= MAX_CRASHES) {
      this.#halted = haltError(error, MAX_CRASHES);
      this.#rejectAll(this.#halted);
      this.#report(this.#halted);
      return;
    }
    if (!silently) this.#report(error);
    this.#restart(error);
  }

  /** Starts a new worker, tells it everything, and asks it again what the one before had not answered. */
  #restart(error?: TexelcastError): void {
    this.#halted = null;
    this.#stopWorker();
    const asked = [...this.#pending].filter(([, { replay }]) => !replay);
    this.#pending.clear();
    this.#startWorker();
    this.#replay();
    for (const [id, pending] of asked) {
      if (pending.signal?.aborted) pending.reject(cancelled());
      else if (error && pending.attempts++ >= MAX_ATTEMPTS) pending.reject(error);
      else {
        this.#pending.set(id, pending);
        this.#send({ type: "call", id, call: pending.call });
      }
    }
  }

  /** Tells a new worker everything. Calls made meanwhile come after it, because messages keep their order. */
  #replay(): void {
    this.#layersUnderWay = false;
    const worker = this.#worker;
    const replay = { replay: true };
    const steps: Promise<unknown>[] = [];
    if (this.#model !== null) steps.push(this.#call("loadModel", [this.#model], replay));
    if (this.#zones !== null) steps.push(this.#call("setZones", [this.#zones], replay));
    for (const [key, asset] of this.#assets) steps.push(this.#call("setAsset", [key, asset], replay));
    for (const [key, font] of this.#fonts) steps.push(this.#call("setFont", [key, font], replay));
    // While another model is tried, those of the one before are kept for it.
    for (const [, target] of this.#model === null ? [] : this.#targets) {
      steps.push(this.#call("openTarget", [target], replay));
    }
    if (this.#layers !== null) this.#sendLayers();
    this.#send({ type: "expect", change: this.#expected });
    this.#call("idle", [], replay).then(
      () => {
        this.#crashes = [];
      },
      // What cannot be drawn, the worker tells by itself.
      () => undefined,
    );
    for (const step of steps) {
      step.catch((error: TexelcastError) => {
        // A crash or an end reports itself, once for all that waited.
        if (worker !== this.#worker) return;
        // What cannot be fetched now the next worker may get; this one lacks what it was to be told.
        if (error.code === "missing-file") {
          this.#halted = error;
          this.#rejectAll(error);
        }
        this.#report(error);
      });
    }
  }
}

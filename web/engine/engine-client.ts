/**
 * The engine as the page sees it: the same interface as the host's, served by a worker, so that the page's thread never
 * waits. The client remembers what the engine was told (model, pictures, targets, layers); a worker that crashes is
 * replaced and told again.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type {
  Engine,
  EngineLayer,
  EngineStats,
  EngineText,
  MapView,
  ModelInfo,
  ModelSource,
  Picture,
  TargetInfo,
  TargetOptions,
  TargetUpdate,
  TextMeasure,
} from "./engine-api.ts";
import type { Call, CallArguments, CallName, CallResult, ClientMessage, WorkerMessage } from "./engine-protocol.ts";
import { LayerSender } from "./sent-layers.ts";

export interface EngineClientOptions {
  /** Address of the core's WebAssembly, relative to the page; default: the bundler's asset of build/wasm/texelcast.wasm. */
  readonly wasm?: URL | string;
  /** What the engine may hold at once, MiB; default 1024. */
  readonly memoryBudgetMib?: number;
  /** Makes the worker; default: engine-worker.ts as a module worker, in a form that bundlers recognise. */
  readonly createWorker?: () => Worker;
}

/** Starts an engine in a worker of its own. */
export function createEngineClient(options: EngineClientOptions = {}): Engine {
  return new EngineClient(options);
}

/** A crash that comes back at once is not cured by a fourth restart. */
const MAX_RESTARTS = 3;
const RESTART_WINDOW_MS = 60_000;

interface PendingCall {
  readonly resolve: (value: never) => void;
  readonly reject: (error: TexelcastError) => void;
  readonly onProgress?: ((share: number) => void) | undefined;
}

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
  #layers: { readonly layers: readonly EngineLayer[]; readonly revision: number } | null = null;

  /** What the worker has of the layers. */
  #sender = new LayerSender();
  /** The worker has a list of layers that it has not drawn yet. */
  #layersUnderWay = false;
  /** `#layers` was not sent yet. */
  #layersWaiting = false;
  #restarts: number[] = [];

  constructor(options: EngineClientOptions) {
    this.#options = options;
    this.#startWorker();
  }

  async loadModel(source: ModelSource): Promise<ModelInfo> {
    const kept = {
      name: source.name,
      bytes: source.bytes.slice(),
      resources: new Map([...(source.resources ?? [])].map(([uri, bytes]) => [uri, bytes.slice()] as const)),
    };
    const info = await this.#call("loadModel", [kept]);
    this.#model = kept;
    this.#targets.clear();
    return info;
  }

  async setAsset(
    key: string,
    asset: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ width: number; height: number }> {
    const kept = { name: asset.name, bytes: asset.bytes.slice() };
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
    const kept = { name: font.name, bytes: font.bytes.slice() };
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
    const { base } = options;
    const ownBase = typeof base === "object" && "bytes" in base ? { ...base, bytes: base.bytes.slice() } : base;
    const kept: TargetOptions = ownBase === undefined ? { ...options } : { ...options, base: ownBase };
    const info = await this.#call("openTarget", [kept], onProgress, signal);
    this.#targets.set(options.material, kept);
    return info;
  }

  async closeTarget(material: number): Promise<void> {
    await this.#call("closeTarget", [material]);
    this.#targets.delete(material);
  }

  setLayers(layers: readonly EngineLayer[], revision: number): void {
    if (this.#ended !== null) return;
    this.#layers = { layers, revision };
    this.#layersWaiting = true;
    if (!this.#layersUnderWay) this.#sendLayers();
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

  readTexels(material: number, x: number, y: number, width: number, height: number): Promise<Uint8Array> {
    return this.#call("readTexels", [material, x, y, width, height]);
  }

  hash(material: number, region?: { x: number; y: number; width: number; height: number }): Promise<string> {
    return this.#call("hash", [material, region]);
  }

  exportPng(material: number): Promise<Uint8Array> {
    return this.#call("exportPng", [material]);
  }

  exportGlb(): Promise<Uint8Array> {
    return this.#call("exportGlb", []);
  }

  stats(): Promise<EngineStats> {
    return this.#call("stats", []);
  }

  dispose(): void {
    if (this.#ended?.code === "disposed") return;
    this.#end(new TexelcastError("disposed", "The engine was ended."));
    this.#updateListeners.clear();
    this.#errorListeners.clear();
  }

  #call<Name extends CallName>(
    name: Name,
    args: CallArguments<Name>,
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
  ): Promise<CallResult<Name>> {
    if (this.#ended !== null) return Promise.reject(this.#ended);
    if (signal?.aborted) return Promise.reject(new TexelcastError("cancelled", "The call was cancelled."));
    // The call must see the newest layers, also those that wait for their turn.
    if (this.#layersWaiting) this.#sendLayers();
    const id = this.#nextId++;
    const cancel = (): void => this.#send({ type: "cancel", id });
    signal?.addEventListener("abort", cancel, { once: true });
    const result = new Promise<CallResult<Name>>((resolve, reject) => {
      this.#pending.set(id, { resolve: resolve as (value: never) => void, reject, onProgress });
    });
    this.#send({ type: "call", id, call: { name, args } as unknown as Call });
    return result.finally(() => signal?.removeEventListener("abort", cancel));
  }

  #send(message: ClientMessage): void {
    this.#worker?.postMessage(message);
  }

  #sendLayers(): void {
    if (this.#layers === null) return;
    this.#layersWaiting = false;
    this.#layersUnderWay = true;
    const { layers, revision } = this.#layers;
    this.#send({ type: "layers", layers: this.#sender.pack(layers), revision });
  }

  #startWorker(): void {
    const { createWorker, wasm, memoryBudgetMib } = this.#options;
    const worker =
      createWorker?.() ??
      new Worker(new URL("./engine-worker.ts", import.meta.url), { type: "module", name: "texelcast" });
    worker.onmessage = ({ data }: MessageEvent<WorkerMessage>) => this.#receive(data);
    worker.onerror = (event) => this.#crash(crashError(event.message || "its script could not be loaded or run"));
    worker.onmessageerror = () => this.#crash(crashError("one of its messages could not be read"));
    this.#worker = worker;
    this.#sender = new LayerSender();
    this.#send({
      type: "start",
      ...(wasm !== undefined && { wasm: absolute(wasm) }),
      ...(memoryBudgetMib !== undefined && { memoryBudgetMib }),
    });
  }

  #receive(message: WorkerMessage): void {
    switch (message.type) {
      case "result":
        this.#settle(message.id)?.resolve(message.value as never);
        break;
      case "failure": {
        const error = TexelcastError.from(message.error);
        if (error.code === "engine-crashed") this.#crash(error);
        else this.#settle(message.id)?.reject(error);
        break;
      }
      case "progress":
        this.#pending.get(message.id)?.onProgress?.(message.share);
        break;
      case "update":
        for (const listener of this.#updateListeners) listener(message.update);
        break;
      case "error": {
        const error = TexelcastError.from(message.error);
        if (error.code === "engine-crashed") this.#crash(error);
        else this.#report(error);
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
    for (const listener of this.#errorListeners) listener(error);
  }

  /** Ends the worker and rejects whatever waits for it. */
  #stopWorker(error: TexelcastError): void {
    if (this.#worker !== null) {
      this.#worker.onmessage = null;
      this.#worker.onerror = null;
      this.#worker.onmessageerror = null;
      this.#worker.terminate();
      this.#worker = null;
    }
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(error);
  }

  #end(error: TexelcastError): void {
    this.#ended = error;
    this.#stopWorker(error);
  }

  #crash(error: TexelcastError): void {
    const now = Date.now();
    this.#restarts = this.#restarts.filter((time) => now - time < RESTART_WINDOW_MS);
    if (this.#restarts.length >= MAX_RESTARTS) {
      this.#end(error);
    } else {
      this.#restarts.push(now);
      this.#stopWorker(error);
      this.#startWorker();
      this.#replay();
    }
    this.#report(error);
  }

  /** Tells a new worker everything. Calls made meanwhile come after it, because messages keep their order. */
  #replay(): void {
    this.#layersUnderWay = false;
    if (this.#model === null) this.#targets.clear();
    const steps: Promise<unknown>[] = [];
    if (this.#model !== null) steps.push(this.#call("loadModel", [this.#model]));
    for (const [key, asset] of this.#assets) steps.push(this.#call("setAsset", [key, asset]));
    for (const [key, font] of this.#fonts) steps.push(this.#call("setFont", [key, font]));
    for (const target of this.#targets.values()) steps.push(this.#call("openTarget", [target]));
    if (this.#layers !== null) this.#sendLayers();
    for (const step of steps) {
      step.catch((error: TexelcastError) => {
        // A crash or an end reports itself, once for all that waited.
        if (error.code !== "engine-crashed" && error.code !== "disposed") this.#report(error);
      });
    }
  }
}

function crashError(reason: string): TexelcastError {
  return new TexelcastError("engine-crashed", `The engine crashed: ${reason.replace(/\.$/, "")}.`, {
    hint: "It is started again by itself; if that fails, reload the page.",
  });
}

/** The worker's own address is another one than the page's, so a relative address must be made whole here. */
function absolute(address: URL | string): string {
  return typeof location === "undefined" ? String(address) : new URL(address, location.href).href;
}

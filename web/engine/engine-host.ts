/**
 * The engine itself: one session of the core with the decoding of models and pictures around it. It runs anywhere,
 * in the page's worker and in Node.
 *
 * Calls take effect in the order in which they were made. Layers do not wait in that line: they are drawn between the
 * steps of longer work, and before anything is read.
 */
import type { ImageHandle } from "../core/session.ts";
import { Session } from "../core/session.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { type CoreSource, loadCore } from "../core/wasm-module.ts";
import { checkFile } from "./check-file.ts";
import { DrawnOnDemand } from "./drawn-on-demand.ts";
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
import { cancelled, disposed, noModel, notDrawn, notOpen } from "./engine-faults.ts";
import { EnginePrints } from "./engine-prints.ts";
import { engineStats } from "./engine-stats.ts";
import { callLater, nextTurn } from "./event-loop.ts";
import type { MapChannel } from "./map-view.ts";
import { modelInfo } from "./model-info.ts";
import { type LoadedModel, loadModelFile } from "./model-loader.ts";
import { OpenTarget, type TargetPictures } from "./open-target.ts";
import { decodePicture } from "./picture-decoder.ts";
import type { PrintFile, PrintFileOptions, PrintMapKind, PrintReport } from "./print-report.ts";
import { NO_ZONES, type PrintZones } from "./print-zones.ts";
import { Readying } from "./readying.ts";
import { isSvg } from "./svg-start.ts";
import { tellAll } from "./tell-all.ts";

export type { MapChannel } from "./map-view.ts";

/** What the thread draws in one turn of its event loop, as long as there is more to project. */
const LONGEST_TURN_MS = 500;

export interface EngineHostOptions {
  /** The core's WebAssembly: an address, its bytes, or compiled. Default: the one that comes with the package. */
  readonly wasm?: CoreSource;
  /** What the engine may hold at once, MiB; default 1024. */
  readonly memoryBudgetMib?: number;
}

/** Starts an engine in this thread. What is wrong with the WebAssembly shows at the first call. */
export function createEngineHost(options: EngineHostOptions = {}): EngineHost {
  return new EngineHost(options);
}

export class EngineHost implements Engine {
  readonly #options: EngineHostOptions;
  #session: Session | null = null;
  #model: LoadedModel | null = null;
  readonly #targets = new Map<number, OpenTarget>();
  readonly #images = new Map<string, ImageHandle>();
  readonly #drawn = new DrawnOnDemand();
  #fontsComing = false;

  #zones: PrintZones | null = null;
  #zoneWork: typeof import("./zone-work.ts") | null = null;
  #layers: readonly EngineLayer[] = [];
  #revision = 0;
  /** The newest layers (or what they refer to) were not drawn yet. */
  #stale = false;
  #drawingSoon = false;

  #unanswered = 0;
  readonly #readying = new Readying({
    targets: () => [...this.#targets.values()],
    isBusy: () => this.#disposed || this.#session === null || this.#stale || this.#unanswered > 0,
    fault: (error) => this.#report(error),
  });

  readonly #updateListeners = new Set<(update: TargetUpdate) => void>();
  readonly #errorListeners = new Set<(error: Error) => void>();
  /** The end of the line of calls. */
  #line: Promise<unknown> = Promise.resolve();
  #disposed = false;

  readonly prints = new EnginePrints((load, signal) =>
    this.#enqueue(async (session) => {
      const work = await load();
      this.#checkAlive();
      await this.#drawAll(session, true);
      return work({
        session,
        model: this.#requireModel(),
        layers: this.#layers,
        zones: this.#zones ?? NO_ZONES,
        targets: this.#targets,
        pictures: (report) => this.#pictures(session, report),
        isDrawn: (picture) => this.#drawn.isDrawn(picture),
        missing: (picture) => this.#drawn.missing(picture),
        checkpoint: () => {
          this.#checkAlive();
          if (signal?.aborted) throw cancelled();
        },
      });
    }),
  );

  constructor(options: EngineHostOptions = {}) {
    this.#options = options;
  }

  /** @param takesOver whether the source's bytes are the engine's from now on, and not copied */
  loadModel(source: ModelSource, takesOver = false): Promise<ModelInfo> {
    return this.#enqueue(async (session) => {
      checkFile(source);
      // Whoever receives the GLB may hand it on to another thread: it is not kept.
      const { glb, ...model } = await loadModelFile(source, takesOver);
      this.#checkAlive();
      try {
        session.loadGlb(glb);
      } catch (error) {
        throw (await import("./model-fault.ts")).modelFault(error, model.original.json, model.name);
      }
      this.#model = model;
      for (const target of this.#targets.values()) target.forgetImages();
      this.#targets.clear();
      return modelInfo(session, model, glb);
    });
  }

  setAsset(
    key: string,
    asset: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ width: number; height: number }> {
    return this.#enqueue(async (session) => {
      checkFile(asset);
      if (isSvg(asset.bytes)) {
        const size = await this.#drawn.addSvg(key, asset.bytes, asset.name);
        this.#checkAlive();
        this.#replaceImage(session, key, null);
        return size;
      }
      const { width, height, rgba } = await decodePicture(asset.bytes, asset.name, { asSeen: true });
      this.#checkAlive();
      const image = session.createImage(width, height, rgba);
      this.#drawn.removeSvg(key);
      this.#replaceImage(session, key, image);
      return { width, height };
    });
  }

  /** Null: the key has no image in the core any more. */
  #replaceImage(session: Session, key: string, image: ImageHandle | null): void {
    const old = this.#images.get(key);
    if (image === null) this.#images.delete(key);
    else this.#images.set(key, image);
    this.#markStale();
    if (old === undefined) return;
    this.#draw(session);
    session.destroyImage(old);
  }

  removeAsset(key: string): Promise<void> {
    return this.#enqueue((session) => {
      this.#drawn.removeSvg(key);
      this.#drawn.removeFont(key);
      this.#replaceImage(session, key, null);
    });
  }

  setFont(
    key: string,
    font: { readonly name: string; readonly bytes: Uint8Array },
  ): Promise<{ readonly name: string }> {
    return this.#enqueue(async () => {
      checkFile(font);
      const info = await this.#drawn.addFont(key, font.bytes, font.name);
      this.#checkAlive();
      this.#markStale();
      return info;
    });
  }

  measureText(text: EngineText): Promise<TextMeasure> {
    return this.#enqueue(() => this.#drawn.measure(text));
  }

  openTarget(options: TargetOptions, onProgress?: (share: number) => void, signal?: AbortSignal): Promise<TargetInfo> {
    return this.#enqueue(async (session) => {
      const model = this.#requireModel();
      const checkpoint = (): void => {
        this.#checkAlive();
        if (signal?.aborted) throw cancelled();
      };
      const target = await OpenTarget.open(options ?? {}, { session, model, onProgress, checkpoint });
      this.#targets.get(options.material)?.destroy();
      this.#targets.set(options.material, target);
      this.#markStale();
      return target.info;
    });
  }

  closeTarget(material: number): Promise<void> {
    return this.#enqueue(() => {
      this.#targets.get(material)?.destroy();
      this.#targets.delete(material);
      // Another may have lacked the memory.
      this.#markStale();
    });
  }

  /** Whether a turn is to come that draws the newest layers, or goes on with them. */
  get drawingSoon(): boolean {
    return this.#drawingSoon;
  }

  setLayers(layers: readonly EngineLayer[], revision: number): void {
    if (this.#disposed) return;
    this.#layers = layers;
    this.#revision = revision;
    this.#markStale();
  }

  expect(change: ExpectedChange | null): void {
    if (!this.#disposed) this.#readying.expect(change);
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
    return this.#enqueue(async (session) => {
      await this.#drawAll(session);
      for (const target of this.#targets.values()) target.checkDrawn();
    });
  }

  viewMap(material: number, view: MapView): Promise<Picture> {
    return this.#enqueue(async () => {
      const { mapView } = await import("./map-view.ts");
      return mapView(this.#requireTarget(material), view);
    });
  }

  uvTriangles(material: number): Promise<Float32Array> {
    return this.#enqueue((session) => {
      this.#requireModel();
      return session.materialUvs(material);
    });
  }

  readTexels(material: number, x: number, y: number, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
    return this.#enqueue(async (session) => {
      await this.#drawAll(session);
      return this.#requireTarget(material).read(x, y, width, height);
    });
  }

  layerMiniature(id: string, of: "layer" | "mask", side: number): Promise<Uint8Array<ArrayBuffer> | null> {
    return this.#enqueue(async (session) => {
      await this.#drawAll(session);
      for (const target of this.#targets.values()) {
        const rgba = target.miniature(id, of, side);
        if (rgba !== null) return rgba;
      }
      return null;
    });
  }

  hash(material: number, region?: { x: number; y: number; width: number; height: number }): Promise<string> {
    return this.#enqueue(async (session) => {
      await this.#drawAll(session);
      const target = this.#requireTarget(material);
      const { x, y, width, height } = region ?? { x: 0, y: 0, width: target.info.width, height: target.info.height };
      return target.hash(x, y, width, height);
    });
  }

  exportPng(material: number): Promise<Uint8Array<ArrayBuffer>> {
    return this.#enqueue(async (session) => {
      const { encodePng } = await import("./png-encoder.ts");
      await this.#drawAll(session, true);
      return encodePng(this.#requireTarget(material).exportedPicture());
    });
  }

  exportGlb(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>> {
    return this.#exportModel("paintedGlb", materials);
  }

  exportUsdz(materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>> {
    return this.#exportModel("paintedUsdz", materials);
  }

  #exportModel(as: "paintedGlb" | "paintedUsdz", materials?: readonly number[]): Promise<Uint8Array<ArrayBuffer>> {
    return this.#enqueue(async (session) => {
      const model = this.#requireModel();
      const write = (await import("./painted-model.ts"))[as];
      await this.#drawAll(session, true);
      return write(model, session, this.#targets, materials);
    });
  }

  setZones(zones: PrintZones | null): Promise<void> {
    return this.#enqueue(async (session) => {
      this.#zoneWork ??= await import("./zone-work.ts");
      this.#checkAlive();
      const { zones: core, corners } = this.#zoneWork.coreZones(zones ?? NO_ZONES);
      session.setZones(core, corners);
      this.#zones = zones ?? null;
      this.#markStale();
    });
  }

  printReport(): Promise<PrintReport> {
    return this.prints.report();
  }

  printMap(material: number, kind: PrintMapKind): Promise<Picture> {
    return this.prints.map(material, kind);
  }

  exportPrint(
    options: PrintFileOptions = {},
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
  ): Promise<PrintFile> {
    return this.prints.file(options, onProgress, signal);
  }

  stats(): Promise<EngineStats> {
    return this.#enqueue(engineStats);
  }

  /** Rows of an open target's map: three floats a texel for positions and normals, one byte else (texelcast.h). */
  readMapRows(material: number, channel: "positions" | "normals", row: number, rowCount: number): Promise<Float32Array>;
  readMapRows(
    material: number,
    channel: "coverage" | "overlap",
    row: number,
    rowCount: number,
  ): Promise<Uint8Array<ArrayBuffer>>;
  readMapRows(
    material: number,
    channel: MapChannel,
    row: number,
    rowCount: number,
  ): Promise<Float32Array | Uint8Array> {
    return this.#enqueue(async () => {
      const { mapRows } = await import("./map-view.ts");
      return mapRows(this.#requireTarget(material).core, channel, row, rowCount);
    });
  }

  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#updateListeners.clear();
    this.#errorListeners.clear();
    if (this.#session !== null && !this.#session.core.crashed) this.#session.destroy();
    this.#session = null;
    this.#model = null;
    this.#targets.clear();
    this.#images.clear();
    this.#layers = [];
  }

  /** Runs `work` after all calls made before, on the session, which the first of them starts. */
  #enqueue<Result>(work: (session: Session) => Result | Promise<Result>): Promise<Result> {
    const result = this.#line.then(async () => {
      this.#checkAlive();
      if (this.#session === null) {
        const core = await loadCore(this.#options.wasm);
        this.#checkAlive();
        const { memoryBudgetMib } = this.#options;
        this.#session = Session.create(core, memoryBudgetMib === undefined ? {} : { memoryBudgetMib });
      }
      try {
        return await work(this.#session);
      } catch (error) {
        // Work that was under way when the engine was ended fails on whatever it touched next.
        this.#checkAlive();
        throw isTold(error) ? error : await this.#explained(error);
      }
    });
    this.#unanswered += 1;
    this.#line = result
      .catch(() => undefined)
      .finally(() => {
        this.#unanswered -= 1;
        this.#readying.resume();
      });
    return result;
  }

  #markStale(): void {
    this.#stale = true;
    if (this.#drawingSoon) return;
    this.#drawingSoon = true;
    // Later, not at once: of several lists that are already on their way only the newest shall be drawn.
    callLater(() => {
      this.#drawingSoon = false;
      if (this.#session === null || this.#disposed) return;
      try {
        this.#draw(this.#session);
      } catch (error) {
        this.#report(notDrawn(error));
      }
    });
  }

  /**
   * Draws the newest layers with the words whose fonts are still to be loaded.
   *
   * @param strict rejects where a font cannot be had, as a picture without its words must not be given away for a whole one
   */
  async #drawAll(session: Session, strict = false): Promise<void> {
    if (strict || !this.#drawn.isReady(this.#layers)) {
      try {
        await this.#drawn.load(this.#layers);
      } catch (error) {
        if (strict) throw error;
        this.#report(TexelcastError.wrap(error, "internal", "A font could not be loaded."));
      }
      this.#checkAlive();
      this.#stale = true;
    }
    this.#draw(session);
    while (this.#stale) {
      await nextTurn();
      this.#checkAlive();
      this.#draw(session);
    }
  }

  /** Words whose fonts are not there yet are drawn as soon as they are. */
  #loadSoon(): void {
    if (this.#fontsComing) return;
    this.#fontsComing = true;
    this.#drawn.load(this.#layers).then(
      () => {
        this.#fontsComing = false;
        if (!this.#disposed) this.#markStale();
      },
      (error: unknown) => {
        this.#fontsComing = false;
        if (!this.#disposed) this.#report(TexelcastError.wrap(error, "internal", "A font could not be loaded."));
      },
    );
  }

  /**
   * Draws the newest layers on every open target and reports what changed, and which could not be drawn; a crash is thrown. What
   * takes longer goes on in the next turns: a design of thousands of strokes takes minutes on a phone, in which the worker must
   * answer, or it is taken for dead.
   */
  #draw(session: Session): void {
    if (!this.#stale) return;
    this.#stale = false;
    const until = performance.now() + LONGEST_TURN_MS;
    let unfinished = false;
    if (!this.#drawn.isReady(this.#layers)) this.#loadSoon();
    const report = (error: Error): void => this.#report(error);
    const pictures = this.#pictures(session, report);
    for (const target of this.#targets.values()) {
      let update: TargetUpdate | null = null;
      target.fault = null;
      try {
        update = target.draw(this.#layers, this.#revision, pictures, report, until);
        unfinished ||= target.turns > 0;
      } catch (error) {
        if (session.core.crashed) throw error;
        target.fault = notDrawn(error);
        report(target.fault);
      }
      if (update === null) continue;
      tellAll(this.#updateListeners, update);
      // A listener may have disposed of the engine.
      if (this.#session !== session) return;
    }
    if (unfinished) this.#markStale();
    this.#drawn.sweep(session);
    this.#readying.restart();
  }

  #pictures(session: Session, report: (error: Error) => void): TargetPictures {
    return {
      imageOf: (asset) => this.#drawn.imageOf(asset) ?? this.#images.get(asset),
      resolve: (layers, target) => this.#drawn.resolve(layers, session, target, report),
      clipping: this.#zones && this.#zoneWork && { zones: this.#zones, Clip: this.#zoneWork.ZoneClip },
    };
  }

  #report(error: Error): void {
    if (isTold(error)) tellAll(this.#errorListeners, error);
    else void this.#explained(error).then((told) => tellAll(this.#errorListeners, told));
  }

  /** By what in the layers cannot be drawn, where that is why. */
  async #explained<Thrown>(error: Thrown): Promise<Thrown | TexelcastError> {
    const { layersFault } = await import("./check-layers.ts");
    return layersFault(this.#layers) ?? error;
  }

  #checkAlive(): void {
    if (this.#disposed) throw disposed();
  }

  #requireModel(): LoadedModel {
    if (this.#model === null) throw noModel();
    return this.#model;
  }

  #requireTarget(material: number): OpenTarget {
    this.#requireModel();
    const target = this.#targets.get(material);
    if (target === undefined) throw notOpen(material);
    return target;
  }
}

/** Whether an error tells a fault by name. */
const isTold = (error: unknown): boolean => error instanceof TexelcastError && error.code !== "internal";

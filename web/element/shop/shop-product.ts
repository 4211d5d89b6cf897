/** A product as it is shown, before anything is done to it: its model and its textures, in an engine and a view. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Engine, ModelInfo, ModelSource, TargetInfo, TargetUpdate } from "../../engine/engine-api.ts";
import { createEngineClient } from "../../engine/engine-client.ts";
import { StillView } from "../../viewer/still-view.ts";
import type { DeskHooks } from "../desk/desk-settings.ts";
import { paintableMaterial } from "../desk/paintable.ts";

export interface ShopProductParts {
  /** Where the view goes; it must have a size. */
  readonly view: HTMLElement;
  /** Address of the engine's WebAssembly; "" the bundler's. */
  readonly wasm: string;
  readonly hooks: DeskHooks;
}

/** What is open: the file, what it holds, and the material that new things go on. */
export interface OpenProduct {
  readonly source: ModelSource;
  readonly info: ModelInfo;
  readonly material: number;
}

export class ShopProduct {
  readonly engine: Engine;
  readonly viewer: StillView;
  readonly hooks: DeskHooks;
  /** Null until `show`. */
  open: OpenProduct | null = null;
  /** By material. */
  readonly targets = new Map<number, TargetInfo>();
  /** Told whenever a target was opened. */
  changed: () => void = () => undefined;
  readonly #early = new Map<number, TargetUpdate[]>();
  #line: Promise<unknown> = Promise.resolve();
  #closed = false;

  /** Throws a TexelcastError without WebGL 2. */
  constructor({ view, wasm, hooks }: ShopProductParts) {
    this.hooks = hooks;
    // First: without graphics there is nothing to begin a worker for.
    this.viewer = new StillView(view, { label: hooks.settings().words.view });
    this.engine = createEngineClient(wasm ? { wasm } : {});
    this.engine.onUpdate((update) => this.#receive(update));
    this.engine.onError((error) => this.fail(error));
    this.viewer.on("graphics", ({ lost }) => lost && hooks.graphicsLost());
    this.viewer.on("needsFullUpdate", ({ material }) => this.attempt(this.openTarget(material)));
  }

  get closed(): boolean {
    return this.#closed;
  }

  /** Shows a model that the engine has loaded, bare so far. Rejects where it has no material that can be painted. */
  async show(source: ModelSource, info: ModelInfo): Promise<OpenProduct> {
    await this.viewer.setModel(info);
    this.open = { source, info, material: paintableMaterial(info, this.hooks) };
    return this.open;
  }

  /** Opens a material's texture, or opens it anew in the size of the settings; one after the other. */
  openTarget(material: number, progress?: (share: number) => void): Promise<TargetInfo> {
    const turn = this.#line.then(async () => {
      const { size } = this.hooks.settings();
      const sides = size === null ? {} : { width: size, height: size };
      const info = await this.engine.openTarget({ material, mipmaps: true, ...sides }, progress);
      // In the turn in which the engine answered: the next thing it says is the target's first picture.
      this.#bind(info);
      return info;
    });
    this.#line = turn.catch(() => undefined);
    return turn;
  }

  /** Takes up the settings' material, and gives what is open the settings' size. */
  async resize(): Promise<void> {
    if (this.open === null) return;
    const material = paintableMaterial(this.open.info, this.hooks);
    this.open = { ...this.open, material };
    for (const each of new Set([material, ...this.targets.keys()])) await this.openTarget(each);
  }

  /** Resolves when every target that was asked for is open and shows what it should. */
  async idle(): Promise<void> {
    await this.#line;
    await this.engine.idle();
  }

  canPaint(material: number): boolean {
    const { materials = [] } = this.open?.info ?? {};
    return materials.some(({ index, refusal }) => index === material && refusal === null);
  }

  /** Throws "cancelled" where it was closed. */
  checkOpen(): void {
    if (this.#closed) throw new TexelcastError("cancelled", this.hooks.settings().words.errors.notReady);
  }

  /** Sees to work that nobody waits for. */
  attempt(work: Promise<unknown>): void {
    void work.catch((thrown: unknown) => this.fail(thrown));
  }

  fail(thrown: unknown): void {
    if (!this.#closed) this.hooks.failed(thrown);
  }

  /** Ends the worker and the graphics. */
  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.engine.dispose();
    this.viewer.dispose();
  }

  #bind(info: TargetInfo): void {
    const { material } = info;
    this.targets.set(material, info);
    this.viewer.bindTarget(info);
    const early = this.#early.get(material) ?? [];
    this.#early.delete(material);
    for (const update of early) this.viewer.applyUpdate(update);
    this.changed();
  }

  /** A view can take an update only for a target that it was told of. */
  #receive(update: TargetUpdate): void {
    const { material } = update;
    if (this.targets.has(material)) this.viewer.applyUpdate(update);
    else this.#early.set(material, [...(this.#early.get(material) ?? []), update]);
  }
}

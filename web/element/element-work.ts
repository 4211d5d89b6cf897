/** What an element has under way: it is opened, the design is worked on, and it is closed, as often as the page likes. */
import type { LitElement } from "lit";
import { TexelcastError } from "../core/texelcast-error.ts";
import { ToldError } from "../editor/strings/told-error.ts";
import { adoptStyle } from "../viewer/adopt-style.ts";
import type { CameraStand } from "../viewer/camera-rig.ts";
import type { DeskHooks, DeskSettings } from "./desk/desk-settings.ts";
import type { SubmitDetail, TexelcastEditorProperties } from "./element-api.ts";
import { sendEvent } from "./element-events.ts";
import { addressIn, FETCHED, Run, type Steps } from "./element-run.ts";
import { readSettings } from "./element-settings.ts";
import type { Voice } from "./element-voice.ts";
import type { AtDesk, Mode, ModeHost } from "./mode.ts";

/** Milliseconds of rest after which a change is told. */
const CHANGE_REST = 120;

export type Phase = "idle" | "loading" | "failed" | "ready";

export interface WorkParts {
  readonly element: LitElement & TexelcastEditorProperties;
  readonly voice: Voice;
  /** It is idle again: whoever waits to begin may. */
  readonly idle: () => void;
}

export class Work {
  readonly #element: WorkParts["element"];
  readonly #voice: Voice;
  readonly #idle: () => void;
  #phase: Phase = "idle";
  #share = 0;
  #run: Run | null = null;
  #starting: Promise<void> | null = null;
  /** The start that what the page has set made of the one before: who waits for that gets this. */
  #anew: Promise<void> | null = null;
  /** How often it was closed: a start that finds another count than it began with is given up. */
  #closings = 0;
  /** What was worked on when the mode was closed last; `behind` a newer one that the page has set and nobody has seen yet. */
  #kept: { readonly steps: Steps; readonly selected: string | null; readonly behind: boolean } | null = null;
  /** The newest design that the page has set meanwhile and that is being read. */
  #coming: object | null = null;
  /** The newest design and zones that the page has set: done when they are in use, or could not be. */
  readonly #taken = new Map<"design" | "zones", Promise<void>>();
  /** What was begun last, by what the page says of it, and where its camera stood when it was closed. */
  #begun: { readonly product: unknown; readonly orbit: unknown; stand?: CameraStand } | null = null;
  #view: HTMLElement | null = null;
  #changeTimer: ReturnType<typeof setTimeout> | undefined;
  #untold = false;
  #telling = Promise.resolve();

  constructor({ element, voice, idle }: WorkParts) {
    this.#element = element;
    this.#voice = voice;
    this.#idle = idle;
  }

  get phase(): Phase {
    return this.#phase;
  }
  /** How far loading has come, 0 to 1. */
  get share(): number {
    return this.#share;
  }
  /** Null until it is open. */
  get mode(): Mode | null {
    return this.#run?.mode ?? null;
  }
  /** Before it is open, too. */
  get made(): Mode | null {
    return this.#run?.made ?? null;
  }
  /** The 3D view's box: under the cover already, so that it has its place and size when the model comes. */
  get view(): HTMLElement | null {
    return this.#view;
  }
  get settings(): DeskSettings {
    return readSettings(this.#element, this.#voice.words).settings;
  }

  start(): Promise<void> {
    this.#starting ??= this.#voice.told(this.#start()).finally(() => {
      if (this.#phase === "failed" || this.#phase === "idle") this.#starting = null;
    });
    this.#starting.catch(() => undefined);
    return this.#starting;
  }

  /** The mode, open. Rejects as `start` does, "cancelled" where it was closed meanwhile. */
  async ready(): Promise<Mode> {
    await this.start();
    const { mode } = this;
    if (!mode) throw new TexelcastError("cancelled", this.#voice.words.errors.notReady);
    return mode;
  }

  /** The same, with its desk. */
  async atDesk(): Promise<AtDesk> {
    const mode = await this.ready();
    // What the page has set before it asks holds for what it asks.
    await this.#element.updateComplete;
    await Promise.allSettled([...this.#taken.values()]);
    return { desk: await mode.takeDesk(), idle: () => mode.idle() };
  }

  /** Ends what runs; what was designed stays. `phase`: what it is from then on. */
  close(phase: Phase = "idle"): void {
    clearTimeout(this.#changeTimer);
    this.#closings++;
    const { mode } = this;
    if (mode && this.#begun) this.#begun.stand = mode.viewer.stand;
    if (mode?.desk) {
      const { session, store } = mode.desk;
      this.#kept = { steps: session.steps, selected: store.state.selectedId, behind: this.#coming !== null };
    }
    this.#coming = null;
    this.#run?.close();
    this.#run = null;
    this.#starting = null;
    this.#anew = null;
    this.#view?.replaceChildren();
    this.#phase = phase;
    this.#voice.dismiss();
    this.#idle();
  }

  /** Takes up what the page has set: the names of those properties. */
  follow(has: (...names: (keyof TexelcastEditorProperties)[]) => boolean): void {
    const { mode } = this;
    // Another design takes the place of the one that was worked on before.
    if (has("design") && !mode) this.#kept = null;
    if (this.#phase === "idle") return;
    const anew = has("src", "mode", "wasmUrl");
    if (anew || (has("design") && !mode)) {
      // What they were when it began is known from then on: the first values are no change.
      if (!this.#run && this.#phase === "loading") return;
      this.close();
      if (has("design")) this.#kept = null;
      // A page that has taken the product away waits for another one, as before the first.
      if (this.#element.src) this.#anew = this.start();
      return;
    }
    if (!mode) return;
    if (has("zones")) this.#take("zones", this.#useZones(mode));
    if (has("design")) this.#take("design", this.#takeDesign(mode));
    if (has("size", "material")) void this.#voice.told(mode.resize());
    if (has("readonly", "minCameraOrbit", "maxCameraOrbit")) this.configure();
  }

  /** Takes up the settings that cost nothing. */
  configure(): void {
    this.#voice.tried(() => {
      this.mode?.configure();
      return true;
    });
  }

  async submit(): Promise<SubmitDetail> {
    const mode = await this.atDesk();
    const { submitDetail } = await import("./desk/hand-over.ts");
    const detail = await submitDetail(mode, () => this.#tellChange());
    if (sendEvent(this.#element, "submit", detail)) this.#voice.announce(this.#voice.words.submitted);
    return detail;
  }

  async #start(): Promise<void> {
    const began = performance.now();
    const element = this.#element;
    const voice = this.#voice;
    const closings = this.#closings;
    this.#phase = "loading";
    voice.dismiss();
    this.#progress(0);
    this.#view ??= makeView();
    try {
      await voice.speak();
      await element.updateComplete;
      // Closed before there was a run that could have been closed.
      if (closings !== this.#closings) throw new TexelcastError("cancelled", voice.words.errors.notReady);
      const { mode: kind, src, zones, design, cameraOrbit } = element;
      const product = productOf(src);
      const begun = this.#begun;
      const isAgain = begun?.product === product && begun?.orbit === cameraOrbit;
      this.#begun = { product, orbit: cameraOrbit, stand: isAgain ? begun.stand : undefined };
      this.#run = new Run({
        ...{ kind, src, zones, words: voice.words, limits: this.settings.limits },
        design: { given: design, kept: this.#kept?.steps ?? null, keptFirst: this.#kept?.behind === false },
        base: element.baseURI,
        host: this.#modeHost(this.#view),
        progress: (share) => this.#progress(share),
      });
      const mode = await this.#run.open();
      const { orbit, settings } = readSettings(element, voice.words);
      const place = this.#begun.stand ?? orbit;
      if (place) mode.viewer.setCamera(place, settings.camera);
      this.#phase = "ready";
      this.#progress(1);
      // What the page set while it was opening.
      if (element.zones !== zones) this.#take("zones", this.#useZones(mode));
      const { desk } = mode;
      if (this.#kept?.selected) desk?.select(this.#kept.selected);
      if (this.#untold || (desk?.zones && desk.design.layers.length > 0)) void voice.told(this.#sendChange());
      const materials = mode.materials.map(({ index, name, refusal }) => ({
        index,
        name,
        paintable: refusal === null,
      }));
      sendEvent(element, "load", { materials, milliseconds: Math.round(performance.now() - began) });
    } catch (thrown) {
      if (closings === this.#closings) {
        this.#run = null;
        this.#phase = "failed";
        voice.show(thrown);
      } else if (this.#anew) return await this.#anew;
      throw thrown;
    } finally {
      element.requestUpdate();
    }
  }

  async #takeDesign(mode: Mode): Promise<void> {
    const run = this.#run;
    const coming = {};
    this.#coming = coming;
    try {
      const desk = await mode.takeDesk();
      const design = await run?.readDesign(desk.library, this.#element.design);
      if (!design) return;
      if (this.#coming === coming) desk.takeDesign(design);
      desk.library.release(Object.values(design.assets));
    } finally {
      if (this.#coming === coming) this.#coming = null;
    }
  }

  #take(what: "design" | "zones", work: Promise<void>): void {
    this.#taken.set(what, this.#voice.told(work));
  }

  async #useZones(mode: Mode): Promise<void> {
    const { zones } = this.#element;
    const read = zones ? await this.#run?.readZones(zones) : null;
    const desk = await mode.takeDesk();
    if (this.#element.zones !== zones || read === undefined || desk.closed) return;
    await desk.useZones(read);
    this.#changed();
  }

  #modeHost(view: HTMLElement): ModeHost {
    const element = this.#element;
    const voice = this.#voice;
    const hooks: DeskHooks = {
      settings: () => this.settings,
      changed: () => this.#changed(),
      selected: (id) => sendEvent(element, "select", { id }),
      failed: (thrown) => voice.tell(thrown),
      graphicsLost: () => this.#endWithoutGraphics(),
      warn: (error) => voice.report(error),
      progress: (share) => this.#progress(FETCHED + (1 - FETCHED) * share),
      announce: (text) => voice.announce(text),
    };
    return {
      hooks,
      view,
      wasm: element.wasmUrl,
      get words() {
        return voice.words;
      },
      tell: (thrown) => voice.tell(thrown),
      dismiss: () => voice.dismiss(),
      submit: () => this.submit(),
      requestUpdate: () => element.requestUpdate(),
      adopt: (styles) => adopt(element, styles),
      made: async (mode) => {
        adopt(element, mode.styles);
        element.requestUpdate();
        await element.updateComplete;
      },
    };
  }

  /** A new view may be given graphics; the user asks for it by the button that follows a failed start. */
  #endWithoutGraphics(): void {
    const { graphicsLost, graphicsLostHint } = this.#voice.words.errors;
    this.close("failed");
    this.#voice.tell(new ToldError("graphics-lost", graphicsLost, { hint: graphicsLostHint }));
  }

  #changed(): void {
    clearTimeout(this.#changeTimer);
    this.#changeTimer = setTimeout(() => this.#tellChange(), CHANGE_REST);
    this.#untold = true;
  }

  /** Tells what has not been told of the design, without a rest; what is being told already is waited for. */
  #tellChange(): Promise<void> {
    if (this.#untold) {
      clearTimeout(this.#changeTimer);
      this.#telling = this.#voice.told(this.#sendChange());
    }
    return this.#telling;
  }

  /** A design that was brought along is measured for its badges, and is no change. What is closed meanwhile stays untold. */
  async #sendChange(): Promise<void> {
    const run = this.#run;
    const mode = run?.mode;
    const desk = mode?.desk;
    if (!mode || !desk) return;
    const { changeDetail } = await import("./desk/hand-over.ts");
    const detail = await changeDetail({ desk, idle: () => mode.idle() });
    if (this.#run !== run) return;
    if (!detail) {
      // A newer change tells itself; what is only shown so far may yet be given up.
      if (this.#untold && !desk.closed && !desk.atRest) this.#changed();
      return;
    }
    this.#element.requestUpdate();
    if (!this.#untold) return;
    this.#untold = false;
    sendEvent(this.#element, "change", detail);
  }

  #progress(share: number): void {
    this.#share = share;
    sendEvent(this.#element, "progress", { share });
    this.#element.requestUpdate();
  }
}

/** An address without the look that it asks for: of the same product in another look, the same. */
const productOf = (src: TexelcastEditorProperties["src"]): unknown => {
  const address = addressIn(src);
  return typeof address === "string" ? address.replace(/#variant=.*/s, "") : address;
};

function makeView(): HTMLElement {
  const view = document.createElement("div");
  view.className = "own view";
  // For who began by a key, until the product is there.
  view.tabIndex = -1;
  return view;
}

function adopt({ renderRoot: root }: LitElement, styles: Mode["styles"]): void {
  for (const { cssText } of styles) adoptStyle(root as ShadowRoot, cssText);
}

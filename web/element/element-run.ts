/** One time that the element is open: its mode is loaded, its model and design are opened, and in the end all of it is closed. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Design } from "../editor/document/design.ts";
import type { AssetLibrary } from "../editor/state/asset-library.ts";
import type { DesignSession } from "../editor/state/design-session.ts";
import { ToldError } from "../editor/strings/told-error.ts";
import type { PrintZones } from "../engine/print-zones.ts";
import type { UploadLimits } from "../engine/upload-check.ts";
import { fetchModel } from "./desk/read-model.ts";
import type { DesignInput, TexelcastEditorProperties } from "./element-api.ts";
import type { Mode, ModeHost } from "./mode.ts";
import type { Words } from "./words/words.ts";

export interface RunParts {
  readonly kind: TexelcastEditorProperties["mode"];
  readonly src: TexelcastEditorProperties["src"];
  /** What the page gives, and what was worked on before: that goes first, or is there for a given one that cannot be read. */
  readonly design: { readonly given: DesignInput | null; readonly kept: Steps | null; readonly keptFirst: boolean };
  readonly zones: TexelcastEditorProperties["zones"];
  readonly base: string;
  readonly words: Words;
  readonly limits: UploadLimits;
  readonly host: ModeHost;
  /** Of the whole of opening. */
  readonly progress: (share: number) => void;
}

/** The history of a design. */
export type Steps = DesignSession["steps"];

/** Of the whole way, where the mode and the model's bytes are there. */
export const FETCHED = 0.4;

export class Run {
  readonly #parts: RunParts;
  readonly #abort = new AbortController();
  /** Made, and perhaps not open yet. */
  #made: Mode | null = null;
  #open = false;

  constructor(parts: RunParts) {
    this.#parts = parts;
  }

  /** Null until `open` is done. */
  get mode(): Mode | null {
    return this.#open ? this.#made : null;
  }

  /** Before it is open, too. */
  get made(): Mode | null {
    return this.#made;
  }

  /** Rejects with a TexelcastError, closed; "cancelled" where `close` was faster. */
  async open(): Promise<Mode> {
    const { kind, src, zones, words, base, host, progress } = this.#parts;
    const { given, kept } = this.#parts.design;
    try {
      if (!src) {
        throw new ToldError("missing-file", words.errors.noModel, {
          field: "src",
          hint: words.errors.noModelHint,
        });
      }
      const { signal } = this.#abort;
      const fetching = { words, signal, progress: (share: number) => progress(share * FETCHED) };
      // At once: what shows the model is fetched while the model is.
      const loading = loadMode(kind);
      loading.catch(() => undefined);
      const address = addressIn(src);
      const source =
        typeof address === "string"
          ? await fetchModel(address, base, fetching)
          : await (await import("./desk/given-model.ts")).givenModel(src, words);
      const openMode = await loading;
      this.#check();
      progress(FETCHED);
      const mode = openMode(host);
      this.#made = mode;
      await host.made(mode);
      await mode.open(source, given != null || kept ? (library) => this.#firstDesign(library) : null);
      if (kept) mode.desk?.session.resume(kept);
      if (zones) {
        await this.#useZones(mode, zones);
      }
      this.#check();
      this.#open = true;
      return mode;
    } catch (thrown) {
      this.#end();
      this.#check();
      throw thrown instanceof TexelcastError ? thrown : (await import("../engine/refused-worker.ts")).refused(thrown);
    }
  }

  /** Zones that cannot be used are told to the page, which can correct them: the product is shown without. */
  async #useZones(mode: Mode, zones: string | object): Promise<void> {
    const desk = await mode.takeDesk();
    try {
      await desk.useZones(await this.readZones(zones));
    } catch (thrown) {
      this.#check();
      this.#parts.host.hooks.warn(TexelcastError.wrap(thrown, "bad-zones", "The zones could not be used."));
    }
  }

  /** The design of the start. Of one that cannot be read the page is told where there is another to go on with. */
  async #firstDesign(library: AssetLibrary): Promise<Design> {
    const { design, host } = this.#parts;
    const { given, keptFirst } = design;
    const kept = design.kept?.recorded.design;
    if (kept && keptFirst) return kept;
    try {
      return await this.readDesign(library, given);
    } catch (thrown) {
      this.#check();
      if (!kept) throw thrown;
      host.hooks.warn(TexelcastError.wrap(thrown, "bad-design", "The design could not be read."));
      return kept;
    }
  }

  /** Reads a design with the engine's help: its files are taken in. Null is an empty one. */
  async readDesign(library: AssetLibrary, input: DesignInput | null): Promise<Design> {
    const { words, base, limits } = this.#parts;
    if (!input) {
      const { emptyDesign } = await import("../editor/document/design.ts");
      return emptyDesign();
    }
    const { readDesign } = await import("./desk/read-design.ts");
    return await readDesign(input, { words, base, limits, library, signal: this.#abort.signal });
  }

  async readZones(zones: string | object): Promise<PrintZones> {
    const { words, base } = this.#parts;
    const { readZones } = await import("./desk/prints.ts");
    return await readZones(zones, base, { words, signal: this.#abort.signal });
  }

  close(): void {
    this.#abort.abort();
    this.#end();
  }

  #end(): void {
    this.#open = false;
    this.#made?.close();
    this.#made = null;
  }

  #check(): void {
    if (!this.#abort.signal.aborted) return;
    throw new TexelcastError("cancelled", this.#parts.words.errors.notReady);
  }
}

/** An address as text, also of a URL of whatever window; a model's bytes, or nothing, as they are. */
export function addressIn<Source>(src: Source): Source | string {
  const { href = src } = (src ?? {}) as Partial<URL>;
  return href;
}

async function loadMode(kind: RunParts["kind"]): Promise<(host: ModeHost) => Mode> {
  if (kind === "full") return (await import("./full/full-mode.ts")).openFull;
  return (await import("./shop/shop-mode.ts")).openShop;
}

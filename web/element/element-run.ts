/** One time that the element is open: its mode is loaded, its model and design are opened, and in the end all of it is closed. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Design } from "../editor/document/design.ts";
import type { AssetLibrary } from "../editor/state/asset-library.ts";
import type { DesignSession } from "../editor/state/design-session.ts";
import { ToldError } from "../editor/strings/told-error.ts";
import type { PrintZones } from "../engine/print-zones.ts";
import type { UploadLimits } from "../engine/upload-check.ts";
import type { Desk } from "./desk/desk.ts";
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
  readonly limits: Required<UploadLimits>;
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
      // At once: while the model comes, what shows it does, and begins the engine.
      const address = addressIn(src);
      const reading =
        typeof address === "string"
          ? fetchModel(address, base, fetching)
          : import("./desk/given-model.ts").then(({ givenModel }) => givenModel(src, words));
      reading.catch(() => undefined);
      const { openMode } = await (kind === "full" ? import("./full/full-mode.ts") : import("./shop/shop-mode.ts"));
      this.#check();
      const mode = openMode(host);
      this.#made = mode;
      await host.made(mode);
      let zoned: Promise<[Desk, PrintZones]> | undefined;
      if (zones) {
        zoned = Promise.all([mode.takeDesk(), this.readZones(zones)]);
        zoned.catch(() => undefined);
      }
      const source = await reading;
      this.#check();
      progress(FETCHED);
      await mode.open(source, given != null || kept ? (library) => this.#firstDesign(library) : null);
      if (kept) mode.desk?.session.resume(kept);
      try {
        const [desk, read] = (await zoned) ?? [];
        await desk?.useZones(read ?? null);
      } catch (thrown) {
        // The page can correct them: the product is shown without.
        this.#check();
        host.hooks.warn(TexelcastError.wrap(thrown, "bad-zones", "The zones could not be read."));
      }
      this.#check();
      this.#open = true;
      return mode;
    } catch (thrown) {
      this.#check();
      this.close();
      throw thrown instanceof TexelcastError ? thrown : (await import("../engine/refused-worker.ts")).refused(thrown);
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

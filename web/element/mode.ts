/** What the element asks of either mode, shop or full. */
import type { CSSResult, TemplateResult } from "lit";
import type { Design } from "../editor/document/design.ts";
import type { ModelSource } from "../engine/engine-api.ts";
import type { Desk } from "./desk/desk.ts";
import type { DeskHooks } from "./desk/desk-settings.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "./element-api.ts";
import type { ShownError } from "./element-errors.ts";
import type { Words } from "./words/words.ts";

export interface Mode {
  readonly desk: Desk;
  /** For the element's shadow root. */
  readonly styles: readonly CSSResult[];
  /**
   * Opens a model with a design, which is read when the engine can take its files. Rejects with a TexelcastError; the mode is to
   * be closed then.
   */
  open(source: ModelSource, readDesign: () => Promise<Design>): Promise<void>;
  render(): TemplateResult;
  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string>;
  addText(text: string, options?: TextOptions): Promise<string>;
  /** Takes up the element's settings. */
  configure(): void;
  resize(): Promise<void>;
  idle(): Promise<void>;
  close(): void;
}

/** What a mode asks of the element around it. */
export interface ModeHost {
  readonly hooks: DeskHooks;
  /** A box of the element's for the 3D view: it has a size as soon as it is rendered. */
  readonly view: HTMLElement;
  /** "" for the bundler's. */
  readonly wasm: string;
  readonly words: Words;
  readonly shownError: ShownError | null;
  /** Tells the page and the user. */
  readonly tell: (thrown: unknown) => void;
  dismiss(): void;
  submit(): Promise<unknown>;
  requestUpdate(): void;
  /** To be told of a mode before it opens anything; resolves when it is rendered. */
  made(mode: Mode): Promise<void>;
}

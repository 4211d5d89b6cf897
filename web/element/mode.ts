/** What the element asks of either mode, shop or full. */
import type { CSSResult, TemplateResult } from "lit";
import type { Design } from "../editor/document/design.ts";
import type { AssetLibrary } from "../editor/state/asset-library.ts";
import type { MaterialInfo, ModelSource } from "../engine/engine-api.ts";
import type { ModelView } from "../viewer/viewer-api.ts";
import type { Desk } from "./desk/desk.ts";
import type { DeskHooks } from "./desk/desk-settings.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "./element-api.ts";
import type { Words } from "./words/words.ts";

/** Reads a design with the engine's help: its files are taken in. */
export type ReadDesign = (library: AssetLibrary) => Promise<Design>;

/** A mode whose desk is there. */
export interface AtDesk {
  readonly desk: Desk;
  idle(): Promise<void>;
}

export interface Mode {
  readonly viewer: ModelView;
  /** Where the design is worked on; null while there is none, and nobody did anything yet. */
  readonly desk: Desk | null;
  /** Loads the desk, if it is not there. Rejects with "cancelled" where the mode is closed meanwhile. */
  takeDesk(): Promise<Desk>;
  /** The open model's. */
  readonly materials: readonly MaterialInfo[];
  /** For the element's shadow root. */
  readonly styles: readonly CSSResult[];
  /**
   * Opens a model with a design, which is read when the engine can take its files, or (null) with nothing on it. Rejects with a
   * TexelcastError; the mode is to be closed then.
   */
  open(source: ModelSource, readDesign: ReadDesign | null): Promise<void>;
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
  /** Tells the page and the user. */
  readonly tell: (thrown: unknown) => void;
  dismiss(): void;
  submit(): Promise<unknown>;
  requestUpdate(): void;
  /** Gives styles to the element's shadow root. */
  adopt(styles: readonly CSSResult[]): void;
  /** To be told of a mode before it opens anything; resolves when it is rendered. */
  made(mode: Mode): Promise<void>;
}

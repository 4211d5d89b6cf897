/** Pictures as a brush's tip: those of the design, those that come with the page, and the user's own files. */
import { type Design, type DesignAsset, flattenLayers } from "../document/index.ts";
import { type DemoDecal, fetchBytes } from "../files/demo-catalogue.ts";
import { fileStem } from "../files/download.ts";
import { bytesOf } from "../files/file-bytes.ts";
import type { Admission } from "../state/admission.ts";
import type { AssetLibrary } from "../state/asset-library.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { NoticeBoard } from "../state/notice-board.ts";
import type { Store } from "../state/store.ts";
import { isClone } from "./clone-layer.ts";
import { isPixelLayer } from "./pixel-layer.ts";
import type { Toolbox } from "./toolbox.ts";

/** It becomes one of the design's assets when it first paints. */
export interface BrushTip {
  readonly name: string;
  readonly asset: DesignAsset;
}

/** The design's pictures that somebody chose: what pixel and clone tools made is of one place and no tip. */
export function tipsOf(design: Pick<Design, "assets" | "layers">): BrushTip[] {
  const made = new Set<string>();
  const printed = new Set<string>();
  /** What it is called in the list of layers, which a key ("mark", "badge-2") is not. */
  const chosen = new Map<string, string>();
  for (const layer of flattenLayers(design)) {
    if (layer.type === "decal") {
      const { asset, name } = layer;
      if (isPixelLayer(layer) || isClone(layer)) made.add(asset);
      else if (!chosen.has(asset)) chosen.set(asset, name);
    } else if (layer.type === "stroke" && layer.brush.tip === "picture") printed.add(layer.brush.asset);
  }
  const isTip = (key: string): boolean => chosen.has(key) || printed.has(key) || !made.has(key);
  return Object.entries(design.assets)
    .filter(([key, { type }]) => type.startsWith("image/") && isTip(key))
    .map(([key, asset]) => ({ name: chosen.get(key) ?? key, asset }));
}

export interface TipCommandsParts {
  readonly library: AssetLibrary;
  readonly store: Store<EditorState>;
  readonly tools: Toolbox;
  readonly board: NoticeBoard;
  readonly admission: Admission | null;
}

export class TipCommands {
  readonly #library: AssetLibrary;
  readonly #store: Store<EditorState>;
  readonly #tools: Toolbox;
  readonly #board: NoticeBoard;
  readonly #admission: Admission | null;

  constructor({ library, store, tools, board, admission }: TipCommandsParts) {
    this.#admission = admission;
    this.#library = library;
    this.#store = store;
    this.#tools = tools;
    this.#board = board;
  }

  /** Null paints a disc. */
  use(tip: BrushTip | null): void {
    this.#tools.configure({ tip });
    this.#board.announce(this.#board.strings.tips.chosen(tip?.name ?? this.#board.strings.tools.roundTip));
  }

  async useDemo({ name, picture }: DemoDecal): Promise<void> {
    const { demos } = this.#store.state;
    if (demos) await this.#take(name, picture, fetchBytes(picture, demos.page));
  }

  /** A file that cannot be read leaves the tip as it is. */
  async useFile(file: File): Promise<void> {
    await this.#take(fileStem(file.name), file.name, bytesOf(file));
  }

  async #take(name: string, fileName: string, bytes: Promise<Uint8Array>): Promise<void> {
    try {
      const given = await bytes;
      const admitted = await this.#admission?.admit("picture", fileName, given);
      const { asset } = await this.#library.add(fileName, admitted ?? given);
      this.use({ name, asset });
    } catch (thrown) {
      this.#board.error(this.#board.strings.errors.couldNotOpen(name), thrown);
    }
  }
}

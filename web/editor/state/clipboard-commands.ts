/**
 * Layers cut, copied and pasted, also into another project or another tab. They lie on the clipboard as the text of a design,
 * which is read and checked as one that was opened.
 */
import { isShippedFontAddress } from "../../engine/font-address.ts";
import { type Design, type DesignAsset, parseDesign, serialiseDesign } from "../document/index.ts";
import type { Admission } from "./admission.ts";
import type { AssetLibrary } from "./asset-library.ts";
import { placedCount } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { EditorState } from "./editor-state.ts";
import { clipOf } from "./layer-clip.ts";
import type { LayerCommands } from "./layer-commands.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";

export interface ClipboardCommandsParts {
  readonly session: DesignSession;
  readonly library: AssetLibrary;
  readonly layers: LayerCommands;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  readonly admission: Admission | null;
}

export class ClipboardCommands {
  readonly #parts: ClipboardCommandsParts;
  /** For the menu, which may not read the browser's clipboard. */
  #copied: Design | null = null;

  constructor(parts: ClipboardCommandsParts) {
    this.#parts = parts;
  }

  /** Whether `pasteAgain` has something to paste. */
  get holds(): boolean {
    return this.#copied !== null;
  }

  /** The chosen layers, as the clipboard takes them; null where none is chosen. */
  copy(ids = this.#parts.store.state.selection): string | null {
    const { session, board } = this.#parts;
    const clip = clipOf(session.recordedDesign, ids);
    if (clip.layers.length === 0) return null;
    this.#copied = clip;
    board.announce(board.strings.announce.copied(clip.layers.length));
    return serialiseDesign(clip);
  }

  /** As `copy`, and takes them out. Locked ones stay, and are not copied. */
  cut(): string | null {
    const { layers, store, board } = this.#parts;
    if (store.state.readonly) return this.copy();
    const free = layers.unlocked(store.state.selection);
    const text = this.copy(free);
    layers.remove(free, board.strings.steps.cut);
    return text;
  }

  /** Puts layers that were copied, here or elsewhere, above the selected one. */
  paste(text: string): Promise<void> {
    return this.#paste(() => parseDesign(text, this.#parts.board.strings.layers.clipboard));
  }

  /** Puts the layers that were copied last in this page. */
  async pasteAgain(): Promise<void> {
    const copied = this.#copied;
    if (copied) await this.#paste(() => copied);
  }

  async #paste(read: () => Design): Promise<void> {
    const { session, store, board, tasks } = this.#parts;
    const { readonly, layers } = board.strings;
    if (store.state.readonly) board.info({ title: readonly.title, message: readonly.message });
    else if (!store.state.model) board.info({ title: layers.emptyWithoutModel, message: "" });
    else {
      const work = this.#put(read).catch((thrown: unknown) => board.error(board.strings.errors.couldNotPaste, thrown));
      // What is undone or saved meanwhile waits until they are there.
      session.recordsLater(work);
      await tasks.quietly(work);
    }
  }

  async #put(read: () => Design): Promise<void> {
    const { library, layers, admission, board } = this.#parts;
    const clip = read();
    const checkRoom = (): void => admission?.checkRoom(placedCount(clip));
    checkRoom();
    const adopted = await library.adopt(await this.#admitted(clip), { path: board.strings.layers.clipboard });
    try {
      // Somebody may have added another one meanwhile.
      checkRoom();
      layers.put(adopted);
    } finally {
      library.release(Object.values(adopted.assets));
    }
  }

  /** Pictures and fonts that the page around has not seen yet are its to check. */
  async #admitted(clip: Design): Promise<Design> {
    const { admission, library } = this.#parts;
    if (!admission) return clip;
    const { decodeDataUri, encodeDataUri } = await import("../document/data-uri.ts");
    const assets: Record<string, DesignAsset> = {};
    for (const [key, asset] of Object.entries(clip.assets)) {
      const { type, uri } = asset;
      if (isShippedFontAddress(uri) || library.engineKey(asset) !== undefined) assets[key] = asset;
      else {
        const kind = type.startsWith("font/") ? "font" : "picture";
        const bytes = await admission.admit(kind, key, decodeDataUri(uri, `assets.${key}.uri`));
        assets[key] = { type, uri: encodeDataUri(type, bytes) };
      }
    }
    return { ...clip, assets };
  }
}

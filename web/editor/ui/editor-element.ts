/** What every panel is: a Lit element that is given the editor and renders again when the state it reads has changed. */
import type { PropertyDeclarations } from "lit";
import type { Editor } from "../state/editor.ts";
import type { EditorState } from "../state/editor-state.ts";
import { StoreController } from "../state/store.ts";
import type { Strings } from "../strings.ts";
import { RemElement } from "./rem-element.ts";

export abstract class EditorElement extends RemElement {
  static override properties: PropertyDeclarations = { editor: { attribute: false } };
  declare editor: Editor;

  /**
   * @param pace least milliseconds between two renders, for a panel of numbers that change in each frame of a drag; when the
   * drag ends its outcome is shown at once
   */
  constructor(pace = 0) {
    super();
    new StoreController<EditorState>(
      this,
      () => this.editor?.store,
      (state) => [state.language, state.readonly, ...this.watched(state)],
      // What a gesture only shows is no step of the history: a new one, or the old one again, ends it. And what is typed is for
      // the layers that the panel shows: it must not be behind with those.
      pace === 0 ? null : { milliseconds: pace, final: ({ history, selection }) => [history, selection] },
    );
  }

  /** The parts of the state that `render` reads. */
  protected abstract watched(state: EditorState): readonly unknown[];

  protected get strings(): Strings {
    return this.editor.strings;
  }

  protected get state(): EditorState {
    return this.editor.store.state;
  }
}

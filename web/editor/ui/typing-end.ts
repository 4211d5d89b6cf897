/** What stands in a field is for the layers that were chosen when it was typed. */
import type { ReactiveController } from "lit";
import type { EditorElement } from "./editor-element.ts";
import { focusedIn } from "./open-field.ts";

/** Leaves a panel's text field before the panel becomes that of other layers: a press on the model chooses them while one types. */
export class TypingEnd implements ReactiveController {
  readonly #host: EditorElement;
  #selection: readonly string[] = [];

  constructor(host: EditorElement) {
    this.#host = host;
    host.addController(this);
  }

  hostUpdate(): void {
    const { selection } = this.#host.editor.store.state;
    if (selection === this.#selection) return;
    this.#selection = selection;
    const field = focusedIn(this.#host.shadowRoot);
    if (field?.matches("textarea, input[type=text]")) field.blur();
  }
}

/**
 * What can be done with a decal where it lies: the chosen layers' menu on the model, by the right button, by the keyboard's
 * own key for it, and on a Mac by Ctrl and a press.
 */
import { css, html, type TemplateResult } from "lit";
import { EditorElement } from "../ui/editor-element.ts";
import type { Menu, MenuItem } from "../ui/menu.ts";
import { moreItems } from "./layer-acts.ts";

/** Pixels that the right button may wander: further, it moves the view. */
const SLOP = 3;

export class ModelMenu extends EditorElement {
  #pressed: PointerEvent | null = null;

  static override styles = css`
    :host {
      position: absolute;
    }
  `;

  protected watched(): readonly unknown[] {
    return [];
  }

  override render(): TemplateResult {
    return html`<tc-menu loose .name=${this.strings.layers.more}></tc-menu>`;
  }

  press(event: PointerEvent): void {
    this.#pressed = event.button === 2 ? event : null;
  }

  release(event: PointerEvent): void {
    const pressed = this.#pressed;
    if (event.button !== 2 || !pressed) return;
    this.#pressed = null;
    const [x, y] = [event.clientX, event.clientY];
    if (Math.hypot(x - pressed.clientX, y - pressed.clientY) <= SLOP) this.#openAt(x, y, true);
  }

  /** The browser's own word for it: of the right button some say it at the press, when it may still become a drag. */
  ask(event: MouseEvent): void {
    event.preventDefault();
    // A finger that is held is no question here.
    const { pointerType } = event as PointerEvent;
    if (event.button === 2 || pointerType === "touch" || pointerType === "pen") return;
    if (event.ctrlKey) {
      this.#openAt(event.clientX, event.clientY, true);
      return;
    }
    // By a key, which browsers tell of as of a mouse somewhere: for what is chosen, wherever it lies.
    const { left, top, width, height } = this.editor.viewer.element.getBoundingClientRect();
    this.#openAt(left + width / 2, top + height / 2, false);
  }

  #openAt(x: number, y: number, chooses: boolean): void {
    const { store, viewer } = this.editor;
    // A tool has the pointer for itself, and where the design is only looked at there is nothing to be done.
    if (store.state.tool !== "move" || store.state.readonly) return;
    if (chooses) viewer.clickAt(x, y);
    const menu = this.renderRoot.querySelector<Menu>("tc-menu");
    if (!menu) return;
    menu.items = possible(moreItems(this.editor, null));
    void menu.openAt(x, y);
  }
}
/** Beside the model, where nothing is chosen, most of them would be grey. */
function possible(items: readonly MenuItem[]): MenuItem[] {
  const kept: MenuItem[] = [];
  let separated = false;
  for (const item of items) {
    separated ||= item.separated === true;
    if (item.disabled) continue;
    kept.push({ ...item, separated: separated && kept.length > 0 });
    separated = false;
  }
  return kept;
}

customElements.define("tc-model-menu", ModelMenu);

declare global {
  interface HTMLElementTagNameMap {
    "tc-model-menu": ModelMenu;
  }
}

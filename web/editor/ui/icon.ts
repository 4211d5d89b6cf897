/** Lucide's icons (ISC licence, shown in the help dialog). Decorative: the control around one has the name. */
/// <reference path="./lucide-icons.d.ts" />
import { html, type TemplateResult } from "lit";
import type { IconNode } from "lucide";
import createElement from "lucide/dist/esm/createElement.mjs";

class Icon extends HTMLElement {
  #node: IconNode | undefined;

  set node(node: IconNode) {
    if (node === this.#node) return;
    this.#node = node;
    const drawing = createElement(node, { width: 16, height: 16, "stroke-width": 1.75 });
    drawing.style.display = "block";
    this.replaceChildren(drawing);
  }
}
customElements.define("tc-icon", Icon);

export const icon = (node: IconNode): TemplateResult => html`<tc-icon .node=${node} aria-hidden="true"></tc-icon>`;

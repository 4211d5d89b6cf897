/** The tools, one of which is chosen: a slim column beside the model, a row below it on a phone. */
import { css, html, type TemplateResult } from "lit";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import type { Tool } from "../tools/tool.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { OverflowFade } from "../ui/overflow-fade.ts";

const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 };

export class ToolRail extends EditorElement {
  /** The tool that was scrolled into sight last. */
  #shown: string | null = null;

  constructor() {
    super();
    new OverflowFade(this, "[role=radiogroup]");
  }

  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-direction: column;
        justify-content: center;
        pointer-events: none;
      }
      [role="radiogroup"] {
        pointer-events: auto;
        display: flex;
        flex-direction: column;
        gap: 2px;
        width: fit-content;
        padding: 3px;
        overflow: auto;
        border: 1px solid var(--line);
        border-radius: var(--radius-large);
        background: var(--surface);
        box-shadow: 0 1px 3px rgb(20 24 32 / 8%);
        overscroll-behavior: contain;
        /* What is scrolled into sight is not in the fade. */
        scroll-padding: 2.5rem;
        scrollbar-width: none;
      }
      button {
        flex: none;
        min-width: max(32px, var(--target));
        min-height: max(32px, var(--target));
      }
      button[aria-checked="true"] {
        background: var(--accent);
        color: var(--accent-text);
      }
      @media (hover: hover) {
        button.icon[aria-checked="true"]:hover {
          background: color-mix(in oklab, var(--accent), black 8%);
          color: var(--accent-text);
        }
      }
      :host([data-sheet="below"]) [role="radiogroup"] {
        flex-direction: row;
        max-width: 100%;
        margin-inline: auto;
      }
    `,
  ];

  get #words(): Strings["tools"] {
    return this.strings.tools;
  }

  protected watched(state: EditorState): readonly unknown[] {
    const { tool, model, targets, design, selectedId, material, toolSettings, sheet } = state;
    return [tool, model === null, targets, design.layers.length, selectedId, material, toolSettings.pixelMode, sheet];
  }

  override render(): TemplateResult {
    const { tools } = this.editor;
    const { tool, sheet } = this.state;
    this.dataset.sheet = sheet ?? "";
    return html`
      <div role="radiogroup" aria-label=${this.#words.label} aria-orientation=${sheet === "below" ? "horizontal" : "vertical"} @keydown=${this.#key}>
        ${tools.offered.map(
          ({ id, label, icon: drawing, shortcut }) => html`<button
            class="icon"
            role="radio"
            id=${`tool-${id}`}
            data-tool=${id}
            aria-checked=${id === tool}
            aria-label=${label(this.strings)}
            aria-keyshortcuts=${shortcut}
            tabindex=${id === tool ? 0 : -1}
            title=${this.#words.withKey(label(this.strings), shortcut)}
            @click=${() => tools.choose(id)}
          >
            ${icon(drawing)}
          </button>`,
        )}
      </div>
    `;
  }

  override updated(): void {
    const { tool } = this.state;
    if (tool === this.#shown) return;
    this.#shown = tool;
    this.renderRoot.querySelector(`#tool-${tool}`)?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  #key(event: KeyboardEvent): void {
    const step = STEPS[event.key];
    if (step === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const { tools } = this.editor;
    const { offered } = tools;
    const at = offered.findIndex(({ id }) => id === this.state.tool);
    const next: Tool | undefined = offered[(at + step + offered.length) % offered.length];
    if (!next) return;
    tools.choose(next.id);
    this.renderRoot.querySelector<HTMLElement>(`#tool-${next.id}`)?.focus();
  }
}
customElements.define("tc-tool-rail", ToolRail);

/** The right panel: adding, the list, properties, texture settings. On a phone it is one of these at a time. */
import { css, html, nothing, type TemplateResult } from "lit";
import type { EditorState } from "../state/editor-state.ts";
import { strings } from "../strings.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { controls } from "../ui/theme.ts";

export type Section = "decals" | "properties" | "target";

export class SidePanel extends EditorElement {
  static override properties = { only: {} };
  /** Shows one section; null shows all. */
  declare only: Section | null;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
        min-width: 0;
        min-height: 0;
        overflow: hidden auto;
        overscroll-behavior: contain;
        background: var(--surface);
        scrollbar-width: thin;
        scrollbar-color: var(--line-strong) transparent;
      }
      .section > * {
        isolation: isolate;
      }
      .section {
        display: grid;
        gap: var(--space-3);
        padding: var(--space-4);
      }
      .section + .section {
        border-top: 1px solid var(--line);
      }
    `,
  ];

  constructor() {
    super();
    this.only = null;
  }

  protected watched({ model }: EditorState): readonly unknown[] {
    return [model === null];
  }

  override render(): TemplateResult {
    const { editor, only } = this;
    const { model } = this.state;
    const shows = (section: Section): boolean => only === null || only === section;
    const heading = (text: string) => (only === null ? html`<h2>${text}</h2>` : nothing);
    return html`
      ${
        shows("decals")
          ? html`<div class="section">
              <tc-decal-list .editor=${editor}></tc-decal-list>
              <tc-decal-palette .editor=${editor}></tc-decal-palette>
            </div>`
          : nothing
      }
      ${
        shows("properties")
          ? html`<div class="section">
              ${heading(strings.properties.title)}
              <tc-decal-properties .editor=${editor}></tc-decal-properties>
            </div>`
          : nothing
      }
      ${
        shows("target") && model
          ? html`<div class="section">
              ${heading(strings.target.title)}
              <tc-target-settings .editor=${editor}></tc-target-settings>
            </div>`
          : nothing
      }
    `;
  }
}
customElements.define("tc-side-panel", SidePanel);

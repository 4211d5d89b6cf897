/** What a tool or the view's button lays open, as a panel of the sheet or of the side. */
import { html, type TemplateResult } from "lit";
import { X } from "lucide";
import type { Editor } from "../state/editor.ts";
import type { LaidOpen } from "../tools/tool.ts";
import { icon } from "../ui/icon.ts";
import { offersToolPanel } from "./tool-options.ts";
import "./view-settings.ts";

/** Null where nothing is laid open, or the chosen tool has nothing to show there. */
export function openToolPanel(editor: Editor): LaidOpen | null {
  const { toolPanel } = editor.store.state;
  if (toolPanel === "view") return toolPanel;
  return toolPanel !== null && offersToolPanel(editor, toolPanel) ? toolPanel : null;
}

export function toolPanel(editor: Editor, panel: LaidOpen): TemplateResult {
  const { strings } = editor;
  const words = strings.tools;
  const close = (): void => editor.store.set({ toolPanel: null });
  const titles = {
    more: words.more,
    palette: strings.palette.show,
    tips: strings.tips.title,
    view: strings.views.menu,
  };
  const label = panel === "view" ? strings.views.close : words.closePanel;
  return html`<div class="tool">
    <header>
      <h2>${titles[panel]}</h2>
      <button class="icon" id="close-tool" aria-label=${label} title=${label} @click=${close}>
        ${icon(X)}
      </button>
    </header>
    ${
      panel === "view"
        ? html`<tc-view-settings .editor=${editor}></tc-view-settings>`
        : html`<tc-tool-options sheet .editor=${editor}></tc-tool-options>`
    }
  </div>`;
}

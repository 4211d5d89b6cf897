/** What a tool lays open, as a panel of the sheet or of the side. */
import { html, type TemplateResult } from "lit";
import { X } from "lucide";
import type { Editor } from "../state/editor.ts";
import type { ToolPanel } from "../tools/tool.ts";
import { icon } from "../ui/icon.ts";
import { offersToolPanel } from "./tool-options.ts";

/** Null where nothing is laid open, or the chosen tool has nothing to show there. */
export function openToolPanel(editor: Editor): ToolPanel | null {
  const { toolPanel } = editor.store.state;
  return toolPanel !== null && offersToolPanel(editor, toolPanel) ? toolPanel : null;
}

export function toolPanel(editor: Editor, panel: ToolPanel): TemplateResult {
  const { strings } = editor;
  const words = strings.tools;
  const close = (): void => editor.store.set({ toolPanel: null });
  return html`<div class="tool">
    <header>
      <h2>${{ more: words.more, palette: strings.palette.show, tips: strings.tips.title }[panel]}</h2>
      <button class="icon" id="close-tool" aria-label=${words.closePanel} title=${words.closePanel} @click=${close}>
        ${icon(X)}
      </button>
    </header>
    <tc-tool-options sheet .editor=${editor}></tc-tool-options>
  </div>`;
}

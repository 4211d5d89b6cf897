/** Name, model menu, history, design and export. */
import { css, html, nothing, type TemplateResult } from "lit";
import {
  Box,
  CircleQuestionMark,
  Download,
  FileArchive,
  FileDown,
  Folder,
  FolderOpen,
  Image,
  LayoutGrid,
  LayoutTemplate,
  Pencil,
  Plus,
  Redo2,
  Save,
  Smartphone,
  Undo2,
} from "lucide";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { ACCEPT } from "../ui/accepted-files.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { pickFiles, picksFolders } from "../ui/file-picker.ts";
import { icon } from "../ui/icon.ts";
import type { MenuItem } from "../ui/menu.ts";
import { unseen } from "../ui/unseen.ts";
import "./layout-switch.ts";

export class TopBar extends EditorElement {
  static override properties = { compact: { type: Boolean }, embedded: { type: Boolean } };
  /** On a phone: only what fits in one row. */
  declare compact: boolean;
  /** In a page of somebody else's, which has its own model and design. */
  declare embedded: boolean;

  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        align-items: center;
        gap: var(--space-1);
        min-width: 0;
        padding: var(--space-1) var(--space-3);
        background: var(--surface);
        border-bottom: 1px solid var(--line);
      }
      h1 {
        margin: 0 var(--space-2) 0 0;
        font-size: var(--text-large);
        font-weight: 650;
        letter-spacing: -0.01em;
      }
      .group {
        display: flex;
        align-items: center;
        gap: 2px;
      }
      /* A long name leaves the other one its half; what both leave is the gap's. */
      .projects,
      .models {
        flex: 1000 1 0;
        min-width: 0;
        max-width: max-content;
      }
      .gap {
        flex: 1;
      }
      .divider {
        width: 1px;
        height: 1.25rem;
        margin-inline: var(--space-2);
        background: var(--line);
      }
      .save {
        position: relative;
      }
      .unsaved {
        position: absolute;
        inset-block-start: calc(50% - 11px);
        inset-inline-end: calc(50% - 12px);
        width: 6px;
        height: 6px;
        border-radius: 50%;
        background: var(--accent);
        forced-color-adjust: none;
      }
      /* There is no room to see it; screen readers begin with it. */
      @media (max-width: 900px) {
        h1 {
          ${unseen}
        }
      }
      @media (max-width: 720px), (max-width: 800px) and (pointer: coarse) {
        :host {
          padding-inline: var(--space-2);
          gap: 0;
        }
        .divider {
          display: none;
        }
      }
    `,
  ];

  constructor() {
    super();
    this.compact = false;
    this.embedded = false;
  }

  get #words(): Strings["topBar"] {
    return this.strings.topBar;
  }

  protected watched(state: EditorState): readonly unknown[] {
    const { model, undoLabel, redoLabel, unsaved, demos, switching, designName, keeping } = state;
    return [model, undoLabel, redoLabel, unsaved, demos, switching, designName, keeping];
  }

  override render(): TemplateResult {
    const { model, undoLabel, redoLabel, switching, designName, readonly } = this.state;
    const { files } = this.editor;
    const [cannotUndo, cannotRedo] = [undoLabel, redoLabel].map((label) => label === null || switching || readonly);
    return html`
      ${this.embedded ? nothing : html`<h1 class=${this.compact ? "visually-hidden" : nothing}>${this.strings.productName}</h1>`}
      ${this.embedded ? nothing : this.#own(model?.ref.title ?? this.#words.noModel, designName)}
      <div class="group">
        <button
          class="icon"
          id="undo"
          aria-label=${this.#words.undo(undoLabel)}
          title=${this.#words.undo(undoLabel)}
          aria-disabled=${cannotUndo}
          @click=${() => cannotUndo || files.travel("undo")}
        >
          ${icon(Undo2)}
        </button>
        <button
          class="icon"
          id="redo"
          aria-label=${this.#words.redo(redoLabel)}
          title=${this.#words.redo(redoLabel)}
          aria-disabled=${cannotRedo}
          @click=${() => cannotRedo || files.travel("redo")}
        >
          ${icon(Redo2)}
        </button>
      </div>
      <span class="gap"></span>
      <div class="group">
        ${this.compact ? nothing : this.#designButtons()}
        <tc-menu
          .label=${this.compact ? "" : this.#words.export}
          .name=${this.compact ? `${this.#words.design}, ${this.#words.export}` : this.#words.export}
          .icon=${Download}
          .items=${this.compact ? [...this.#designItems(), ...this.#exportItems(true)] : this.#exportItems(false)}
          alignEnd
        ></tc-menu>
      </div>
      ${
        this.compact
          ? nothing
          : html`
              <span class="divider"></span>
            `
      }
      <tc-layout-switch .editor=${this.editor} ?compact=${this.compact}></tc-layout-switch>
      <button class="icon" id="help" aria-label=${this.#words.help} title=${this.#words.help} @click=${() => this.#askForHelp()}>
        ${icon(CircleQuestionMark)}
      </button>
    `;
  }

  /** What is chosen here is the page's to choose where the editor is part of one. */
  #own(title: string, designName: string): TemplateResult {
    return html`
      <tc-menu
        class="projects"
        .kind=${this.#words.project}
        .label=${this.compact ? "" : designName}
        .name=${`${this.#words.project}: ${designName}`}
        .icon=${Folder}
        .items=${this.#projectItems()}
      ></tc-menu>
      <tc-menu
        class="models"
        .kind=${this.#words.models}
        .label=${title}
        .icon=${Box}
        ?yielding=${this.compact}
        .name=${`${this.#words.models}: ${title}`}
        .items=${this.#modelItems()}
      ></tc-menu>
      <span class="divider"></span>
    `;
  }

  #designButtons(): TemplateResult {
    const unsaved = isNowhere(this.state);
    const open = html`<button class="icon" id="open-design" aria-label=${this.#words.openDesign} title=${this.#words.openDesign} @click=${() => this.#openDesign()}>
        ${icon(FolderOpen)}
      </button>`;
    return html`
      ${this.embedded ? nothing : open}
      <button
        class="icon save"
        id="save-design"
        aria-label=${unsaved ? `${this.#words.saveDesign}. ${this.#words.unsaved}` : this.#words.saveDesign}
        title=${unsaved ? `${this.#words.saveDesign}. ${this.#words.unsaved}` : this.#words.saveDesign}
        @click=${() => void this.editor.files.saveDesign()}
      >
        ${icon(Save)}${unsaved ? html`<span class="unsaved"></span>` : nothing}
      </button>
    `;
  }

  #projectItems(): MenuItem[] {
    const { keeping, model } = this.state;
    const { projects, files } = this.editor;
    const projectWords = this.strings.projects;
    const none = model === null;
    return [
      {
        label: projectWords.all,
        hint: projectWords.keeping[keeping] || projectWords.allHint,
        icon: LayoutGrid,
        run: () => this.dispatchEvent(new CustomEvent("projects")),
      },
      {
        label: projectWords.create,
        icon: Plus,
        run: () => this.dispatchEvent(new CustomEvent("templates")),
      },
      {
        label: projectWords.renameThis,
        icon: Pencil,
        // What is kept nowhere yet, or cannot be, has no name to change.
        disabled: none || keeping === "untouched" || keeping === "refused",
        run: () => this.dispatchEvent(new CustomEvent("projects", { detail: "rename" })),
      },
      {
        label: projectWords.saveFile,
        hint: projectWords.saveFileHint,
        icon: FileArchive,
        disabled: none,
        separated: true,
        run: () => void projects.saveFile(true),
      },
      {
        label: projectWords.saveFileWithoutModel,
        hint: projectWords.saveFileWithoutModelHint,
        icon: Save,
        disabled: none,
        run: () => void projects.saveFile(false),
      },
      {
        label: projectWords.openFile,
        hint: projectWords.openFileHint,
        icon: FolderOpen,
        run: () => pickFiles({ accept: ACCEPT.any }, (chosen) => void files.openFiles(chosen)),
      },
    ];
  }

  #modelItems(): MenuItem[] {
    const { demos, model } = this.state;
    const { files } = this.editor;
    const demoItems = (demos?.models ?? []).map((demo, index): MenuItem => {
      const item = {
        label: demo.name,
        checked: model?.ref.demoId === demo.id,
        run: () => void files.openDemo(demo),
      };
      return index === 0 ? { ...item, heading: this.#words.demos } : item;
    });
    return [
      ...demoItems,
      {
        label: this.#words.newFromTemplate,
        hint: this.#words.newFromTemplateHint,
        icon: LayoutTemplate,
        separated: demoItems.length > 0,
        run: () => this.dispatchEvent(new CustomEvent("templates")),
      },
      {
        label: this.#words.openModel,
        hint: this.#words.openModelHint,
        icon: Box,
        run: () => pickFiles({ accept: ACCEPT.model }, (chosen) => void files.openFiles(chosen)),
      },
      ...(picksFolders() ? [this.#openFolderItem()] : []),
    ];
  }

  #openFolderItem(): MenuItem {
    return {
      label: this.#words.openFolder,
      hint: this.#words.openFolderHint,
      icon: FolderOpen,
      run: () => pickFiles({ accept: "", folder: true }, (chosen) => void this.editor.files.openFiles(chosen)),
    };
  }

  #openItem(): MenuItem {
    return {
      label: this.#words.openDesign,
      icon: FolderOpen,
      heading: this.#words.design,
      run: () => this.#openDesign(),
    };
  }

  #designItems(): MenuItem[] {
    const open = this.embedded ? [] : [this.#openItem()];
    return [...open, { label: this.#words.saveDesign, icon: Save, run: () => void this.editor.files.saveDesign() }];
  }

  #exportItems(headed: boolean): MenuItem[] {
    const { files } = this.editor;
    const none = this.state.model === null;
    return [
      {
        label: this.#words.exportPng,
        hint: this.#words.exportPngHint,
        icon: Image,
        disabled: none,
        ...(headed && { heading: this.#words.export }),
        run: () => void files.exportPng(),
      },
      {
        label: this.#words.exportGlb,
        hint: this.#words.exportGlbHint,
        icon: FileDown,
        disabled: none,
        run: () => void files.exportGlb(),
      },
      {
        label: this.#words.exportUsdz,
        hint: this.#words.exportUsdzHint,
        icon: Smartphone,
        disabled: none,
        run: () => void files.exportUsdz(),
      },
    ];
  }

  #openDesign(): void {
    pickFiles({ accept: ACCEPT.design }, (chosen) => void this.editor.files.openFiles(chosen));
  }

  #askForHelp(): void {
    this.dispatchEvent(new CustomEvent("help"));
  }
}
customElements.define("tc-top-bar", TopBar);

/** Neither in a file nor in the browser's database, nor on the way there: what is kept by itself has nothing unsaved. */
function isNowhere({ unsaved, keeping }: EditorState): boolean {
  return unsaved && keeping !== "kept" && keeping !== "pending";
}

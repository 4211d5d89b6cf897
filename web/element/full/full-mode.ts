/** The whole editor inside the element: loaded when a page asks for it, and never with the shop's mode. */
import { css, html, type TemplateResult } from "lit";
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { Design } from "../../editor/document/design.ts";
import { Editor } from "../../editor/state/editor.ts";
import { stringsIn } from "../../editor/strings.ts";
import "../../editor/workbench.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import { createEngineClient } from "../../engine/engine-client.ts";
import { createModelViewer } from "../../viewer/model-viewer.ts";
import { createTextureView } from "../../viewer/texture-view.ts";
import type { TextureView } from "../../viewer/viewer-api.ts";
import { Desk } from "../desk/desk.ts";
import { addPicture } from "../desk/placing.ts";
import { Texts } from "../desk/texts.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "../element-api.ts";
import type { Mode, ModeHost } from "../mode.ts";

const styles = css`
  .full {
    position: absolute;
    inset: 0;
    display: grid;
    grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
  }
  .full .view {
    position: relative;
    inset: auto;
  }
  .full .foot {
    display: flex;
    align-items: center;
    justify-content: end;
    gap: 0.5rem;
    padding: 0.5rem 0.75rem max(0.5rem, env(safe-area-inset-bottom));
    border-block-start: 1px solid var(--_line);
    background: var(--_surface);
  }
`;

/** Throws a TexelcastError without WebGL 2. */
export function openFull(host: ModeHost): Mode {
  return new FullMode(host);
}

class FullMode implements Mode {
  readonly styles = [styles];
  readonly #host: ModeHost;
  readonly #editor: Editor;
  readonly desk: Desk;
  readonly #texts: Texts;
  readonly #textureView: TextureView;

  constructor(host: ModeHost) {
    this.#host = host;
    const workbench = document.createElement("tc-workbench");
    workbench.embedded = true;
    const place = (slot: string): HTMLElement => {
      const view = document.createElement("div");
      view.slot = slot;
      Object.assign(view.style, { position: "absolute", inset: "0" });
      workbench.append(view);
      return view;
    };
    const places = { view: place("view"), texture: place("texture") };
    // Only what stands in the element's own tree is given the views' style there; it is shown when it has its editor.
    workbench.hidden = true;
    const holder = document.createElement("div");
    holder.append(places.view, places.texture);
    host.view.append(holder);
    const { language } = host.words;
    const strings = stringsIn(language);
    const viewer = createModelViewer(places.view, { label: strings.stage.view });
    const engine = createEngineClient(host.wasm === "" ? {} : { wasm: host.wasm });
    const textureView = createTextureView(places.texture, {
      label: strings.texture.view,
      onNeedsFullUpdate: (material) => editor.refresh(material),
      readTexels: (material, x, y, width, height) => engine.readTexels(material, x, y, width, height),
    });
    this.#textureView = textureView;
    const editor = new Editor({ engine, viewer, textureView, keeps: false, language });
    this.#editor = editor;
    workbench.editor = editor;
    workbench.append(places.view, places.texture);
    workbench.hidden = false;
    holder.replaceWith(workbench);
    const { store, session, library } = editor;
    this.desk = new Desk({ engine, viewer, store, session, library, hooks: host.hooks });
    this.#texts = new Texts(this.desk);
  }

  async open(source: ModelSource, readDesign: () => Promise<Design>): Promise<void> {
    const ref = { source, title: source.name, demoId: null };
    const { size, material } = this.desk.settings;
    const settings = new Map(size === null ? [] : [[material ?? 0, { size, gutter: null }] as const]);
    await this.#editor.open(ref, await readDesign(), settings);
    this.desk.store.set({ starting: false });
    this.desk.opened();
    this.configure();
    await this.desk.engine.idle();
  }
  render(): TemplateResult {
    const { words, view, submit, tell } = this.#host;
    const handIn = (): void => void submit().catch(tell);
    return html`
      <div class="full" part="full">
        ${view}
        <div class="foot" part="foot">
          <slot name="toolbar"></slot>
          <span class="own"><button class="filled" part="button submit-button" data-act="submit" @click=${handIn}>
            <slot name="submit">${words.submit}</slot>
          </button></span>
        </div>
      </div>
    `;
  }
  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return addPicture(this.desk, source, options);
  }
  addText(text: string, options?: TextOptions): Promise<string> {
    return this.#texts.add(text, options);
  }
  configure(): void {
    const { camera, readonly, words } = this.desk.settings;
    const { viewer, store } = this.desk;
    viewer.setCamera(null, camera);
    store.set({ language: words.language });
    const { stage, texture } = this.#editor.strings;
    viewer.element.setAttribute("aria-label", stage.view);
    this.#textureView.element.setAttribute("aria-label", texture.view);
    if (readonly) throw new TexelcastError("unsupported", words.errors.fullReadonly, { field: "readonly" });
  }
  async resize(): Promise<void> {
    const { size } = this.desk.settings;
    this.#editor.configureTarget({ size, gutter: null });
    await this.idle();
  }
  idle(): Promise<void> {
    return this.#editor.idle();
  }
  close(): void {
    if (this.desk.closed) return;
    this.desk.close();
    this.#textureView.dispose();
  }
}

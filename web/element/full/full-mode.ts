/** The whole editor inside the element: loaded when a page asks for it, and never with the shop's mode. */
import { html, nothing, type TemplateResult } from "lit";
import { emptyDesign } from "../../editor/document/design.ts";
import type { Admission } from "../../editor/state/admission.ts";
import { Editor } from "../../editor/state/editor.ts";
import { stringsIn } from "../../editor/strings.ts";
import "../../editor/workbench.ts";
import { chosenModel } from "../../engine/chosen-model.ts";
import type { MaterialInfo, ModelSource } from "../../engine/engine-api.ts";
import { createEngineClient } from "../../engine/engine-client.ts";
import { createModelViewer } from "../../viewer/model-viewer.ts";
import { createTextureView } from "../../viewer/texture-view.ts";
import type { ModelView, TextureView } from "../../viewer/viewer-api.ts";
import { paintableMaterial } from "../desk/paintable.ts";
import { addPicture, admitPicture } from "../desk/placing.ts";
import { admitFont, Texts } from "../desk/texts.ts";
import type { DecalSource, PlaceOptions, TextOptions } from "../element-api.ts";
import type { Mode, ModeHost, ReadDesign } from "../mode.ts";
import { badgeStyles } from "../shop/badge-styles.ts";
import { HeatMap } from "../shop/heat-map.ts";
import { verdict } from "../shop/print-badges.ts";
import { FullDesk } from "./full-desk.ts";
import { fullStyles } from "./full-styles.ts";

/** Throws a TexelcastError without WebGL 2. */
export function openMode(host: ModeHost): Mode {
  return new FullMode(host);
}

class FullMode implements Mode {
  readonly styles = [badgeStyles, fullStyles];
  readonly #host: ModeHost;
  readonly #editor: Editor;
  readonly desk: FullDesk;
  readonly #texts: Texts;
  readonly #textureView: TextureView;
  readonly #heat: HeatMap;

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
    const engine = createEngineClient(host.wasm ? { wasm: host.wasm } : {});
    const textureView = createTextureView(places.texture, {
      label: strings.texture.view,
      onNeedsFullUpdate: (material) => editor.refresh(material),
      readTexels: (material, x, y, width, height) => engine.readTexels(material, x, y, width, height),
    });
    this.#textureView = textureView;
    const admission = this.#admission();
    const editor = new Editor({ engine, viewer, textureView, keeps: false, admission, language });
    this.#editor = editor;
    workbench.editor = editor;
    workbench.append(places.view, places.texture);
    workbench.hidden = false;
    holder.replaceWith(workbench);
    viewer.on("graphics", ({ lost }) => lost && host.hooks.graphicsLost());
    textureView.on("graphics", ({ lost }) => lost && host.hooks.graphicsLost());
    const { store, session, library } = editor;
    const loadHands = async (): Promise<typeof viewer> => viewer;
    this.desk = new FullDesk({ engine, viewer, loadHands, store, session, library, hooks: host.hooks });
    this.#texts = new Texts(this.desk);
    this.#heat = new HeatMap(
      this.desk,
      async (maps) => viewer.setMapPictures(maps),
      () => host.requestUpdate(),
    );
  }

  /** What the panels bring along is asked about as what the page's own script brings. */
  #admission(): Admission {
    return {
      checkRoom: (more) => this.desk.checkRoom(more),
      admit: async (kind, name, bytes) => {
        if (kind === "picture") return await admitPicture(this.desk, name, bytes);
        await admitFont(this.desk, name, bytes);
        return bytes;
      },
    };
  }

  get viewer(): ModelView {
    return this.desk.viewer;
  }
  get materials(): readonly MaterialInfo[] {
    return this.desk.store.state.model?.info.materials ?? [];
  }
  async takeDesk(): Promise<FullDesk> {
    return this.desk;
  }

  async open(given: ModelSource, readDesign: ReadDesign | null): Promise<void> {
    // The editor shows the file's variants: of a model that was given in one there are none.
    const source = await chosenModel(given);
    const ref = { source, title: source.name, demoId: null };
    this.#editor.resizeTargets(this.desk.settings.size);
    await this.#editor.open(ref, (await readDesign?.(this.desk.library)) ?? emptyDesign());
    this.#chooseMaterial();
    this.#editor.store.set({ starting: false });
    this.desk.opened();
    this.configure();
    await this.#settled();
  }

  render(): TemplateResult {
    const { words, view, submit, tell } = this.#host;
    const { desk } = this;
    const handIn = (): void => void submit().catch(tell);
    return html`
      <div class="full" part="full">
        ${view}
        <div class="foot" part="foot">
          <slot name="toolbar"></slot>
          ${desk.zones === null ? nothing : this.#quality()}
          ${
            desk.settings.readonly
              ? nothing
              : html`<span class="own"><button class="filled" part="button submit-button" data-act="submit" @click=${handIn}>
                  <slot name="submit">${words.submit}</slot>
                </button></span>`
          }
        </div>
      </div>
    `;
  }

  /** How it will be printed: in a word, and on the model. */
  #quality(): TemplateResult {
    const { words, tell } = this.#host;
    const { good, least } = words.heatLegend;
    const { shown } = this.#heat;
    return html`<div class="own quality">
      <button
        class="outlined"
        part="button heat-button"
        data-act="heat"
        aria-pressed=${shown}
        @click=${() => void this.#heat.toggle().catch(tell)}
      >
        ${words.heatMap}
      </button>
      ${
        shown
          ? html`<span class="legend"><span class="good">${good}</span><span class="bad">${least}</span></span>`
          : verdict(this.desk, words)
      }
    </div>`;
  }

  addDecal(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return addPicture(this.desk, source, options);
  }
  addText(text: string, options?: TextOptions): Promise<string> {
    return this.#texts.add(text, options);
  }

  configure(): void {
    const { camera, readonly, words } = this.desk.settings;
    const { viewer, session } = this.desk;
    const { store } = this.#editor;
    viewer.setCamera(null, camera);
    if (readonly && !store.state.readonly) {
      session.cancelPreview();
      session.select(null);
    }
    store.set({ language: words.language, readonly });
    const { stage, texture } = this.#editor.strings;
    viewer.element.setAttribute("aria-label", stage.view);
    this.#textureView.element.setAttribute("aria-label", texture.view);
  }

  async resize(): Promise<void> {
    this.#chooseMaterial();
    const { size } = this.desk.settings;
    if (size !== this.#editor.store.state.usualTarget.size) this.#editor.resizeTargets(size);
    await this.#settled();
  }

  #chooseMaterial(): void {
    const { desk } = this;
    const { model } = desk.store.state;
    if (model === null) return;
    desk.printed = paintableMaterial(model.info, desk.hooks);
    this.#editor.showMaterial(desk.printed);
  }

  /** What could not be drawn was told, and does not keep the model from being shown; an engine that ended does. */
  async #settled(): Promise<void> {
    await this.idle().catch(() => this.#editor.engine.stats());
  }

  async idle(): Promise<void> {
    await this.desk.settled();
    await this.#editor.idle();
  }
  close(): void {
    if (this.desk.closed) return;
    this.desk.close();
    this.#textureView.dispose();
  }
}

/** Everything about the selected layer, as fields; of several, what they have in common. */
import { html, nothing, type TemplateResult } from "lit";
import { ImageUp, Lock } from "lucide";
import type { DecalLayer, DesignLayer } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { layerById } from "../state/design-edits.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { isComposed } from "../ui/composed-key.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import { takeTyped } from "../ui/open-field.ts";
import { readonlyFields } from "../ui/readonly-fields.ts";
import { thumbnail, thumbnailStyles } from "../ui/thumbnail.ts";
import { TypingEnd } from "../ui/typing-end.ts";
import { brushFields } from "./brush-fields.ts";
import { fillFields, partsFields } from "./fill-fields.ts";
import { replacePicture } from "./layer-acts.ts";
import { maskFields } from "./mask-fields.ts";
import { mirrorFields } from "./mirror-fields.ts";
import { opacityField } from "./opacity-field.ts";
import { type PlacementMemory, placementFields } from "./placement-fields.ts";
import { projectionTools, togetherTools } from "./projector-tools.ts";
import { mixingFields, type PropertyContext, toggleField } from "./property-controls.ts";
import { propertyStyles } from "./property-styles.ts";
import { materialField, reachFields, samplingFields } from "./reach-fields.ts";
import "./text-fields.ts";

/** Milliseconds between two changes of the numbers: a score of fields, which nobody reads faster while a decal is dragged. */
const PACE = 100;

export class LayerProperties extends EditorElement {
  readonly #memory: PlacementMemory = { proportional: true, orientation: undefined };

  static override styles = [controls, thumbnailStyles, propertyStyles];

  constructor() {
    super(PACE);
    new TypingEnd(this);
  }

  get #words(): Strings["properties"] {
    return this.strings.properties;
  }

  protected watched(state: EditorState): readonly unknown[] {
    const { design, selectedId, selection, editingMask, model, tool, toolSettings, view, sheet } = state;
    const locked = selectedId !== null && isLocked(design, selectedId);
    const layer = layerById(design, selectedId);
    return [layer, selection, editingMask, locked, model, tool, toolSettings.recent, view.layout, sheet];
  }

  override render(): TemplateResult {
    const { design, selectedId, selection } = this.state;
    const layer = layerById(design, selectedId);
    if (!layer) {
      return html`<div class="none">
        <h2>${this.#words.none}</h2>
        <p class="quiet">${this.#words.noneBody}</p>
      </div>`;
    }
    const context: PropertyContext = { editor: this.editor, state: this.state, ids: selection };
    const locked = isLocked(design, layer.id);
    const several = selection.length > 1;
    const fields = html`
      ${several ? html`<h2>${this.strings.layers.several(selection.length)}</h2>` : this.#header(layer)}
      ${locked ? this.#lock(layer) : nothing}
      <div class="fields" ?inert=${locked}>
        ${several ? html`${togetherTools(this.editor)}${this.#look(context, layer)}` : html`${maskFields(context, layer)}${this.#fields(context, layer)}`}
      </div>
    `;
    return readonlyFields(this.state.readonly, this.strings.readonly.why, fields);
  }

  #fields(context: PropertyContext, layer: DesignLayer): TemplateResult {
    switch (layer.type) {
      case "decal":
      case "text":
        return html`
          ${layer.type === "text" ? html`<tc-text-fields .editor=${this.editor}></tc-text-fields>` : nothing}
          ${projectionTools(this.editor, layer)}
          ${placementFields(context, layer, this.#aspectOf(layer), this.#memory, () => this.requestUpdate())}
          ${mirrorFields(context, layer)}${this.#look(context, layer, samplingFields(context, layer))}${reachFields(context, layer)}
        `;
      case "stroke":
        return html`
          ${brushFields(context, layer)}${this.#look(context, layer, samplingFields(context, layer))}${mirrorFields(context, layer)}
          ${reachFields(context, layer)}
        `;
      case "fill":
        return html`
          <section role="group" aria-label=${this.strings.gradient.kind}>${fillFields(context, layer)}</section>
          ${partsFields(context, layer)}${this.#look(context, layer, materialField(context, layer))}
        `;
      case "paint":
        return html`
          <p class="quiet">${this.#words.strokes(layer.strokes.length)}</p>
          ${this.#look(context, layer)}${mirrorFields(context, layer)}
        `;
      case "group": {
        const isolated = toggleField(context, "isolated", this.#words.isolated, layer.isolated, (on) => ({
          isolated: on,
        }));
        return html`
          <p class="quiet">${this.#words.members(layer.layers.length)}</p>
          ${this.#look(context, layer, html`<div title=${this.#words.isolatedHint}>${isolated}</div>`)}
        `;
      }
    }
  }

  #look(context: PropertyContext, layer: DesignLayer, rest: TemplateResult | typeof nothing = nothing): TemplateResult {
    return html`<section role="group" aria-label=${this.#words.look}>
      ${opacityField(context, layer)}${mixingFields(context, layer)}${rest}
    </section>`;
  }

  /** Of its picture; null where it has none of its own. */
  #aspectOf(layer: DesignLayer): number | null {
    const asset = layer.type === "decal" ? (layer as DecalLayer).asset : undefined;
    const picture = asset === undefined ? undefined : this.editor.library.get(this.state.design.assets[asset]);
    return picture ? picture.width / picture.height : null;
  }

  #lock({ id, locked }: DesignLayer): TemplateResult {
    const { layers } = this.editor;
    return html`<div class="locked">
      ${icon(Lock)}
      <p>${locked ? this.strings.layers.lockedBody : this.strings.layers.lockedByGroup}</p>
      ${
        locked
          ? html`<button class="outlined" id="unlock" @click=${() => layers.toggleLocked([id])}>${this.strings.layers.unlockAct}</button>`
          : nothing
      }
    </div>`;
  }

  #replacing({ id }: DesignLayer): TemplateResult {
    const { replacePicture: label } = this.strings.layers;
    const replace = (): void => replacePicture(this.editor.files, id);
    return html`<button class="icon" id="replace-picture" aria-label=${label} title=${label} @click=${replace}>${icon(ImageUp)}</button>`;
  }

  #header(layer: DesignLayer): TemplateResult {
    const input = (event: Event): HTMLInputElement => event.target as HTMLInputElement;
    const keys = (event: KeyboardEvent): void => {
      const field = input(event);
      if (isComposed(event)) return;
      if (event.key === "Escape" && field.value !== layer.name) {
        event.stopPropagation();
        field.value = layer.name;
      } else if (event.key === "Enter") takeTyped(field);
      else return;
      field.select();
    };
    const rename = (event: Event): void => {
      this.editor.layers.rename(layer.id, input(event).value);
      // No name is none.
      input(event).value = layerById(this.state.design, layer.id)?.name ?? "";
    };
    const { library, engine } = this.editor;
    const { design, targets } = this.state;
    return html`
      <div class="header">
        ${thumbnail({ library, engine, design, targets }, layer)}
        <input
          type="text"
          id="name"
          dir="auto"
          aria-label=${this.#words.name}
          .value=${layer.name}
          maxlength="200"
          @keydown=${keys}
          @change=${rename}
        />
        ${layer.type === "decal" && !isLocked(design, layer.id) ? this.#replacing(layer) : nothing}
      </div>
    `;
  }
}
customElements.define("tc-layer-properties", LayerProperties);

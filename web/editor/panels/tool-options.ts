/**
 * What the chosen tool paints with: a quiet bar over the model. Only what the tool reads is there. What it lays open hangs
 * below the bar, and on touch screens, where it would cover the model, stands in the sheet or in the side's panel.
 */
import { html, nothing, type TemplateResult } from "lit";
import { ArrowLeftRight, ChevronDown, Palette, SlidersHorizontal } from "lucide";
import { windowOf } from "../../viewer/window-of.ts";
import { diagonalOf } from "../state/design-state.ts";
import type { Editor } from "../state/editor.ts";
import type { EditorState } from "../state/editor-state.ts";
import type { Strings } from "../strings.ts";
import { stepFor, unitFor } from "../tools/length-unit.ts";
import type { Tool, ToolOption, ToolPanel } from "../tools/tool.ts";
import { MOST_PIXEL_SIZE, type ToolSettings } from "../tools/tool-settings.ts";
import { controls } from "../ui/controls.ts";
import { EditorElement } from "../ui/editor-element.ts";
import { icon } from "../ui/icon.ts";
import type { NumberFieldEvent } from "../ui/number-field.ts";
import { OverflowFade } from "../ui/overflow-fade.ts";
import { recentColors } from "../ui/recent-colors.ts";
import "./color-palette.ts";
import { checkField, choiceField } from "./property-fields.ts";
import { propertyStyles } from "./property-styles.ts";
import "./tip-picker.ts";
import { toolOptionsStyles } from "./tool-options-styles.ts";

/** Characters from which a label needs a wider field. */
const LONG_LABEL = 7;

/** Options that stand behind the button "More": set once and left alone. */
const SELDOM: readonly ToolOption[] = ["flow", "spacing", "stabiliser", "pressure", "alphaLock", "aligned"];
/** What goes there besides, in this order, until the rest fits into the bar. */
const GIVES_WAY: readonly ToolOption[] = [
  ...(["mirror", "filled", "contiguous", "opacity", "hardness", "tolerance"] as const),
  ...(["size", "pixelSize", "tip"] as const),
];

export class ToolOptions extends EditorElement {
  static override properties = { coarse: { state: true }, sheet: { type: Boolean, reflect: true } };
  /** A finger is the pointer. */
  declare coarse: boolean;
  /** Shows only what is laid open, as a panel of the sheet. */
  declare sheet: boolean;
  /** What the bar's width follows from, as it was measured last. */
  #measured = "";
  #width: ResizeObserver | null = null;
  #pointer: MediaQueryList | null = null;
  #seenIn: Window & typeof globalThis = window;

  static override styles = [controls, propertyStyles, toolOptionsStyles];

  constructor() {
    super();
    // Where even the last of its options have no room.
    new OverflowFade(this, ".often");
    this.sheet = false;
    this.coarse = false;
  }

  get #words(): Strings["tools"] {
    return this.strings.tools;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.sheet) return;
    this.#seenIn = windowOf(this);
    this.#pointer = this.#seenIn.matchMedia("(pointer: coarse)");
    this.#pointer.addEventListener("change", this.#takeUp);
    this.#takeUp();
    this.#seenIn.addEventListener("pointerdown", this.#pressed, { capture: true });
    this.#width = new this.#seenIn.ResizeObserver(() => this.requestUpdate());
    this.#width.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#pointer?.removeEventListener("change", this.#takeUp);
    this.#seenIn.removeEventListener("pointerdown", this.#pressed, { capture: true });
    this.#width?.disconnect();
  }

  readonly #takeUp = (): void => {
    this.coarse = this.#pointer?.matches ?? false;
  };

  /** Where what is laid open would cover the model: it stands in the sheet or in the side's panel. */
  get #beside(): boolean {
    return this.coarse || Boolean(this.state.sheet);
  }

  /** A press elsewhere closes the seldom used fields; the palette stays while one paints. */
  readonly #pressed = (event: Event): void => {
    if (this.#beside || this.state.toolPanel !== "more" || event.composedPath().includes(this)) return;
    this.editor.store.set({ toolPanel: null });
  };

  protected watched(state: EditorState): readonly unknown[] {
    const { tool, toolSettings, model, design, selectedId, toolPanel, optionsGivenWay, sheet } = state;
    return [tool, toolSettings, model, design.assets, selectedId, toolPanel, optionsGivenWay, sheet];
  }

  override render(): TemplateResult | typeof nothing {
    const tool = this.editor.tools.active;
    if (!tool || (tool.options.length === 0 && !tool.renderOptions)) return nothing;
    const { toolPanel, optionsGivenWay } = this.state;
    const seldom = behind(tool, optionsGivenWay);
    if (this.sheet) return this.#laidOpen(tool, seldom);
    return html`
      <div class="bar" role="toolbar" aria-label=${this.#words.options}>
        <div class="often">
          ${tool.renderOptions?.() ?? nothing}
          ${tool.options.map((option) => (seldom.includes(option) ? nothing : this.#field(option, tool)))}
        </div>
        ${
          seldom.length > 0
            ? html`<button
                class="icon opens"
                id="more-options"
                aria-label=${this.#words.more}
                title=${this.#words.more}
                aria-expanded=${toolPanel === "more"}
                @click=${() => this.#toggle("more")}
              >
                ${icon(SlidersHorizontal)}
              </button>`
            : nothing
        }
        ${this.#beside ? nothing : this.#laidOpen(tool, seldom)}
      </div>
    `;
  }

  /** All may stand in the bar again where its room has changed or its content; and then one by one gives way. */
  override updated(): void {
    const bar = this.renderRoot.querySelector<HTMLElement>(".often");
    const tool = this.editor.tools.active;
    if (!bar || !tool) return;
    const { language, toolSettings, model, optionsGivenWay } = this.state;
    const now = [this.clientWidth, tool.id, language, toolSettings.tip === null, model?.ref.title].join();
    const anew = now !== this.#measured;
    this.#measured = now;
    const full = bar.scrollWidth > bar.clientWidth && optionsGivenWay < givingWay(tool).length;
    if (anew && optionsGivenWay > 0) this.editor.store.set({ optionsGivenWay: 0 });
    else if (full) this.editor.store.set({ optionsGivenWay: optionsGivenWay + 1 });
  }

  #laidOpen(tool: Tool, seldom: readonly ToolOption[]): TemplateResult | typeof nothing {
    const { toolPanel } = this.state;
    if (toolPanel === null || toolPanel === "view" || !offersToolPanel(this.editor, toolPanel)) return nothing;
    return html`<div class=${toolPanel === "more" ? "drop end" : "drop"} @keydown=${this.#closeByKey}>
      ${
        toolPanel === "more"
          ? seldom.map((option) => this.#field(option, tool))
          : toolPanel === "tips"
            ? html`<tc-tip-picker .editor=${this.editor}></tc-tip-picker>`
            : html`<tc-color-palette .editor=${this.editor}></tc-color-palette>`
      }
    </div>`;
  }

  #field(option: ToolOption, tool: Tool): TemplateResult | typeof nothing {
    const settings = this.state.toolSettings;
    switch (option) {
      case "color":
        return this.#colors(settings);
      case "tip":
        return tool.id === "eraser" ? nothing : this.#tip(settings);
      case "size":
        return this.#size(settings);
      case "pixelSize":
        return this.#number("pixelSize", this.#words.pixelSize, settings.pixelSize, {
          unit: this.#words.texelUnit,
          step: 1,
          min: 1,
          max: MOST_PIXEL_SIZE,
          set: (value) => ({ pixelSize: Math.round(value) }),
        });
      case "hardness":
        return settings.tip === null || tool.id === "eraser"
          ? this.#percent("hardness", this.#words.hardness, settings.hardness)
          : nothing;
      case "flow":
        return this.#percent("flow", this.#words.flow, settings.flow, 1);
      case "opacity":
        return this.#percent("opacity", this.#words.opacity, settings.opacity, 1);
      case "spacing":
        return this.#number("spacing", this.#words.spacing, settings.spacing * 100, {
          unit: "%",
          step: 1,
          min: 2,
          max: 300,
          set: (value) => ({ spacing: value / 100 }),
        });
      case "stabiliser":
        return this.#number("stabiliser", this.#words.stabiliser, settings.stabiliser, {
          hint: this.#words.stabiliserHint,
          step: 1,
          min: 0,
          max: 100,
          set: (value) => ({ stabiliser: value }),
        });
      case "pressure":
        return choiceField("pressure", this.#words.pressure, this.#words.pressures, settings.pressure, (pressure) =>
          this.#set({ pressure }),
        );
      case "mirror":
        return this.#mirror(settings);
      case "tolerance":
        return this.#number("tolerance", this.#words.tolerance, settings.tolerance, {
          hint: this.#words.toleranceHint,
          step: 1,
          min: 0,
          max: 255,
          set: (value) => ({ tolerance: Math.round(value) }),
        });
      case "aligned":
        return checkField("tool-aligned", this.strings.clone.aligned, settings.cloneAligned, (on) =>
          this.#set({ cloneAligned: on }),
        );
      case "contiguous":
      case "filled":
      case "alphaLock":
        return checkField(`tool-${option}`, this.#words[option], settings[option], (on) => this.#set({ [option]: on }));
    }
  }

  #colors({ color, background, recent }: ToolSettings): TemplateResult {
    const pick = (event: Event): void => this.editor.tools.useColor((event.target as HTMLInputElement).value);
    return html`
      <span class="colors">
        <input
          type="color"
          id="tool-color"
          aria-label=${this.#words.color}
          title=${this.#words.color}
          .value=${color}
          @input=${(event: Event) => this.#set({ color: (event.target as HTMLInputElement).value })}
          @change=${pick}
          list="recent-colors"
        />
        ${recentColors("recent-colors", recent)}
        <button
          class="icon second"
          id="swap-colors"
          .style=${`--second:${background}`}
          aria-label=${this.#words.swapColors}
          title=${this.#words.swapColors}
          @click=${() => this.editor.tools.swapColors()}
        >
          ${icon(ArrowLeftRight)}
        </button>
        <button
          class="icon opens"
          id="show-palette"
          aria-label=${this.strings.palette.show}
          title=${this.strings.palette.show}
          aria-expanded=${this.state.toolPanel === "palette"}
          @click=${() => this.#toggle("palette")}
        >
          ${icon(Palette)}
        </button>
      </span>
    `;
  }

  #tip({ tip }: ToolSettings): TemplateResult {
    return html`
      <button
        class="tip opens"
        id="tool-tip"
        aria-label=${this.strings.tips.label(tip?.name ?? this.#words.roundTip)}
        title=${this.strings.tips.label(tip?.name ?? this.#words.roundTip)}
        aria-expanded=${this.state.toolPanel === "tips"}
        @click=${() => this.#toggle("tips")}
      >
        ${tip === null ? html`<span class="disc"></span>` : html`<img src=${tip.asset.uri} alt="" />`}
        ${icon(ChevronDown)}
      </button>
    `;
  }

  #mirror({ mirror }: ToolSettings): TemplateResult {
    const choose = (event: Event): void =>
      this.#set({ mirror: (event.target as HTMLSelectElement).value as ToolSettings["mirror"] });
    return html`
      <select id="tool-mirror" class="mirror" aria-label=${this.#words.mirror} title=${this.#words.mirror} @change=${choose}>
        ${Object.entries(this.#words.mirrors).map(
          ([axis, text]) => html`<option value=${axis} ?selected=${axis === mirror}>${text}</option>`,
        )}
      </select>
    `;
  }

  #size({ size }: ToolSettings): TemplateResult | typeof nothing {
    const { model } = this.state;
    if (size === null || !model) return nothing;
    const { least, most } = this.editor.tools.sizes;
    const { symbol, perMetre } = unitFor(diagonalOf(model));
    return this.#number("size", this.#words.size, size * perMetre, {
      unit: symbol,
      step: stepFor(size * perMetre),
      min: least * perMetre,
      max: most * perMetre,
      set: (value) => ({ size: value / perMetre }),
    });
  }

  #percent(field: "hardness" | "flow" | "opacity", label: string, value: number, min = 0): TemplateResult {
    return this.#number(field, label, value * 100, {
      unit: "%",
      step: 1,
      min,
      max: 100,
      set: (percent) => ({ [field]: percent / 100 }),
    });
  }

  #number(
    field: string,
    label: string,
    value: number,
    more: {
      readonly unit?: string;
      readonly hint?: string;
      readonly step: number;
      readonly min: number;
      readonly max: number;
      readonly set: (value: number) => Partial<ToolSettings>;
    },
  ): TemplateResult {
    const change = (event: CustomEvent<NumberFieldEvent>): void => this.#set(more.set(event.detail.value));
    return html`<tc-number
      class=${label.length > LONG_LABEL ? "long" : ""}
      data-field=${`tool-${field}`}
      .label=${label}
      .name=${label}
      .hint=${more.hint ?? ""}
      .unit=${more.unit ?? ""}
      .value=${value}
      .step=${more.step}
      .min=${more.min}
      .max=${more.max}
      @field-preview=${change}
      @field-change=${change}
      @field-cancel=${change}
    ></tc-number>`;
  }

  #set(settings: Partial<ToolSettings>): void {
    this.editor.tools.configure(settings);
  }

  #toggle(what: ToolPanel): void {
    this.editor.store.set({ toolPanel: this.state.toolPanel === what ? null : what });
  }

  #closeByKey(event: KeyboardEvent): void {
    const { toolPanel } = this.state;
    if (event.key !== "Escape" || toolPanel === null || toolPanel === "view") return;
    event.stopPropagation();
    const opener = { more: "#more-options", palette: "#show-palette", tips: "#tool-tip" }[toolPanel];
    this.editor.store.set({ toolPanel: null });
    this.renderRoot.querySelector<HTMLElement>(opener)?.focus();
  }
}
customElements.define("tc-tool-options", ToolOptions);

function givingWay(tool: Tool): ToolOption[] {
  return GIVES_WAY.filter((option) => tool.options.includes(option));
}

/** What stands behind the button "More", in the tool's own order. */
function behind(tool: Tool, givenWay: number): ToolOption[] {
  const given = givingWay(tool).slice(0, givenWay);
  return tool.options.filter((option) => SELDOM.includes(option) || given.includes(option));
}

/** Whether the chosen tool has something for a panel to show. */
export function offersToolPanel({ tools, store }: Editor, panel: ToolPanel): boolean {
  const tool = tools.active;
  if (!tool) return false;
  if (panel === "more") return behind(tool, store.state.optionsGivenWay).length > 0;
  return tool.options.includes(panel === "tips" ? "tip" : "color");
}

/** A row of the layer list. */
import { html, nothing, type TemplateResult } from "lit";
import { ChevronDown, ChevronRight, Eye, EyeOff, GripVertical, type IconNode, Lock, LockOpen } from "lucide";
import type { DesignLayer } from "../document/index.ts";
import type { LayerRow } from "../state/layer-rows.ts";
import type { Strings } from "../strings.ts";
import { isComposed } from "../ui/composed-key.ts";
import { icon } from "../ui/icon.ts";
import { maskPicture, type ThumbnailSource, thumbnail } from "../ui/thumbnail.ts";

/** Pixels a level of depth. */
export const INDENT = 14;

export interface RowLook {
  /** Place among all rows, from the top. */
  readonly at: number;
  readonly thumbnails: ThumbnailSource;
  readonly chosen: boolean;
  /** The one that the properties are about. */
  readonly primary: boolean;
  /** The tab key reaches it. */
  readonly reachable: boolean;
  readonly renaming: boolean;
  readonly dragged: boolean;
  /** Dragged layers would go into it. */
  readonly into: boolean;
  readonly editsMask: boolean;
  readonly words: Strings["layers"];
  /** The design is only looked at. */
  readonly readonly: boolean;
  /** Some row holds layers: those that do not leave room for what opens them. */
  readonly twists: boolean;
}

export interface RowActs {
  readonly press: (event: PointerEvent, id: string, byGrip: boolean) => void;
  readonly choose: (event: MouseEvent, id: string) => void;
  readonly show: (id: string) => void;
  readonly startRename: (id: string) => void;
  /** Null: as it was. `byKey`: the keyboard stays with the row. */
  readonly endRename: (id: string, name: string | null, byKey: boolean) => void;
  readonly setCollapsed: (id: string, collapsed: boolean) => void;
  readonly editMask: (id: string, on: boolean) => void;
  readonly toggleVisible: (id: string) => void;
  readonly toggleLocked: (id: string) => void;
}

export function layerRow(row: LayerRow, look: RowLook, acts: RowActs): TemplateResult {
  const { words } = look;
  const { layer, depth, place, count, hiddenAbove } = row;
  const { id, name, visible } = layer;
  const classes = [
    "row",
    look.chosen && "chosen",
    look.primary && "primary",
    (!visible || hiddenAbove) && "off",
    look.dragged && "dragged",
    look.into && "into",
  ];
  return html`
    <div
      class=${classes.filter(Boolean).join(" ")}
      role="row"
      data-id=${id}
      tabindex=${look.reachable ? 0 : -1}
      aria-rowindex=${look.at + 1}
      aria-level=${depth}
      aria-posinset=${place}
      aria-setsize=${count}
      aria-selected=${look.chosen}
      aria-current=${look.primary ? "true" : nothing}
      aria-expanded=${layer.type === "group" ? row.expanded : nothing}
      aria-label=${spokenName(row, words)}
      .style=${`--at: ${look.at}; padding-inline-start: ${(depth - 1) * INDENT + 2}px`}
      @pointerdown=${(event: PointerEvent) => acts.press(event, id, false)}
      @click=${(event: MouseEvent) => acts.choose(event, id)}
    >
      ${nameCell(row, look, acts)}${switches(row, look, acts)}
      <span
        class="grip"
        title=${words.drag(name)}
        @pointerdown=${(event: PointerEvent) => acts.press(event, id, true)}
        >${icon(GripVertical)}</span
      >
    </div>
  `;
}

function nameCell(row: LayerRow, look: RowLook, acts: RowActs): TemplateResult {
  const { words } = look;
  const { layer, expanded } = row;
  const { id, name, mask } = layer;
  const twist =
    layer.type === "group"
      ? iconButton(
          "twist",
          expanded ? words.close(name) : words.open(name),
          expanded ? ChevronDown : ChevronRight,
          () => acts.setCollapsed(id, expanded),
        )
      : look.twists
        ? html`<span class="twist"></span>`
        : nothing;
  const paintedOn = (on: boolean): string => (look.primary && mask !== null && on ? "painted-on" : "");
  const target = html`<span
    class=${`target ${paintedOn(!look.editsMask)}`}
    @click=${() => look.editsMask && acts.editMask(id, false)}
    @dblclick=${() => acts.show(id)}
    >${thumbnail(look.thumbnails, layer, expanded)}</span
  >`;
  return html`<div class="name-cell" role="gridcell">
    ${twist}${target}
    ${
      mask === null
        ? nothing
        : html`<button
            class=${`chip ${paintedOn(look.editsMask)}`}
            data-action="mask"
            tabindex="-1"
            aria-pressed=${look.editsMask}
            aria-label=${words.editMask(name)}
            title=${words.editMask(name)}
            @click=${() => acts.editMask(id, true)}
          >
            ${maskPicture(look.thumbnails, layer, mask)}
          </button>`
    }
    ${look.renaming ? nameField(layer, words, acts) : html`<span class="name" dir="auto" title=${name} @dblclick=${() => acts.startRename(id)}>${name}</span>`}
  </div>`;
}

function nameField({ id, name }: DesignLayer, words: Strings["layers"], acts: RowActs): TemplateResult {
  const typed = (event: Event): string => (event.target as HTMLInputElement).value;
  const key = (event: KeyboardEvent): void => {
    if (isComposed(event) || (event.key !== "Enter" && event.key !== "Escape")) return;
    event.preventDefault();
    event.stopPropagation();
    acts.endRename(id, event.key === "Enter" ? typed(event) : null, true);
  };
  const leave = (event: Event): void => acts.endRename(id, typed(event), false);
  return html`<input
    class="name"
    type="text"
    dir="auto"
    maxlength="200"
    aria-label=${words.nameOf(name)}
    .value=${name}
    @keydown=${key}
    @blur=${leave}
  />`;
}

function switches({ layer, lockedAbove }: LayerRow, { words, readonly }: RowLook, acts: RowActs): TemplateResult {
  const { id, name, visible, locked } = layer;
  const lockLabel = locked ? words.unlock(name) : words.lock(name);
  const eyeLabel = visible ? words.hide(name) : words.show(name);
  return html`
    <div class=${`cell ${lockedAbove ? "" : "quiet-until-near"}`} role="gridcell">
      ${iconButton("locked", lockLabel, locked || lockedAbove ? Lock : LockOpen, () => acts.toggleLocked(id), { pressed: locked, disabled: readonly })}
    </div>
    <div class="cell" role="gridcell">
      ${iconButton("visible", eyeLabel, visible ? Eye : EyeOff, () => acts.toggleVisible(id), { disabled: readonly })}
    </div>
  `;
}

/** A row's own buttons are reached by the arrow keys, so that the tab key passes by them. */
function iconButton(
  action: string,
  label: string,
  drawing: IconNode,
  run: () => void,
  { pressed, disabled = false }: { readonly pressed?: boolean; readonly disabled?: boolean } = {},
): TemplateResult {
  const click = (event: MouseEvent): void => {
    event.stopPropagation();
    // The lock comes into sight with the tap that chooses its row, and is not meant by the second of two.
    if (action !== "locked" || event.detail < 2) run();
  };
  return html`<button
    class=${action === "twist" ? "icon twist" : "icon"}
    data-action=${action}
    tabindex="-1"
    aria-pressed=${pressed ?? nothing}
    ?disabled=${disabled}
    aria-label=${label}
    title=${label}
    @click=${click}
  >
    ${icon(drawing)}
  </button>`;
}

function spokenName({ layer, hiddenAbove, lockedAbove }: LayerRow, words: Strings["layers"]): string {
  const kind = layer.type === "fill" && layer.gradient !== null ? "gradient" : layer.type;
  const notes = [
    layer.name,
    words.kinds[kind],
    layer.visible ? "" : words.hiddenNote,
    layer.visible && hiddenAbove ? words.hiddenAboveNote : "",
    layer.locked || lockedAbove ? words.lockedNote : "",
    layer.mask === null ? "" : words.maskedNote,
  ];
  return notes.filter(Boolean).join(", ");
}

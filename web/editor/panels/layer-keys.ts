/** Keys of the layer list's rows (WAI-ARIA treegrid; what is one's own of a file list: F2, Space, Delete). */
import type { EditorState } from "../state/editor-state.ts";
import type { LayerCommands } from "../state/layer-commands.ts";
import type { LayerRow } from "../state/layer-rows.ts";

export interface LayerKeyContext {
  readonly layers: LayerCommands;
  readonly rows: readonly LayerRow[];
  readonly state: EditorState;
  readonly rename: (id: string) => void;
  /** Brings the keyboard to the selected row once it is there. */
  readonly focusSelected: () => void;
  readonly focusRow: (id: string) => void;
  readonly show: (id: string) => void;
}

/** Takes the key where it is one of the list's, so that neither the page nor the browser sees it. */
export function handleLayerKey(event: KeyboardEvent, context: LayerKeyContext): void {
  const target = event.target as HTMLElement;
  if (event.defaultPrevented || target.matches("input, select")) return;
  const element = target.closest<HTMLElement>(".row");
  const row = context.rows.find(({ layer }) => layer.id === element?.dataset.id);
  if (!element || !row) return;
  const handled = target === element ? rowKey(event, row, element, context) : controlKey(event, target, element);
  if (!handled) return;
  event.preventDefault();
  event.stopPropagation();
}

function rowKey(event: KeyboardEvent, row: LayerRow, element: HTMLElement, context: LayerKeyContext): boolean {
  const { layers, rows, state, focusSelected } = context;
  const { id } = row.layer;
  const place = rows.indexOf(row);
  const { selection } = state;
  const own = selection.includes(id) ? selection : [id];
  // What is chosen is what one sees chosen: the keyboard may have been led to another row, or not yet to one that an act has made.
  const chosen = selection.length > 0 ? selection : [id];
  if (state.readonly && changes(event)) return true;
  if (event.altKey) {
    if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return false;
    layers.step(event.key === "ArrowUp" ? 1 : -1, chosen);
    focusSelected();
    return true;
  }
  const command = event.ctrlKey || event.metaKey;
  switch (event.key) {
    case "ArrowUp":
      return goTo(place - 1, event, context);
    case "ArrowDown":
      return goTo(place + 1, event, context);
    case "Home":
      return goTo(0, event, context);
    case "End":
      return goTo(rows.length - 1, event, context);
    case inward(element):
      return open(row, element, context);
    case outward(element):
      return close(row, context);
    case " ":
      if (command) layers.toggleSelected(id);
      else layers.toggleVisible(own);
      return true;
    case "F2":
      context.rename(id);
      return true;
    case "Enter":
      context.show(id);
      return true;
    case "Delete":
    case "Backspace":
      layers.remove(chosen);
      focusSelected();
      return true;
    case "a":
      if (command) layers.selectAll();
      return command;
    default:
      return false;
  }
}

/** Whether a key of the list changes the layers, and not only what of them is looked at. */
function changes({ key, altKey, ctrlKey, metaKey }: KeyboardEvent): boolean {
  if (key === " ") return !ctrlKey && !metaKey;
  return altKey || ["F2", "Delete", "Backspace"].includes(key);
}

function goTo(place: number, event: KeyboardEvent, context: LayerKeyContext): boolean {
  const { layers, rows } = context;
  const goal = rows[Math.max(0, Math.min(rows.length - 1, place))]?.layer.id;
  if (goal === undefined) return true;
  if (event.shiftKey) layers.selectTo(goal);
  else if (event.ctrlKey || event.metaKey) {
    context.focusRow(goal);
    return true;
  } else layers.select(goal);
  context.focusSelected();
  return true;
}

/** Opens a group; of what is open or holds nothing, goes to the row's buttons. */
function open({ layer, expanded }: LayerRow, element: HTMLElement, { layers }: LayerKeyContext): boolean {
  if (layer.type === "group" && !expanded) layers.setCollapsed(layer.id, false);
  else buttonsOf(element)[0]?.focus();
  return true;
}

/** Closes a group; of what is closed or holds nothing, goes to the group that it is in. */
function close({ layer, expanded, parentId }: LayerRow, { layers, focusSelected }: LayerKeyContext): boolean {
  if (expanded) layers.setCollapsed(layer.id, true);
  else if (parentId !== null) {
    layers.select(parentId);
    focusSelected();
  }
  return true;
}

/** On a button of a row: the arrows go to the next one, and back to the row. */
function controlKey(event: KeyboardEvent, target: HTMLElement, element: HTMLElement): boolean {
  const buttons = buttonsOf(element);
  const at = buttons.indexOf(target.closest("button") as HTMLButtonElement);
  if (event.key === inward(element)) buttons[at + 1]?.focus();
  else if (event.key === outward(element)) (buttons[at - 1] ?? element).focus();
  else if (event.key === "Escape") element.focus();
  else return false;
  return true;
}

/** What opens a group is the arrow's own act. */
function buttonsOf(element: HTMLElement): HTMLButtonElement[] {
  return [...element.querySelectorAll<HTMLButtonElement>("button:not(.twist)")];
}

const isRightToLeft = (element: HTMLElement): boolean => getComputedStyle(element).direction === "rtl";
const inward = (element: HTMLElement): string => (isRightToLeft(element) ? "ArrowLeft" : "ArrowRight");
const outward = (element: HTMLElement): string => (isRightToLeft(element) ? "ArrowRight" : "ArrowLeft");

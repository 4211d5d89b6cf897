/** What a user does to layers of any kind, each a step of the history. Acts are for all chosen layers. */

import type { ModelViewer } from "../../viewer/viewer-api.ts";
import {
  type DecalLayer,
  type Design,
  type DesignLayer,
  type FillLayer,
  type GroupLayer,
  isPlaced,
  layersAt,
  type PaintLayer,
  type StrokeLayer,
  type TextLayer,
} from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import type { Admission } from "./admission.ts";
import { carriedMask, maskGoesAlong } from "./carried-mask.ts";
import { clearPlaces } from "./clear-place.ts";
import { layerById, patchLayers, placedCount } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import { diagonalOf } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import { fitToModel, putClip } from "./layer-clip.ts";
import {
  addMask,
  copyBelow,
  duplicateLayers,
  groupLayers,
  insertAbove,
  invertMask,
  linkMask,
  moveLayers,
  outermost,
  removeLayers,
  removeMask,
  stepLayers,
  type TreePlace,
} from "./layer-edits.ts";
import { mergeDown } from "./layer-merge.ts";
import { layerRows, rowsBetween } from "./layer-rows.ts";
import { ungroupLayers } from "./layer-ungroup.ts";
import { type MaskStart, withMaskStart } from "./mask-edits.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";

type Fields<L extends DesignLayer> = Omit<L, "id" | "type">;

/** Fields of whichever layer it is for. */
export type LayerPatch = Partial<
  Fields<DecalLayer> &
    Fields<TextLayer> &
    Fields<StrokeLayer> &
    Fields<FillLayer> &
    Fields<GroupLayer> &
    Fields<PaintLayer>
>;

/** A locked layer may still be renamed, shown, hidden and unlocked. */
const FREE_FIELDS: readonly (keyof LayerPatch)[] = ["locked", "visible", "name"];

export interface LayerCommandsParts {
  readonly session: DesignSession;
  readonly viewer: Pick<ModelViewer, "nudge" | "surface">;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly admission?: Admission | null;
  /** Records what a tool has under way: it would go with the layers that it belongs to. */
  readonly finishWork?: () => void;
}

export class LayerCommands {
  readonly #session: DesignSession;
  readonly #store: Store<EditorState>;
  readonly #board: NoticeBoard;
  readonly #admission: Admission | null;
  readonly #viewer: Pick<ModelViewer, "nudge" | "surface">;
  readonly #finishWork: () => void;
  /** Where a choice of several began. */
  #anchor: string | null = null;

  constructor({ session, viewer, store, board, admission = null, finishWork = () => {} }: LayerCommandsParts) {
    this.#finishWork = finishWork;
    this.#admission = admission;
    this.#session = session;
    this.#viewer = viewer;
    this.#store = store;
    this.#board = board;
  }

  select(id: string | null): void {
    this.#anchor = id;
    const { selectedId, selection } = this.#store.state;
    if (id === selectedId && selection.length === (id === null ? 0 : 1)) return;
    this.#session.select(id);
    const layer = layerById(this.#session.design, id);
    this.#board.announce(
      layer ? this.#board.strings.announce.selected(layer.name) : this.#board.strings.announce.nothingSelected,
    );
  }

  /** Takes a layer into the choice, or out of it. */
  toggleSelected(id: string): void {
    const { selection } = this.#store.state;
    this.#anchor = id;
    if (selection.includes(id)) this.#choose(selection.filter((each) => each !== id));
    else this.#choose([id, ...selection]);
  }

  /** Chooses all rows from where the choice began to that layer. */
  selectTo(id: string): void {
    const { design, collapsed, selectedId } = this.#store.state;
    this.#anchor ??= selectedId;
    const rows = rowsBetween(layerRows(design, collapsed), this.#anchor ?? id, id);
    this.#choose([id, ...rows]);
  }

  selectAll(): void {
    const { design, selectedId } = this.#store.state;
    const ids = design.layers.map(({ id }) => id).reverse();
    this.#choose([...(selectedId !== null && ids.includes(selectedId) ? [selectedId] : []), ...ids]);
  }

  /** Bottom to top; a choice of several goes on from the topmost. */
  #chooseMade(ids: readonly string[]): void {
    this.#anchor = ids.at(-1) ?? null;
    this.#choose(ids.toReversed());
  }

  #choose(ids: readonly string[]): void {
    this.#session.select(ids[0] ?? null, ids.slice(1));
    this.#board.announce(this.#board.strings.announce.chosen(this.#store.state.selection.length));
  }

  /** Shows a change that is still going on (the scrub of a field). Locked layers stay as they are. */
  preview(ids: string | readonly string[], patch: LayerPatch): void {
    const design = this.#session.recordedDesign;
    const free = listed(ids).filter((id) => !isLocked(design, id));
    this.#session.preview(patched(design, free, patch));
  }

  /** False where none was shown. */
  cancelPreview(): boolean {
    return this.#session.cancelPreview();
  }

  change(ids: string | readonly string[], patch: LayerPatch, label: string, mergeKey?: string): void {
    const isFree = (Object.keys(patch) as (keyof LayerPatch)[]).every((field) => FREE_FIELDS.includes(field));
    const free = isFree ? listed(ids) : this.unlocked(listed(ids));
    this.#session.record(patched(this.#session.recordedDesign, free, patch), label, mergeKey);
  }

  /** Gives all chosen layers an opacity. False where none is chosen. */
  fade(opacity: number): boolean {
    const { selection } = this.#store.state;
    const { steps, properties } = this.#board.strings;
    if (selection.length === 0) return false;
    this.change(selection, { opacity }, steps.change(properties.opacity), `fade:${selection}`);
    return true;
  }

  /** Of those layers the ones that may be changed; says which may not. */
  unlocked(ids: readonly string[]): string[] {
    const design = this.#session.recordedDesign;
    const locked = ids.find((id) => isLocked(design, id));
    if (locked === undefined) return [...ids];
    const free = ids.filter((id) => !isLocked(design, id));
    const name = layerById(design, locked)?.name ?? "";
    this.#board.info({
      title: this.#board.strings.notices.locked(name),
      message: this.#board.strings.notices.lockedHint,
    });
    return free;
  }

  duplicate(): void {
    this.#finishWork();
    const ids = this.#store.state.selection;
    const before = this.#session.recordedDesign;
    const made = this.#attempt(() => {
      const originals = outermost(before, ids).map(({ layer }) => layer);
      const copied = duplicateLayers(before, ids, this.#apart(originals));
      this.#admission?.checkRoom(placedCount(copied.design) - placedCount(before));
      return copied;
    });
    if (!made || made.ids.length === 0) return;
    const { design, ids: copies } = made;
    const said = this.#said(ids, this.#board.strings.announce.duplicated, this.#board.strings.announce.duplicatedMany);
    this.#session.record(design, this.#board.strings.steps.duplicate(copies.length));
    this.#chooseMade(copies);
    this.#board.announce(said);
  }

  /**
   * The recorded design with a copy of a layer right below it, which has its name: whoever goes on with the layer itself takes
   * the copy away. Null where there is no room for one, which is said.
   */
  withCopyBelow(id: string): Design | null {
    return (
      this.#attempt(() => {
        const design = copyBelow(this.#session.recordedDesign, id);
        this.#admission?.checkRoom(1);
        return design;
      }) ?? null
    );
  }

  /**
   * Copied decals are seen beside their originals. Not where one of them has something on its mask that does not go along: away
   * from there the copy would show what is hidden of the original, or nothing.
   */
  #apart(originals: readonly DesignLayer[]): (layer: DesignLayer) => Partial<DecalLayer> {
    const stays = (layer: DesignLayer): boolean =>
      layer.mask !== null && layer.mask.layers.length > 0 && !(isPlaced(layer) && maskGoesAlong(layer.mask, [layer]));
    if (originals.some(stays)) return () => ({});
    const diagonal = diagonalOf(this.#store.state.model);
    const placed = originals.flatMap((layer) => (isPlaced(layer) ? [layer.projector] : []));
    const cleared = clearPlaces(this.#session.recordedDesign, placed, diagonal, this.#viewer);
    return (layer) => {
      if (!isPlaced(layer)) return {};
      const projector = cleared(layer.projector);
      return { projector, mask: carriedMask(layer, projector, this.#viewer.surface) };
    };
  }

  /** The neighbour is selected next, so that the keyboard can go on. `step` names the step of the history. */
  remove(ids = this.#store.state.selection, step = this.#board.strings.steps.remove): void {
    this.#finishWork();
    const before = this.#session.recordedDesign;
    const gone = this.unlocked(ids);
    const design = removeLayers(before, gone);
    if (design === before) return;
    const rows = layerRows(before, this.#store.state.collapsed).map(({ layer }) => layer.id);
    const said = this.#said(gone, this.#board.strings.announce.removed, this.#board.strings.announce.removedMany);
    const places = gone.map((id) => rows.indexOf(id));
    const around = [...rows.slice(0, Math.max(...places)).reverse(), ...rows.slice(Math.max(...places) + 1)];
    this.#session.record(design, step(gone.length));
    this.select(around.find((id) => layerById(design, id)) ?? null);
    this.#board.announce(said);
  }

  /** To a place in the tree that may be inside another group; `moveLayers` says how it counts. */
  move(ids: readonly string[], place: TreePlace): void {
    this.#rearrange(ids, (design) => moveLayers(design, ids, place));
  }

  /** One row up (1) or down (-1), into and out of groups. */
  step(direction: 1 | -1, ids = this.#store.state.selection): void {
    this.#rearrange(ids, (design) => stepLayers(design, ids, direction, this.#store.state.collapsed));
  }

  /** On top (1) or at the bottom (-1) of the layers that it lies with. */
  toEnd(direction: 1 | -1): void {
    const ids = this.#store.state.selection;
    const design = this.#session.recordedDesign;
    const top = outermost(design, ids).at(-1);
    if (!top) return;
    const count = layersAt(design, top)?.length ?? 0;
    this.move(ids, { parentId: top.parentId, index: direction > 0 ? count : 0 });
  }

  #rearrange(ids: readonly string[], edit: (design: Design) => Design): void {
    const before = this.#session.recordedDesign;
    const design = this.#attempt(() => edit(before));
    if (!design || design === before) return;
    this.#session.record(design, this.#board.strings.steps.reorder);
    const row = layerRows(design, new Set()).find(({ layer }) => layer.id === ids[0]);
    if (!row) return;
    const { layer, place, count, parentId } = row;
    const group = layerById(design, parentId)?.name;
    this.#board.announce(this.#board.strings.announce.moved(layer.name, place, count, group));
  }

  /** Puts the chosen layers into a new group. */
  group(): void {
    this.#finishWork();
    const { selection } = this.#store.state;
    const made = this.#attempt(() =>
      groupLayers(this.#session.recordedDesign, selection, { name: this.#board.strings.layers.group }),
    );
    if (!made) return;
    this.#session.record(made.design, this.#board.strings.steps.group);
    this.select(made.id);
    this.#board.announce(this.#board.strings.announce.grouped(layerById(made.design, made.id)?.name ?? ""));
  }

  /** Where the picture would change by it, says how and asks first. */
  ungroup(ids = this.#store.state.selection, anyway = false): void {
    this.#finishWork();
    const before = this.#session.recordedDesign;
    const groups = this.unlocked(ids).filter((id) => layerById(before, id)?.type === "group");
    const { design, ids: freed, lost } = ungroupLayers(before, groups);
    if (design === before) return;
    if (lost.size > 0 && !anyway) {
      const { ungroupChanges, ungroupLoses, ungroupAnyway } = this.#board.strings.notices;
      const action = { label: ungroupAnyway, run: () => this.ungroup(groups, true) };
      this.#board.info({ title: ungroupChanges, message: ungroupLoses([...lost]), action });
      return;
    }
    this.#session.record(design, this.#board.strings.steps.ungroup);
    this.#chooseMade(freed);
    this.#board.announce(this.#board.strings.announce.ungrouped(freed.length));
  }

  /** Joins a layer with the one below it; several chosen layers become a group. */
  merge(): void {
    this.#finishWork();
    const ids = this.#store.state.selection;
    const [id] = ids;
    if (id === undefined) return;
    if (ids.length > 1) {
      this.group();
      return;
    }
    if (this.unlocked([id]).length === 0) return;
    const merge = this.#attempt(() => mergeDown(this.#session.recordedDesign, id, this.#board.strings.layers.group));
    if (!merge) return;
    this.#session.record(merge.design, this.#board.strings.steps.merge);
    this.select(merge.id);
    if (merge.obstacle === null) this.#board.announce(this.#board.strings.announce.merged);
    else
      this.#board.info({
        title: this.#board.strings.notices.grouped,
        message: this.#board.strings.notices.mergeObstacles[merge.obstacle],
      });
  }

  /** A new layer above the selected one, and inside a group where that is what is selected. */
  add(make: (id: string) => DesignLayer, label: string): void {
    const { selectedId } = this.#store.state;
    const before = this.#session.recordedDesign;
    const made = this.#attempt(() => insertAbove(before, selectedId, make));
    if (!made) return;
    this.#session.record(made.design, label);
    this.select(made.id);
    this.#board.announce(this.#board.strings.announce.added(layerById(made.design, made.id)?.name ?? ""));
  }

  /** The layers of a clip, above the selected one; they are chosen then. */
  put(clip: Design): void {
    const { selectedId, model, material } = this.#store.state;
    const materials = new Set(model?.info.materials.map(({ index }) => index));
    const apart = this.#apart(clip.layers);
    const fit = (layer: DesignLayer): DesignLayer =>
      ({ ...fitToModel(layer, materials, material ?? 0), ...apart(layer) }) as DesignLayer;
    const made = this.#attempt(() => putClip(this.#session.recordedDesign, clip, selectedId, fit));
    if (!made) return;
    this.#session.record(made.design, this.#board.strings.steps.paste(made.ids.length));
    this.#chooseMade(made.ids);
    this.#board.announce(this.#board.strings.announce.pasted(made.ids.length));
  }

  /** Gives the selected layer a mask, which the brush paints on from then on. */
  addMask(hideAll: boolean): void {
    const { selectedId } = this.#store.state;
    const id = this.#editMask((design, layer) => addMask(design, layer, hideAll), this.#board.strings.steps.addMask);
    if (id !== undefined && id === selectedId) this.editMask(id, true);
  }

  /** Lets the selected layer's mask begin otherwise, below what is painted on it; one that has none gets a mask, which is marked. */
  startMask(start: MaskStart, step = this.#board.strings.steps.startMask): void {
    const { selectedId, editingMask } = this.#store.state;
    const id = this.#editMask((design, layer) => withMaskStart(design, layer, start), step);
    if (id !== undefined && id === selectedId && id !== editingMask) this.editMask(id, true);
  }

  removeMask(): void {
    this.#editMask(removeMask, this.#board.strings.steps.removeMask);
  }

  invertMask(): void {
    this.#editMask(invertMask, this.#board.strings.steps.invertMask);
  }

  /** Whether the selected layer's mask goes along when the layer is moved. */
  linkMask(linked: boolean): void {
    const { steps, announce } = this.#board.strings;
    const id = this.#editMask(
      (design, layer) => linkMask(design, layer, linked),
      linked ? steps.linkMask : steps.unlinkMask,
    );
    if (id !== undefined) this.#board.announce(linked ? announce.maskLinked : announce.maskUnlinked);
  }

  #editMask(edit: (design: Design, id: string) => Design, label: string): string | undefined {
    const { selectedId } = this.#store.state;
    const [id] = selectedId === null ? [] : this.unlocked([selectedId]);
    const design = id === undefined ? undefined : this.#attempt(() => edit(this.#session.recordedDesign, id));
    if (design) this.#session.record(design, label);
    return id;
  }

  /** Selects a layer, and says whether the brush paints on its mask or on the layer itself. */
  editMask(id: string, on: boolean): void {
    const layer = layerById(this.#session.design, id);
    if (!layer || (on && layer.mask === null)) return;
    this.select(id);
    this.#store.set({ editingMask: on ? id : null });
    const { editingMask, editingLayer } = this.#board.strings.announce;
    this.#board.announce(on ? editingMask(layer.name) : editingLayer(layer.name));
  }

  toggleVisible(ids: readonly string[] = this.#store.state.selection): void {
    this.#toggle("visible", ids, [this.#board.strings.steps.show, this.#board.strings.steps.hide]);
    const said = this.#isOn("visible", ids) ? this.#board.strings.announce.shown : this.#board.strings.announce.hidden;
    this.#board.announce(this.#said(ids, said, this.#board.strings.announce.changedMany));
  }

  toggleLocked(ids: readonly string[] = this.#store.state.selection): void {
    this.#toggle("locked", ids, [this.#board.strings.steps.lock, this.#board.strings.steps.unlock]);
    const said = this.#isOn("locked", ids)
      ? this.#board.strings.announce.locked
      : this.#board.strings.announce.unlocked;
    this.#board.announce(this.#said(ids, said, this.#board.strings.announce.changedMany));
  }

  rename(id: string, name: string): void {
    const trimmed = name.trim();
    if (trimmed) this.change(id, { name: trimmed }, this.#board.strings.steps.rename);
  }

  setCollapsed(id: string, closed: boolean): void {
    const collapsed = new Set(this.#store.state.collapsed);
    if (closed) collapsed.add(id);
    else collapsed.delete(id);
    this.#store.set({ collapsed });
  }

  /** All take the opposite of what the first has. */
  #toggle(field: "visible" | "locked", ids: readonly string[], [on, off]: readonly [string, string]): void {
    const next = !this.#isOn(field, ids);
    this.change(ids, { [field]: next }, next ? on : off);
  }

  #isOn(field: "visible" | "locked", [first]: readonly string[]): boolean {
    return layerById(this.#session.recordedDesign, first ?? null)?.[field] ?? false;
  }

  #said(ids: readonly string[], one: (name: string) => string, many: (count: number) => string): string {
    const [first] = ids;
    return ids.length === 1
      ? one(layerById(this.#session.recordedDesign, first ?? null)?.name ?? "")
      : many(ids.length);
  }

  /** What cannot be done is said, and nothing is changed. */
  #attempt<T>(edit: () => T): T | undefined {
    try {
      return edit();
    } catch (thrown) {
      this.#board.error(this.#board.strings.errors.couldNotArrange, thrown);
      return undefined;
    }
  }
}

const listed = (ids: string | readonly string[]): readonly string[] => (typeof ids === "string" ? [ids] : ids);

const patched = (design: Design, ids: readonly string[], patch: LayerPatch): Design =>
  patchLayers(design, ids, patch as Partial<DesignLayer>);

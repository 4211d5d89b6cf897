/** What a user does to decals, each a step of the history. */
import type { PlanarProjector, Projector, Vec3 } from "../../engine/engine-api.ts";
import type { DecalGesture, ModelViewer, SurfaceHit } from "../../viewer/viewer-api.ts";
import { type DecalLayer, materialsOf } from "../document/index.ts";
import { strings } from "../strings.ts";
import type { LibraryPicture } from "./asset-library.ts";
import { DecalReach } from "./decal-reach.ts";
import { addDecal, duplicateLayer, layerById, moveLayer, patchLayer, removeLayer, withAsset } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import type { EditorState } from "./editor-state.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { scaledProjector, spunProjector } from "./projector-steps.ts";
import type { Store } from "./store.ts";

export type DecalPatch = Partial<Omit<DecalLayer, "id" | "type">>;

/** Of the model's diagonal: a new decal's longer side, a nudge, the step of a copy away from its original. */
const NEW_SHARE = 0.22;
const NUDGE_SHARE = 0.002;
const COPY_SHARE = 0.04;
const COARSE = 10;

export class DecalCommands {
  readonly #session: DesignSession;
  readonly #viewer: ModelViewer;
  readonly #store: Store<EditorState>;
  readonly #board: NoticeBoard;
  readonly #reach: DecalReach;

  constructor(session: DesignSession, viewer: ModelViewer, store: Store<EditorState>, board: NoticeBoard) {
    this.#session = session;
    this.#viewer = viewer;
    this.#store = store;
    this.#board = board;
    this.#reach = new DecalReach(viewer, () => store.state.model?.info.materials ?? []);
    viewer.on("gesture", (gesture) => this.#follow(gesture));
    viewer.on("select", ({ id }) => this.select(id));
  }

  get selected(): DecalLayer | undefined {
    const { selected } = this.#session;
    return selected?.type === "decal" ? selected : undefined;
  }

  select(id: string | null): void {
    if (id === this.#store.state.selectedId) return;
    this.#session.select(id);
    const layer = layerById(this.#session.design, id);
    this.#board.announce(layer ? strings.announce.selected(layer.name) : strings.announce.nothingSelected);
  }

  /** Puts a picture on the model: at `hit`, else in the middle of the view, else in front of the model. */
  add(name: string, picture: LibraryPicture, hit: SurfaceHit | null): void {
    // Decals have their places on the model at rest.
    this.#viewer.setAnimationPlaying(false);
    const place = hit ?? this.#viewer.surfaceAtCentre();
    const aspect = picture.width / picture.height;
    const width = NEW_SHARE * this.#diagonal() * Math.min(1, aspect);
    const projector = place ? this.#viewer.projectorAt(place, width, aspect) : this.#inFront(width, aspect);
    const material = this.#reach.at(projector, false, place?.material ?? this.#store.state.material ?? 0);
    const { design: withPicture, key } = withAsset(this.#session.recordedDesign, name, picture.asset);
    const { design, id } = addDecal(withPicture, { name, material, asset: key, projector });
    this.#session.record(design, strings.steps.add);
    this.#session.select(id);
    this.#board.announce(strings.announce.added(name));
  }

  /** Shows a change that is still going on (the scrub of a field). */
  preview(id: string, patch: DecalPatch): void {
    this.#session.preview(patchLayer<DecalLayer>(this.#session.recordedDesign, id, patch));
  }

  cancelPreview(): void {
    this.#session.cancelPreview();
  }

  change(id: string, patch: DecalPatch, label: string, mergeKey?: string): void {
    this.#session.record(patchLayer<DecalLayer>(this.#session.recordedDesign, id, patch), label, mergeKey);
  }

  duplicate(id = this.#store.state.selectedId): void {
    const layer = layerById(this.#session.recordedDesign, id);
    if (!layer) return;
    const step = COPY_SHARE * this.#diagonal();
    const patch = layer.type === "decal" ? { projector: this.#viewer.nudge(layer.projector, step, -step) } : {};
    const copy = duplicateLayer<DecalLayer>(this.#session.recordedDesign, layer.id, patch);
    if (!copy) return;
    this.#session.record(copy.design, strings.steps.duplicate);
    this.#session.select(copy.id);
    this.#board.announce(strings.announce.duplicated(layer.name));
  }

  /** The neighbour is selected next, so that the keyboard can go on. */
  remove(id = this.#store.state.selectedId): void {
    const { layers } = this.#session.recordedDesign;
    const index = layers.findIndex((layer) => layer.id === id);
    const layer = layers[index];
    if (!layer) return;
    this.#session.record(removeLayer(this.#session.recordedDesign, layer.id), strings.steps.remove);
    this.#session.select((layers[index + 1] ?? layers[index - 1])?.id ?? null);
    this.#board.announce(strings.announce.removed(layer.name));
  }

  /** `to` counts from the bottom. */
  move(id: string, to: number): void {
    const design = moveLayer(this.#session.recordedDesign, id, to);
    if (design === this.#session.recordedDesign) return;
    this.#session.record(design, strings.steps.reorder);
    const index = design.layers.findIndex((layer) => layer.id === id);
    const name = design.layers[index]?.name ?? "";
    this.#board.announce(strings.announce.moved(name, design.layers.length - index, design.layers.length));
  }

  toggleVisible(id: string): void {
    const layer = layerById(this.#session.recordedDesign, id);
    if (!layer) return;
    this.change(id, { visible: !layer.visible }, layer.visible ? strings.steps.hide : strings.steps.show);
    this.#board.announce(layer.visible ? strings.announce.hidden(layer.name) : strings.announce.shown(layer.name));
  }

  rename(id: string, name: string): void {
    const trimmed = name.trim();
    if (trimmed) this.change(id, { name: trimmed }, strings.steps.rename);
  }

  /** Slides the selected decal along the surface by steps of the view: +1 right, +1 up. False without a selection. */
  nudge(right: number, up: number, coarse: boolean): boolean {
    return this.#step("nudge", strings.steps.move, (projector) => {
      const step = NUDGE_SHARE * this.#diagonal() * (coarse ? COARSE : 1);
      return this.#viewer.nudge(projector, right * step, up * step);
    });
  }

  /** Turns the selected decal by `steps` degrees. */
  spin(steps: number, coarse: boolean): boolean {
    return this.#step("spin", strings.steps.rotate, (projector) =>
      spunProjector(projector, steps * (coarse ? COARSE : 1)),
    );
  }

  /** Scales the selected decal by `steps` percent. */
  scale(steps: number, coarse: boolean): boolean {
    const factor = 1 + (steps * (coarse ? COARSE : 1)) / 100;
    return this.#step("scale", strings.steps.scale, (projector) => scaledProjector(projector, factor));
  }

  /** Gives a decal all materials that it meets where it lies. */
  paintAllMet(layer: DecalLayer): void {
    const material = this.#reach.at(layer.projector, layer.backfaces, materialsOf(layer)[0] ?? 0);
    this.change(layer.id, { material }, strings.steps.change(strings.properties.material));
  }

  #step(kind: string, label: string, change: (projector: Projector) => Projector): boolean {
    const layer = this.selected;
    if (!layer) return false;
    const projector = change(layer.projector);
    const patch = { projector, material: this.#reach.movedTo(layer, projector, null) };
    this.change(layer.id, patch, label, `${kind}:${layer.id}`);
    return true;
  }

  #follow({ id, kind, phase, projector, material: onto }: DecalGesture): void {
    if (phase === "start") this.select(id);
    else if (phase === "cancel") this.#session.cancelPreview();
    else {
      const layer = layerById(this.#session.recordedDesign, id);
      if (layer?.type !== "decal") return;
      const patch = { projector, material: this.#reach.movedTo(layer, projector, onto) };
      if (phase === "move") this.preview(id, patch);
      else this.change(id, patch, strings.steps[kind]);
    }
  }

  #diagonal(): number {
    const { model } = this.#store.state;
    if (!model) return 1;
    const { boundsMin: low, boundsMax: high } = model.info;
    return Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) || 1;
  }

  #inFront(width: number, aspect: number): PlanarProjector {
    const { boundsMin: low, boundsMax: high } = this.#store.state.model?.info ?? {
      boundsMin: [0, 0, 0],
      boundsMax: [0, 0, 0],
    };
    const position: Vec3 = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]];
    return { kind: "planar", position, rotation: [0, 0, 0, 1], size: [width, width / aspect, width] };
  }
}

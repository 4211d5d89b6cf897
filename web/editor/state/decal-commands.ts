/** What a user does to decals, each a step of the history. */
import type { PlanarProjector, Projector, Vec3 } from "../../engine/engine-api.ts";
import { sameItems } from "../../engine/same-items.ts";
import type { DecalGesture, ModelViewer, SurfaceHit, ViewerDecal } from "../../viewer/viewer-api.ts";
import {
  type DecalLayer,
  type Design,
  freeIdIn,
  isPlaced,
  type LayerMaterials,
  makeDecalLayer,
  materialsOf,
  type PlacedLayer,
  visitOf,
} from "../document/index.ts";
import { isLocked, type LayerVisit, walkLayers } from "../document/layer-tree.ts";
import { middlesOf } from "../tools/model-middles.ts";
import { isPixelated } from "../tools/pixel-mode.ts";
import { alignedTogether, type LineOfLayers } from "./aligned-together.ts";
import type { LibraryPicture } from "./asset-library.ts";
import type { BareParts } from "./bare-parts.ts";
import { carriedGroupMask, carriedMask } from "./carried-mask.ts";
import { carriedProjector, changedAlike, type Foot, footOf, type NearSurface } from "./carried-projector.ts";
import { ChosenTogether, TOGETHER } from "./chosen-together.ts";
import { clearPlaces } from "./clear-place.ts";
import { DecalReach } from "./decal-reach.ts";
import { addOnTop, layerById, patchEach, patchLayer, withAsset, withoutUnusedAssets } from "./design-edits.ts";
import type { DesignSession } from "./design-session.ts";
import { diagonalOf } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import { hasFittingLengths } from "./fitting-lengths.ts";
import type { LayerCommands } from "./layer-commands.ts";
import { LeftMasks } from "./left-masks.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { fittedPicture } from "./other-picture.ts";
import { scaledProjector, spunProjector } from "./projector-steps.ts";
import { type MaskSurface, rememberedSurface } from "./remembered-surface.ts";
import { ownsNoTexel } from "./shared-place.ts";
import { type SpreadOfLayers, spreadTogether } from "./spread-together.ts";
import { type StepKind, StepReport } from "./step-report.ts";
import type { Store } from "./store.ts";
import type { Dragged } from "./surroundings.ts";
import { type Placement, TriedKinds } from "./tried-kinds.ts";
import { sharesTexels } from "./unwrap-command.ts";
import { type WholeGroup, wholeGroups } from "./whole-groups.ts";

/** Of the model's diagonal: a new decal's longer side where there is room for it, a nudge. */
const NEW_SHARE = 0.22;
const NUDGE_SHARE = 0.002;
const COARSE = 10;
/** A normal takes a quarter of a millisecond, at each move. */
const MOST_AVERAGED = 24;

/** What a layer takes on where it is put. */
type LayerMove = Pick<PlacedLayer, "projector" | "material" | "mask">;

/** Where something new goes, and the surface that it was laid on; null in front of the model. */
export interface NewPlace {
  readonly projector: PlanarProjector;
  readonly spot: SurfaceHit | null;
}

/** A layer that goes along, and where it stands when the drag begins: what is searched for once is not searched for at each move. */
interface Carried {
  readonly layer: PlacedLayer;
  readonly foot: Foot | null;
}

/** A step that moves several in view of the one that leads them. */
interface MoveTogether {
  /** Of those layers, the same objects of those that stay. */
  readonly projectors: (layers: readonly PlacedLayer[], first: PlacedLayer) => readonly Projector[];
  readonly step: string;
  readonly told: (name: string) => string;
  /** Told where none moves. */
  readonly nothing: (name: string) => string;
}

/** What is chosen in a design. */
interface Found {
  readonly of: readonly unknown[];
  readonly chosen: readonly LayerVisit<PlacedLayer>[];
  readonly groups: readonly WholeGroup[];
  /** As it is while they are moved. */
  readonly surface: MaskSurface;
}

export interface DecalCommandsParts {
  readonly session: DesignSession;
  readonly viewer: ModelViewer;
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly layers: LayerCommands;
  readonly bare: BareParts;
}

export class DecalCommands {
  readonly #session: DesignSession;
  readonly #viewer: ModelViewer;
  readonly #store: Store<EditorState>;
  readonly #board: NoticeBoard;
  readonly #layers: LayerCommands;
  readonly #bare: BareParts;
  readonly reach: DecalReach;
  readonly #tried = new TriedKinds();
  readonly #report: StepReport;
  readonly #left = new LeftMasks();
  /** Whether a decal that is dragged from here on leaves a copy of itself where it lay, as it does in other editors. */
  #copiesDragged = false;
  /** Whether a click adds to what is chosen, or takes out of it. */
  #addsClicked = false;
  /** What a press on one of several chosen decals does if no drag comes of it. */
  #onRelease: (() => void) | null = null;
  /** The recorded design, with that copy in it, while such a drag goes on. */
  #copied: Design | null = null;
  /** The other chosen ones, which go along while one of them is dragged; null while one alone is. */
  #carried: readonly Carried[] | null = null;
  readonly #together: ChosenTogether;
  #found: Found | null = null;

  constructor({ session, viewer, store, board, layers, bare }: DecalCommandsParts) {
    this.#session = session;
    this.#viewer = viewer;
    this.#store = store;
    this.#board = board;
    this.#layers = layers;
    this.#bare = bare;
    this.#report = new StepReport(board, store, () => this.selected);
    this.#together = new ChosenTogether(viewer, () => store.state);
    this.reach = new DecalReach(viewer, () => store.state.model?.info.materials ?? []);
    viewer.on("gesture", (gesture) => this.followGesture(gesture));
    viewer.on("select", ({ id }) => this.#clicked(id));
  }

  /** A pointer goes down: before a view hears of it, for what is held with it decides what a drag or a click means. */
  press({ altKey, shiftKey }: Pick<PointerEvent, "altKey" | "shiftKey">): void {
    this.#copiesDragged = altKey;
    this.#addsClicked = shiftKey;
    this.#onRelease = null;
  }

  /** It goes up, and no view has taken it for a drag. */
  release(): void {
    this.#onRelease?.();
    this.#onRelease = null;
  }

  /** Several are dragged by any of them: what is chosen stays so until it is clear that a press is no drag. */
  #clicked(id: string | null): void {
    const adds = this.#addsClicked;
    if (adds && id === null) return;
    const act = (): void => (adds && id !== null ? this.#layers.toggleSelected(id) : this.#layers.select(id));
    if (this.#isChosen(id)) this.#onRelease = act;
    else act();
  }

  /** Whether a decal is one of several that are chosen, or in a chosen group. */
  #isChosen(id: string | null): boolean {
    const { selectedId, selection } = this.#store.state;
    return (id !== selectedId || selection.length > 1) && this.chosen.some(({ layer }) => layer.id === id);
  }

  get selected(): PlacedLayer | undefined {
    const { selected } = this.#session;
    return isPlaced(selected) ? selected : undefined;
  }

  /** All chosen pictures and words, also those in chosen groups, from the bottom to the top. */
  get chosen(): readonly LayerVisit<PlacedLayer>[] {
    return this.#find().chosen;
  }

  #find(): Found {
    const { recordedDesign: design } = this.#session;
    const { selection, model, shown } = this.#store.state;
    const present: unknown[] = [design, selection, model, shown];
    // A drag asks at each of its moves, and may be one of a thousand.
    if (!this.#found || !sameItems(this.#found.of, present)) {
      this.#found = {
        of: present,
        chosen: chosenIn(design, selection),
        groups: wholeGroups(design, selection),
        surface: rememberedSurface(this.#viewer.surface),
      };
    }
    return this.#found;
  }

  /** Of those the ones that are not locked. */
  get movable(): readonly PlacedLayer[] {
    return this.chosen.filter(({ locked }) => !locked).map(({ layer }) => layer);
  }

  /** Shows decals with handles at what is chosen: the one, or the box round several. */
  show(decals: readonly ViewerDecal[], selectedId: string | null): void {
    const several = this.#store.state.selection.length > 1 || this.#session.selected?.type === "group";
    if (several) this.#together.show(decals, selectedId, this.movable);
    else this.#viewer.setDecals(decals, selectedId);
  }

  /** Whether keys move chosen decals though none of them has handles, as those of a group. */
  get moveUnheld(): boolean {
    const { movable } = this;
    return movable.length > 0 && !movable.some(({ id }) => id === this.#store.state.selectedId);
  }

  /**
   * Puts a picture on the model: at `hit`, else where it lies best near the middle of the view, beside what lies there already,
   * else in front of the model.
   *
   * @param apart beside what lies there already, also at `hit`, as for one of several
   */
  add(name: string, picture: LibraryPicture, hit: SurfaceHit | null, apart = false): void {
    const { add } = this.#board.strings.steps;
    this.addLayer(this.placeFor(picture.width / picture.height, hit, apart), add, (id, projector, material) => {
      const { design, key } = withAsset(this.#session.recordedDesign, name, picture.asset);
      const { state } = this.#store;
      const filter = isPixelated(state, hit?.material ?? state.material) ? "nearest" : "linear";
      return { design, layer: makeDecalLayer({ id, name, material, asset: key, projector, filter }) };
    });
    this.#board.announce(this.#board.strings.announce.added(name));
  }

  /** Gives a decal another picture, in the place of its own. */
  replacePicture(id: string, name: string, picture: LibraryPicture, before: LibraryPicture | undefined): void {
    const { steps, announce } = this.#board.strings;
    const { recordedDesign } = this.#session;
    const layer = layerById(recordedDesign, id);
    if (layer?.type !== "decal" || isLocked(recordedDesign, id)) return;
    const { design, key } = withAsset(recordedDesign, name, picture.asset);
    const ratio = before ? (picture.width / picture.height) * (before.height / before.width) : 1;
    const box = ratio === 1 ? {} : this.laid(layer, { projector: fittedPicture(layer.projector, ratio) });
    const changed = patchLayer<DecalLayer>(design, id, { asset: key, ...box });
    this.#session.record(withoutUnusedAssets(changed), steps.replacePicture);
    this.#board.announce(announce.pictureReplaced(layer.name));
  }

  /** Where a new layer of that aspect (width by height) goes, as `add` says. */
  placeFor(aspect: number, hit: SurfaceHit | null, apart = false): NewPlace {
    const usual = NEW_SHARE * this.#diagonal() * Math.min(1, aspect);
    const landing = hit === null ? this.#viewer.landing(usual, aspect) : null;
    const spot = hit ?? landing?.hit ?? this.#viewer.surfaceAtCentre();
    const width = landing?.width ?? usual;
    const wished = spot ? this.#viewer.projectorAt(spot, width, aspect) : this.#inFront(width, aspect);
    if (hit !== null && !apart) return { projector: wished, spot };
    const clear = clearPlaces(this.#session.recordedDesign, [wished], this.#diagonal(), this.#viewer);
    return { projector: clear(wished), spot };
  }

  /** Puts a layer on the model. `make` gives it, and the design that it comes into, which has its assets. */
  addLayer(
    { projector, spot }: NewPlace,
    label: string,
    make: (id: string, projector: PlanarProjector, material: LayerMaterials) => { design: Design; layer: PlacedLayer },
  ): void {
    const backfaces = spot?.isBack === true;
    const material = this.reach.at(projector, backfaces, spot?.material ?? this.#store.state.material ?? 0);
    const id = freeIdIn(this.#session.recordedDesign);
    const { design, layer } = make(id, projector, material);
    this.#session.record(addOnTop(design, { ...layer, backfaces }, this.#group()), label);
    this.#session.select(id);
    this.#tellUnpainted(projector, backfaces, spot?.material ?? null);
  }

  /** Says so where a decal was put on a part that is not painted, or not alone. `onto`: that part's material; null where none was met. */
  #tellUnpainted(projector: Projector, backfaces: boolean, onto: number | null): void {
    this.#bare.tell(this.reach.bareOf(projector, backfaces, onto));
    const target = this.#store.state.targets.get(onto ?? -1);
    const shares = target !== undefined && sharesTexels(target) && projector.kind === "planar";
    if (shares && ownsNoTexel(this.#viewer.surface, projector)) this.#bare.tellShared();
    else if (onto !== null) this.#bare.tellTwins([onto]);
  }

  /** The group that is worked in: new decals lie on top of it. */
  #group(): string | null {
    const { selectedId } = this.#store.state;
    const design = this.#session.recordedDesign;
    const selected = layerById(design, selectedId);
    if (selectedId === null || !selected || isLocked(design, selectedId)) return null;
    if (selected.type === "group") return selectedId;
    const visit = visitOf(design, selectedId);
    return visit?.parent?.type === "group" && visit.list === "layers" ? visit.parentId : null;
  }

  /** Slides the chosen decals along the surface by steps of the view: +1 right, +1 up. False where none is chosen. */
  nudge(right: number, up: number, coarse: boolean): boolean {
    const step = NUDGE_SHARE * this.#diagonal() * (coarse ? COARSE : 1);
    return this.#step("nudge", this.#board.strings.steps.move, (layers) =>
      layers.map(({ projector }) => this.#viewer.nudge(projector, right * step, up * step)),
    );
  }

  /** Turns the chosen decals by `steps` degrees, about their common middle. */
  spin(steps: number, coarse: boolean): boolean {
    const degrees = steps * (coarse ? COARSE : 1);
    return this.#step("spin", this.#board.strings.steps.rotate, (layers) =>
      this.#together.changed(layers, (projector) => spunProjector(projector, degrees)),
    );
  }

  /** Scales the chosen decals by `steps` percent, about their common middle. */
  scale(steps: number): boolean {
    const factor = 1 + steps / 100;
    return this.#step("scale", this.#board.strings.steps.scale, (layers) => {
      const scaled = this.#together.changed(layers, (projector) => scaledProjector(projector, factor));
      return scaled.every(hasFittingLengths) ? scaled : null;
    });
  }

  /**
   * Throws the selected decal as another kind: as it was before, where that kind was left only to try others; from the view,
   * anew from where the camera is. False without a selection.
   */
  convert(kind: Projector["kind"]): boolean {
    const layer = this.selected;
    if (!layer) return false;
    if (layer.projector.kind === kind && kind !== "perspective") return true;
    const words = this.#board.strings.projection;
    const placed = this.#asKind(layer, kind);
    if (placed === null) {
      this.#board.info({ title: words.refused[kind], message: words.refusedHint[kind] });
      return true;
    }
    this.#tried.note(layer, placed);
    this.#layers.change(layer.id, placed, words.steps[kind]);
    this.#board.announce(words.announced[kind](layer.name));
    return true;
  }

  #asKind(layer: PlacedLayer, kind: Projector["kind"]): Placement | null {
    const before = kind === "perspective" ? undefined : this.#tried.before(layer, kind);
    if (before) return { projector: before.projector, material: before.material, mirror: before.mirror };
    const projector = this.#viewer.convertProjector(layer.projector, kind, this.#stampMaterial(layer));
    if (projector === null) return null;
    // A stamp lies on no side of the model that a mirror could show.
    const mirror = kind === "uv" ? null : layer.mirror;
    return { projector, material: this.reach.movedTo(layer, projector, null, mirror), mirror };
  }

  /** Turns the selected decal where it lies, or slides it into the model's middle. False without a selection. */
  align(how: "surface" | "upright" | "view" | "middle"): boolean {
    const layer = this.selected;
    const { model } = this.#store.state;
    if (!layer || !model) return false;
    const projector =
      how === "middle"
        ? this.#viewer.centred(layer.projector, middlesOf(model.info))
        : this.#viewer.alignProjector(layer.projector, how, this.#stampMaterial(layer));
    if (how === "middle" && projector === layer.projector) {
      this.#board.announce(this.#board.strings.projection.noMiddle(layer.name));
      return true;
    }
    this.#layers.change(layer.id, this.placed(layer.id, projector), this.#board.strings.projection.alignSteps[how]);
    this.#board.announce(this.#board.strings.projection.aligned[how](layer.name));
    return true;
  }

  /** Brings what is chosen into line with the selected one of it, else with the topmost. */
  alignTogether(line: LineOfLayers): void {
    const { projection } = this.#board.strings;
    this.#moveTogether({
      projectors: (layers, first) => alignedTogether(layers, first, line, this.#viewer),
      step: projection.lineSteps[line],
      told: projection.inLine[line],
      nothing: projection.noLine,
    });
  }

  /** Spreads what is chosen evenly between its ends, along the selected one of it, else along the topmost. */
  spreadTogether(spread: SpreadOfLayers): void {
    const { projection } = this.#board.strings;
    this.#moveTogether({
      projectors: (layers, first) => spreadTogether(layers, first, spread, this.#viewer),
      step: projection.spreadSteps[spread],
      told: () => projection.spreadOut[spread],
      nothing: () => projection.noSpread,
    });
  }

  #moveTogether({ projectors: find, step, told, nothing }: MoveTogether): void {
    const { movable } = this;
    const first = movable.find(({ id }) => id === this.#store.state.selectedId) ?? movable.at(-1);
    if (!first) return;
    const projectors = find(movable, first);
    if (movable.every(({ projector }, index) => projector === projectors[index])) {
      this.#board.announce(nothing(first.name));
      return;
    }
    this.#session.record(this.#designWith(movable, projectors), step);
    this.#board.announce(told(first.name));
    this.#tellLeft(movable);
  }

  /** What a layer takes on with another projector: that, the materials that it lies on then, and its mask, which goes along. */
  placed(id: string, projector: Projector): Pick<LayerMove, "projector"> & Partial<LayerMove> {
    const layer = layerById(this.#session.recordedDesign, id);
    if (!isPlaced(layer)) return { projector };
    this.#tellLeft([layer]);
    return this.#moved(layer, projector)[1];
  }

  /** What a text takes on with another box about its words. Its mask stays: the letters do not go where their box does. */
  laid<Box extends Pick<PlacedLayer, "projector">>(layer: PlacedLayer, box: Box): Box & Pick<LayerMove, "material"> {
    return { ...box, material: this.reach.movedTo(layer, box.projector, null) };
  }

  #moved(layer: PlacedLayer, projector: Projector, onto: number | null = null): [string, LayerMove] {
    const mask = carriedMask(layer, projector, this.#find().surface);
    return [layer.id, { projector, material: this.reach.movedTo(layer, projector, onto), mask }];
  }

  /** The material in whose texture a layer lies as a stamp: the shown one where it paints that, too. */
  #stampMaterial(layer: PlacedLayer): number {
    const own = materialsOf(layer);
    const { material } = this.#store.state;
    return material !== null && own.includes(material) ? material : (own[0] ?? 0);
  }

  /** Gives a decal all materials that it meets where it lies. */
  paintAllMet(layer: PlacedLayer): void {
    const { projector, backfaces, mirror } = layer;
    const material = this.reach.at(projector, backfaces, materialsOf(layer)[0] ?? 0, mirror);
    this.#layers.change(
      layer.id,
      { material },
      this.#board.strings.steps.change(this.#board.strings.properties.material),
    );
  }

  /** @param change null where none of them can be changed so any further */
  #step(
    kind: StepKind,
    label: string,
    change: (layers: readonly PlacedLayer[]) => readonly Projector[] | null,
  ): boolean {
    const { chosen, movable } = this;
    if (chosen.length === 0) return false;
    const ids = this.#layers.unlocked(chosen.map(({ layer }) => layer.id));
    const changed = change(movable);
    if (changed) this.#session.record(this.#designWith(movable, changed), label, `${kind}:${ids}`);
    if (movable.length > 0) this.#report.after(kind);
    this.#tellLeft(movable);
    return true;
  }

  /** The recorded design with layers put where projectors have them. */
  #designWith(layers: readonly PlacedLayer[], projectors: readonly Projector[]): Design {
    return this.#withMoves(layers.map((layer, index) => this.#moved(layer, projectors[index] ?? layer.projector)));
  }

  /** The recorded design with what is chosen put elsewhere, and the masks of groups that go along with all that is in them. */
  #withMoves(moves: readonly [string, LayerMove][]): Design {
    const patches = new Map<string, Partial<LayerMove>>(moves);
    const { groups, surface } = this.#find();
    const masks = groups.map(({ group, pictures }): [string, Partial<LayerMove>] => {
      const now = pictures.map(({ id, projector }) => patches.get(id)?.projector ?? projector);
      return [group.id, { mask: carriedGroupMask(group.mask, pictures, now, surface) }];
    });
    return patchEach(this.#session.recordedDesign, new Map([...patches, ...masks]));
  }

  /** A view's drag of a decal: shown while it goes on, a step of the history when it ends. */
  followGesture(gesture: DecalGesture): void {
    if (gesture.id === TOGETHER) this.#followBox(gesture);
    else this.#followDecal(gesture);
  }

  /** While a view drags what has this id: the design without that, and what goes along. */
  draggedWith(id: string): Dragged {
    const along = id === TOGETHER ? this.movable : (this.#carried ?? []).map(({ layer }) => layer);
    return {
      design: this.#copied ?? this.#session.recordedDesign,
      moved: new Set([id, ...along.map((each) => each.id)]),
    };
  }

  #followBox({ kind, phase, projector }: DecalGesture): void {
    if (phase === "cancel") this.#session.cancelPreview();
    if (phase !== "move" && phase !== "end") return;
    const { movable } = this;
    const projectors = this.#together.dragged(movable, projector, phase === "end");
    const design = this.#designWith(movable, projectors);
    if (phase === "move") this.#session.preview(design);
    else {
      this.#session.record(design, this.#board.strings.steps[kind]);
      this.#tellLeft(movable);
    }
  }

  #followDecal({ id, kind, phase, projector, material: onto }: DecalGesture): void {
    if (phase === "start") {
      const copies = this.#copiesDragged && kind === "slide";
      const together = !copies && this.#isChosen(id);
      this.#onRelease = null;
      if (!together) this.#layers.select(id);
      this.#carried = together ? this.#othersThan(id) : null;
      this.#copied = copies ? this.#layers.withCopyBelow(id) : null;
    } else if (phase === "cancel") this.#session.cancelPreview();
    else {
      const layer = layerById(this.#session.recordedDesign, id);
      if (!isPlaced(layer)) return;
      const [, patch] = this.#moved(layer, projector, onto);
      if (this.#copied) this.#dragCopy(this.#copied, id, patch, phase);
      else if (this.#carried) this.#dragTogether(layer, patch, this.#carried, kind, phase);
      else if (phase === "move") this.#layers.preview(id, patch);
      else this.#layers.change(id, patch, this.#board.strings.steps[kind]);
      if (phase !== "end") return;
      this.#tellUnpainted(projector, layer.backfaces, onto);
      this.#tellLeft([layer, ...(this.#carried ?? []).map((carried) => carried.layer)]);
    }
  }

  /** After what is chosen was moved. */
  #tellLeft(moved: readonly PlacedLayer[]): void {
    const groups = this.#find().groups.map(({ group, pictures }) => [group, pictures] as const);
    this.#left.tell([...moved.map((layer) => [layer, [layer]] as const), ...groups], this.#board);
  }

  #othersThan(id: string): readonly Carried[] {
    const others = this.movable.filter((layer) => layer.id !== id);
    const near = this.#nearFor(others);
    return others.map((layer) => ({ layer, foot: footOf(layer.projector, near) }));
  }

  /** What goes along lies by averaged normals, as in a drag of one; of more it would take too long. */
  #nearFor(others: readonly unknown[]): NearSurface {
    const { surface } = this.#viewer;
    return others.length < MOST_AVERAGED
      ? (place, width) => surface.near(place, width)
      : (place) => surface.near(place);
  }

  #dragTogether(
    { id, projector: start }: PlacedLayer,
    patch: LayerMove,
    carried: readonly Carried[],
    kind: DecalGesture["kind"],
    phase: "move" | "end",
  ): void {
    const follow: typeof carriedProjector = kind === "slide" ? carriedProjector : changedAlike;
    const near = this.#nearFor(carried);
    const others = carried.map(({ layer, foot }) =>
      this.#moved(layer, follow(start, patch.projector, layer.projector, foot, near)),
    );
    const design = this.#withMoves([[id, patch], ...others]);
    if (phase === "move") this.#session.preview(design);
    else this.#session.record(design, this.#board.strings.steps[kind]);
  }

  #dragCopy(copied: Design, id: string, patch: Partial<PlacedLayer>, phase: "move" | "end"): void {
    const design = patchLayer<PlacedLayer>(copied, id, patch);
    if (phase === "move") {
      this.#session.preview(design);
      return;
    }
    const { steps, announce } = this.#board.strings;
    this.#session.record(design, steps.duplicate(1));
    this.#board.announce(announce.duplicated(layerById(design, id)?.name ?? ""));
  }

  #diagonal(): number {
    return diagonalOf(this.#store.state.model);
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

function chosenIn(design: Design, selection: readonly string[]): LayerVisit<PlacedLayer>[] {
  const held = new Set(selection);
  const chosen: LayerVisit<PlacedLayer>[] = [];
  for (const visit of walkLayers(design, { masks: false, strokes: false })) {
    const { layer, parentId } = visit;
    if (parentId !== null && held.has(parentId)) held.add(layer.id);
    if (held.has(layer.id) && isPlaced(layer)) chosen.push({ ...visit, layer });
  }
  return chosen;
}

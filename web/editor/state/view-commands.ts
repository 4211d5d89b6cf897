/** Commands that change how things are looked at: layout, shading, light, maps on the model, parts, animation. */
import type { Engine, MapView } from "../../engine/engine-api.ts";
import type {
  AnimationState,
  MapPicture,
  ModelPart,
  ModelViewer,
  SurfaceHit,
  TextureHover,
  TextureView,
} from "../../viewer/viewer-api.ts";
import type { EditorState, Figures } from "./editor-state.ts";
import { keepAligning } from "./kept-aligning.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";
import { NO_ANIMATION, NO_PARTS, type ViewLayout, type ViewSettings } from "./view-state.ts";

export interface ViewCommandsParts {
  readonly engine: Engine;
  readonly viewer: ModelViewer;
  readonly textureView: TextureView;
  readonly store: Store<EditorState>;
  readonly figures: Store<Figures>;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  /** Makes a material the one that the flat view and the settings are about. */
  readonly showMaterial: (material: number) => void;
}

export class ViewCommands {
  readonly #parts: ViewCommandsParts;
  #mapRequest = 0;

  constructor(parts: ViewCommandsParts) {
    this.#parts = parts;
    const { viewer, textureView, store } = parts;
    viewer.on("hover", ({ hit }) => this.#pointAtModel(hit));
    viewer.on("animation", (state) => this.#takeAnimation(state));
    textureView.on("hover", (hover) => this.#pointAtTexture(hover));
    textureView.on("click", (hover) => this.#markOnModel(hover));
    let seen = store.state;
    store.subscribe(() => {
      const before = seen;
      seen = store.state;
      this.#react(before, seen);
    });
  }

  set(change: Partial<ViewSettings>): void {
    const { store, viewer } = this.#parts;
    const view = { ...store.state.view, ...change };
    store.set({ view });
    viewer.setLook(view);
  }

  setLayout(layout: ViewLayout): void {
    if (layout === this.#parts.store.state.view.layout) return;
    this.set({ layout });
    this.#parts.board.announce(this.#parts.board.strings.views.layoutChosen[layout]);
  }

  toggle(setting: "wireframe" | "turntable" | "guide" | "aligns"): void {
    const on = !this.#parts.store.state.view[setting];
    this.set({ [setting]: on });
    if (setting === "aligns") keepAligning(on);
    this.#parts.board.announce(this.#parts.board.strings.views.toggled(this.#parts.board.strings.views[setting], on));
  }

  toggleShading(): void {
    const shading = this.#parts.store.state.view.shading === "lit" ? "unlit" : "lit";
    this.set({ shading });
    this.#parts.board.announce(this.#parts.board.strings.views.shadings[shading]);
  }

  /** What is not given stays; `clip: null` brings the model to rest. */
  animate(change: Partial<AnimationState>): void {
    this.#parts.viewer.setAnimation(change);
  }

  /** Chooses a part in the list, and makes its material the one that the flat view shows. */
  choosePart(id: number | null): void {
    const { store, showMaterial } = this.#parts;
    const { shown, model, material } = store.state;
    store.set({ shown: { ...shown, chosen: id } });
    const part = shown.parts.find((candidate) => candidate.id === id);
    const info = model?.info.materials.find(({ index }) => index === part?.material);
    if (info && info.refusal === null && info.index !== material) showMaterial(info.index);
  }

  togglePart(id: number): void {
    const { shown } = this.#parts.store.state;
    const hidden = new Set(shown.hidden);
    if (!hidden.delete(id)) hidden.add(id);
    this.#hide(hidden);
    const name = shown.parts.find((part) => part.id === id)?.name ?? "";
    this.#parts.board.announce(
      hidden.has(id) ? this.#parts.board.strings.announce.hidden(name) : this.#parts.board.strings.announce.shown(name),
    );
  }

  /** Shows a group whole, or hides it where all of it is shown. */
  toggleGroup(group: string): void {
    const { shown } = this.#parts.store.state;
    const ids = shown.parts.filter((part) => part.group === group).map(({ id }) => id);
    const show = ids.some((id) => shown.hidden.has(id));
    const hidden = new Set(shown.hidden);
    for (const id of ids) {
      if (show) hidden.delete(id);
      else hidden.add(id);
    }
    this.#hide(hidden);
    this.#parts.board.announce(
      show ? this.#parts.board.strings.announce.shown(group) : this.#parts.board.strings.announce.hidden(group),
    );
  }

  /** Hides all but one part; where it is alone already, shows all. */
  isolatePart(id: number): void {
    const { shown } = this.#parts.store.state;
    const others = shown.parts.filter((part) => part.id !== id).map((part) => part.id);
    const alone = !shown.hidden.has(id) && others.every((other) => shown.hidden.has(other));
    this.#hide(new Set(alone ? [] : others));
    const name = shown.parts.find((part) => part.id === id)?.name ?? "";
    this.#parts.board.announce(
      alone ? this.#parts.board.strings.modelParts.allShown : this.#parts.board.strings.modelParts.isolated(name),
    );
  }

  showAllParts(): void {
    this.#hide(new Set());
    this.#parts.board.announce(this.#parts.board.strings.modelParts.allShown);
  }

  #hide(hidden: ReadonlySet<number>): void {
    const { store, viewer } = this.#parts;
    store.set({ shown: { ...store.state.shown, hidden } });
    viewer.setHiddenParts(hidden);
  }

  #react(before: EditorState, now: EditorState): void {
    const { viewer, textureView, store } = this.#parts;
    if (before.model !== now.model) {
      const parts = this.#named(viewer.parts);
      const hidden = new Set(parts.filter((part) => part.hidden).map(({ id }) => id));
      store.set({
        shown: now.model ? { ...NO_PARTS, parts, hidden } : NO_PARTS,
        animation: { ...NO_ANIMATION, clips: viewer.clips },
        view: { ...now.view, modelMap: "texture" },
      });
    }
    if (before.model !== now.model || before.material !== now.material || before.view.guide !== now.view.guide) {
      const shows = now.view.guide && now.material !== null;
      const { named } = this.#parts.board.strings;
      const guide = shows ? viewer.guideOf(now.material) : [];
      textureView.setGuide(
        guide.map(({ part, face, uv }) => ({
          part: named(part),
          ...(face !== undefined && { face: named(face) }),
          uv,
        })),
      );
    }
    if (before.view.modelMap !== now.view.modelMap || before.targets !== now.targets) this.#showMaps(now);
  }

  /** Of a model that says which parts of its texture are whose, the names are known in each language. */
  #named(parts: readonly ModelPart[]): readonly ModelPart[] {
    const { viewer, board } = this.#parts;
    const { named } = board.strings;
    return parts.map((part) =>
      viewer.guideOf(part.material).length === 0
        ? part
        : { ...part, name: named(part.name), group: part.group === null ? null : named(part.group) },
    );
  }

  /** The engine is asked anew when targets change: a map belongs to a target's size. */
  #showMaps({ view, targets }: EditorState): void {
    const { tasks, board, viewer } = this.#parts;
    this.#mapRequest += 1;
    if (view.modelMap === "texture") {
      viewer.setMapPictures(null);
      return;
    }
    const work = this.#fetchMaps(view.modelMap, [...targets.keys()], this.#mapRequest);
    void tasks.quietly(
      work.catch((thrown: unknown) => board.error(this.#parts.board.strings.errors.couldNotShowMap, thrown)),
    );
  }

  async #fetchMaps(map: MapView, materials: readonly number[], request: number): Promise<void> {
    const pictures = new Map<number, MapPicture>();
    for (const material of materials) pictures.set(material, await this.#parts.engine.viewMap(material, map));
    // A newer choice may have overtaken this one.
    if (request === this.#mapRequest) this.#parts.viewer.setMapPictures(pictures);
  }

  #takeAnimation(state: AnimationState): void {
    const { store } = this.#parts;
    store.set({ animation: { ...store.state.animation, ...state } });
  }

  #pointAtModel(hit: SurfaceHit | null): void {
    const { store, viewer, textureView } = this.#parts;
    const uv = hit && hit.material === store.state.material ? hit.uv : null;
    textureView.setMarker(uv);
    textureView.highlightChart(uv);
    viewer.highlightChart(hit);
    viewer.setMarker(null);
  }

  #pointAtTexture(hover: TextureHover | null): void {
    const { store, figures, viewer, textureView } = this.#parts;
    const texel = hover?.texel ?? null;
    const [before, now] = [figures.state.texel, texel];
    if (before?.[0] !== now?.[0] || before?.[1] !== now?.[1]) figures.set({ texel });
    const { material, tool } = store.state;
    // While something is painted the texture itself is looked at.
    const lights = tool === "move" || tool === "bucket" || tool === "fill";
    const uv = lights && texel ? (hover?.uv ?? null) : null;
    textureView.highlightChart(uv);
    viewer.highlightChart(uv && material !== null ? { material, uv } : null);
  }

  #markOnModel({ uv, texel }: TextureHover): void {
    const { store, viewer } = this.#parts;
    const { material, tool } = store.state;
    if (tool !== "move") return;
    viewer.setMarker(texel && material !== null ? { material, uv } : null);
  }
}

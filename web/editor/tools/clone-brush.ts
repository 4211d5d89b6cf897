/** The clone tool: Alt and a press says from where; then a brush paints what lies there, at an offset that stays. */
import { html } from "lit";
import { Crosshair, Stamp } from "lucide";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { letterOf } from "../state/letter-key.ts";
import type { Strings } from "../strings.ts";
import { icon } from "../ui/icon.ts";
import type { BrushKind, StrokeStart } from "./brush-tool.ts";
import { type CloneCopy, ModelCopy, TextureCopy } from "./clone-copy.ts";
import { CloneGesture } from "./clone-gesture.ts";
import { cloneTargetOf } from "./clone-layer.ts";
import { type Look, steppedLook } from "./clone-look.ts";
import { mirrorOf } from "./mirror-setting.ts";
import type { PaintGesture } from "./stroke-gesture.ts";
import type { ToolOption } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

/** A place of the surface or of the texture, and how the camera looked at it. */
interface ClonePlace {
  readonly material: number;
  readonly uv: readonly [number, number];
  readonly hit: SurfaceHit | null;
  readonly look: Look | null;
}

export class CloneBrush implements BrushKind {
  readonly id = "clone";
  readonly label = (strings: Strings): string => strings.clone.name;
  readonly icon = Stamp;
  readonly shortcut = "S";
  readonly options: readonly ToolOption[] = [
    ...(["size", "hardness", "opacity", "flow", "spacing", "stabiliser", "pressure", "mirror"] as const),
    "aligned",
  ];
  readonly #context: ToolContext;
  #source: ClonePlace | null = null;
  /** Where the first stroke since the source was set began: the offset of those that are aligned. */
  #first: ClonePlace | null = null;
  /** Where the stroke under way copies from, and where it began; between strokes where the newest did. */
  #pair: { readonly source: Look; readonly painted: Look } | null = null;
  #model: unknown = null;
  #line: Promise<unknown> = Promise.resolve();

  constructor(context: ToolContext) {
    this.#context = context;
  }

  readonly armed = (): boolean => this.#context.tools.settings.cloneArmed;

  get #words(): Strings["clone"] {
    return this.#context.board.strings.clone;
  }

  inner(): number {
    return this.#context.tools.settings.hardness;
  }

  readonly activate = (): void => {
    const { store, tools, viewer, textureView } = this.#context;
    if (this.#model !== store.state.model) this.#source = null;
    tools.configure({ cloneArmed: this.#source === null });
    viewer.setMarker(null);
    textureView.setMarker(null);
  };

  readonly deactivate = (): void => this.#mark(null);

  /** The tool's own letter again sets another source. */
  readonly key = (event: KeyboardEvent): boolean => {
    if (event.shiftKey || letterOf(event).toUpperCase() !== this.shortcut) return false;
    const { tools, board } = this.#context;
    tools.configure({ cloneArmed: !this.armed() });
    if (this.armed()) board.announce(this.#words.armed);
    return true;
  };

  readonly alt = (start: StrokeStart): void => {
    const place = this.#placeOf(start);
    if (place === null) return;
    const { tools, board, store } = this.#context;
    this.#source = place;
    this.#model = store.state.model;
    this.#first = null;
    this.#pair = null;
    tools.configure({ cloneArmed: false });
    this.#mark(place);
    board.announce(this.#words.sourceSet);
  };

  begin(start: StrokeStart): PaintGesture | null {
    const { session, store, board, tools, reach } = this.#context;
    if (this.#source === null || this.#model !== store.state.model) {
      tools.configure({ cloneArmed: true });
      board.info({ title: this.#words.noSource, message: this.#words.noSourceHint });
      return null;
    }
    const { selectedId, editingMask } = store.state;
    const target = cloneTargetOf(session.recordedDesign, selectedId, editingMask);
    if (target.kind === "refused") {
      const { title, message } = this.#context.board.strings.tools.refusals[target.reason];
      board.info({ title: title(target.name), message });
      return null;
    }
    const painted = this.#placeOf(start);
    if (painted === null) return null;
    const flat = start.view === "texture";
    const copy = flat ? this.#flatCopy(this.#source, painted) : this.#modelCopy(this.#source, painted);
    if (copy === null) return null;
    const { size, spacing, pressure, opacity, hardness, flow, mirror } = tools.settings;
    return new CloneGesture(
      this.#context,
      {
        brush: { tip: "round", color: "#000000", hardness, flow },
        name: this.#words.mask,
        ...{ size: size ?? 1, spacing, pressure, opacity, copy, session, reach },
        ...{ erases: true, alphaLock: false },
        freeAbove: (...place) => this.#context.viewer.surface.freeAbove(...place),
        filter: tools.pixelMode ? "nearest" : "linear",
        // A copy in the flat texture lies on no side of the model.
        mirror: flat ? null : mirrorOf(mirror, store.state.model?.info ?? null),
        material: flat ? painted.material : null,
        finish: (work) => this.#finish(work),
      },
      this.#line,
    );
  }

  /** The source's mark goes along with the brush. */
  readonly over = (hit: SurfaceHit | null): void => {
    const pair = this.#pair;
    if (pair === null || hit === null || this.armed()) {
      this.#mark(this.#source);
      return;
    }
    const { at } = steppedLook(pair.source, pair.painted, hit.position);
    const near = this.#context.viewer.surface.near(at);
    this.#mark(near);
  };

  readonly renderOptions = () => html`
    <button
      class="outlined"
      id="clone-source"
      aria-pressed=${this.armed()}
      title=${this.#words.setSourceHint}
      @click=${() => this.#context.tools.configure({ cloneArmed: !this.armed() })}
    >
      ${icon(Crosshair)}${this.armed() ? this.#words.pressSource : this.#words.setSource}
    </button>
  `;

  #finish(work: Promise<string | null>): void {
    const { session, store, board } = this.#context;
    this.#line = work
      .then((id) => {
        if (id === null) {
          board.info({ title: this.#words.nothing, message: this.#words.nothingHint });
          return;
        }
        if (store.state.selectedId !== id) {
          // Its strokes are many, and of no interest one by one.
          store.set({ collapsed: new Set([...store.state.collapsed, id]) });
          session.select(id);
        }
        board.announce(this.#words.painted);
      })
      .catch((thrown: unknown) => board.error(this.#words.couldNot, thrown));
    session.recordsLater(this.#line);
  }

  #modelCopy(source: ClonePlace, painted: ClonePlace): CloneCopy | null {
    const { hit, look } = painted;
    const sourceHit = source.hit;
    if (hit === null || look === null || sourceHit === null || source.look === null) {
      this.#context.board.info({ title: this.#words.offSurface, message: this.#words.offSurfaceHint });
      return null;
    }
    const first = this.#context.tools.settings.cloneAligned ? (this.#first ?? painted) : painted;
    this.#first ??= painted;
    const from = first.look === null ? source.look : steppedLook(source.look, first.look, hit.position);
    this.#pair = { source: from, painted: look };
    return new ModelCopy(this.#context, from, look, this.#texelWidth(sourceHit), this.#context.tools.pixelMode);
  }

  #flatCopy(source: ClonePlace, painted: ClonePlace): CloneCopy {
    const kept = this.#context.tools.settings.cloneAligned && this.#first?.material === painted.material;
    const first = kept && this.#first !== null ? this.#first : painted;
    if (!kept) this.#first = painted;
    this.#pair = null;
    return new TextureCopy(this.#context, source, { material: first.material, uv: first.uv });
  }

  #placeOf({ view, hit, uv }: StrokeStart): ClonePlace | null {
    const { viewer, store } = this.#context;
    const material = view === "model" ? hit?.material : store.state.material;
    if (uv === null || material === undefined || material === null) return null;
    return { material, uv, hit, look: hit && { at: hit.position, ...viewer.surface.lookAt(hit) } };
  }

  #texelWidth(hit: SurfaceHit): number {
    const { viewer, store } = this.#context;
    const target = store.state.targets.get(hit.material);
    const [u, v] = hit.uv;
    const [a, b] = viewer.surface.placesInModel(hit, [hit.uv, [u + 1 / (target?.width ?? 1024), v]]);
    const width = a && b ? Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : 0;
    return width > 0 ? width : viewer.surface.metresPerPixel(hit);
  }

  #mark(place: Pick<ClonePlace, "material" | "uv"> | null): void {
    const { viewer, textureView, store } = this.#context;
    viewer.setMarker(place);
    textureView.setMarker(place?.material === store.state.material ? (place?.uv ?? null) : null);
  }
}

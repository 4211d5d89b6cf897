/**
 * Picks the parts that a fill layer paints: a press on the model or on the flat texture, or a key at the mark that arrows move,
 * takes a chart or a face in or out.
 */
import { MousePointerClick } from "lucide";
import { UvCharts } from "../../viewer/uv-charts.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { type FillLayer, materialsOf, type Parts } from "../document/index.ts";
import { layerById } from "../state/design-edits.ts";
import type { LayerCommands } from "../state/layer-commands.ts";
import type { Strings } from "../strings.ts";
import { PickCursor } from "./pick-cursor.ts";
import type { Tool } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

type Context = Pick<ToolContext, "engine" | "store" | "board" | "viewer" | "textureView"> & {
  readonly layers: LayerCommands;
};

export class PartsTool implements Tool {
  readonly id = "parts";
  readonly instead = "move";
  readonly label = (strings: Strings): string => strings.fillParts.tool;
  readonly icon = MousePointerClick;
  readonly shortcut = "";
  readonly options = [];
  readonly #context: Context;
  readonly #cursor: PickCursor;
  /** Of the model's materials, as far as they were asked for; a new model's are others. */
  #charts = new Map<number, Promise<UvCharts>>();
  #model: unknown = null;

  constructor(context: Context) {
    this.#context = context;
    this.#cursor = new PickCursor(
      context,
      (hit) => void this.#toggle(hit),
      (hit) => this.#lightUp(hit),
    );
  }

  readonly input: NonNullable<Tool["input"]> = {
    cursor: "pointer",
    down: ({ hit }) => {
      this.#cursor.hide();
      if (!hit || !this.#layer) return false;
      void this.#toggle(hit);
      return true;
    },
    move: () => {},
    up: () => {},
    interrupted: () => {},
    hover: (sample) => {
      if (sample !== null) this.#cursor.hide();
      else if (this.#cursor.shown) return;
      this.#lightUp(sample?.hit ?? null);
    },
  };

  readonly offered = (): boolean => this.#layer !== undefined;

  get #words(): Strings["fillParts"] {
    return this.#context.board.strings.fillParts;
  }

  deactivate(): void {
    this.forget();
    this.#lightUp(null);
  }

  forget(): void {
    this.#cursor.hide();
  }

  key(event: KeyboardEvent, view: "model" | "texture" | null): boolean {
    return this.#cursor.key(event, view !== null);
  }

  #lightUp(hit: SurfaceHit | null): void {
    const { viewer, textureView, store } = this.#context;
    const shown = this.#layer?.parts.kind === "charts" ? hit : null;
    viewer.highlightChart(shown);
    textureView.highlightChart(shown?.material === store.state.material ? shown.uv : null);
  }

  /** The selected fill, where it paints parts. */
  get #layer(): (FillLayer & { readonly parts: Parts }) | undefined {
    const { design, selectedId } = this.#context.store.state;
    const layer = layerById(design, selectedId);
    return layer?.type === "fill" && layer.parts !== null ? { ...layer, parts: layer.parts } : undefined;
  }

  async #toggle({ material, uv }: SurfaceHit): Promise<void> {
    const { board, layers } = this.#context;
    const before = this.#layer;
    if (!before) return;
    if (!materialsOf(before).includes(material)) {
      board.info({ title: this.#words.title, message: this.#words.otherMaterial });
      return;
    }
    const charts = await this.#chartsOf(material);
    const face = charts.triangleAt(uv);
    // The layer may have been changed while the charts were being found.
    const layer = this.#layer;
    if (face === null || layer?.id !== before.id) return;
    const parts = withToggled(layer.parts, face, charts);
    layers.change(layer.id, { parts }, this.#words.step);
    const count = parts.kind === "charts" ? parts.charts.length : parts.faces.length;
    board.announce(this.#words.picked(parts.kind, count));
  }

  #chartsOf(material: number): Promise<UvCharts> {
    const { engine, store } = this.#context;
    const { model } = store.state;
    if (model !== this.#model) this.#charts = new Map();
    this.#model = model;
    const known = this.#charts.get(material);
    if (known) return known;
    const made = engine.uvTriangles(material).then((triangles) => new UvCharts(triangles));
    this.#charts.set(material, made);
    return made;
  }
}

/** A chart goes by its lowest triangle; a document may have named it by any other. */
function withToggled(parts: Parts, face: number, { chartOf }: UvCharts): Parts {
  if (parts.kind === "faces") return { kind: "faces", faces: toggled(parts.faces, face) };
  const own = new Set(parts.charts.map((triangle) => chartOf[triangle] ?? triangle));
  return { kind: "charts", charts: toggled([...own], chartOf[face] ?? face) };
}

/** In order, so that the same choice is the same document. */
function toggled(indices: readonly number[], index: number): number[] {
  const others = indices.filter((each) => each !== index);
  return (others.length < indices.length ? others : [...others, index]).sort((a, b) => a - b);
}

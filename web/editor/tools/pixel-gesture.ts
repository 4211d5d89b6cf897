/**
 * A change of pixel layers under way, one of each material that it meets. Their pictures are read, changed, and written as PNG
 * by the engine's own codec, the same bytes everywhere; since that takes turns of the event loop, what the tool draws waits in
 * line and is shown as it is done.
 */
import type { Picture } from "../../engine/engine-api.ts";
import { encodePng } from "../../engine/png-encoder.ts";
import { type DecalLayer, type Design, type DesignAsset, findLayer } from "../document/index.ts";
import type { Strings } from "../strings.ts";
import { PixelCanvas } from "./pixel-canvas.ts";
import { addPixelLayer, withPixels } from "./pixel-layer.ts";
import type { ToolContext } from "./tool-context.ts";

export type PixelChange = (canvas: PixelCanvas) => void | Promise<void>;

/** What a sheet begins with: the layer that it changes, null for a new one, and that layer's picture. */
export interface PixelStart {
  readonly layer: DecalLayer | null;
  readonly picture: Picture;
}

/** What a gesture needs of a material; `layerId` is that of the layer it would change now, null for a new one. */
export interface PixelSource {
  readonly width: number;
  readonly height: number;
  readonly layerId: string | null;
  readonly alphaLock: boolean;
  readonly begun: Promise<PixelStart>;
}

/** One layer of a gesture. */
interface Sheet {
  readonly source: PixelSource;
  readonly material: number;
  canvas: PixelCanvas | null;
  layer: DecalLayer | null;
  previewing: boolean;
}

export class PixelGesture {
  readonly #context: ToolContext;
  readonly #open: (material: number) => PixelSource | null;
  readonly #sheets = new Map<number, Sheet | null>();
  readonly #changes: { readonly sheet: Sheet; readonly change: PixelChange }[] = [];
  #work: Promise<void> | null = null;
  #over = false;

  /** @param open what there is to paint of a material; null where nothing can be */
  constructor(context: ToolContext, open: (material: number) => PixelSource | null) {
    this.#context = context;
    this.#open = open;
  }

  /** Texels of a material's grid; null where it cannot be painted. */
  sizeOf(material: number): { readonly width: number; readonly height: number } | null {
    return this.#sheetOf(material)?.source ?? null;
  }

  /** Changes a material's picture, soon; changes are made in the order of these calls. */
  draw(material: number, change: PixelChange): void {
    const sheet = this.#sheetOf(material);
    if (sheet === null) return;
    this.#changes.push({ sheet, change });
    this.#work ??= this.#workOff().finally(() => {
      this.#work = null;
    });
    // Whoever ends the gesture hears of a fault; here it must not go unhandled.
    this.#work.catch(() => {});
  }

  /** Takes back what was drawn so far, everywhere: a shape that follows the pointer is drawn anew. */
  restart(): void {
    for (const sheet of new Set(this.#sheets.values())) {
      if (sheet !== null) this.draw(sheet.material, (canvas) => canvas.restart());
    }
  }

  /** Records what was drawn as one step, and gives the first layer's id; null when nothing changed. Rejects as the engine does. */
  async end(label: string): Promise<string | null> {
    this.#over = true;
    const { session, library, store, board } = this.#context;
    const added: DesignAsset[] = [];
    try {
      while (this.#work !== null || this.#changes.length > 0) await (this.#work ?? this.#workOff());
      const drawn = this.#drawn();
      for (const { canvas } of drawn) {
        const { asset } = await library.add(board.strings.tools.pixelLayer, await encodePng(canvas));
        added.push(asset);
      }
      // Not before: the design may have become another one while the pictures were written.
      let design = session.recordedDesign;
      let first: string | null = null;
      for (const [index, { layer, material }] of drawn.entries()) {
        const { uri } = added[index] as DesignAsset;
        const placed = withSheet(design, store.state.selectedId, layer, material, uri, board.strings);
        if (placed === null) continue;
        design = placed.design;
        first ??= placed.id;
      }
      if (first === null) session.cancelPreview();
      else session.record(design, label);
      return first;
    } catch (thrown) {
      session.cancelPreview();
      throw thrown;
    } finally {
      library.release(added);
    }
  }

  cancel(): void {
    this.#over = true;
    this.#changes.length = 0;
    if ([...this.#sheets.values()].some((sheet) => sheet?.previewing)) this.#context.session.cancelPreview();
  }

  /** Two materials that share a layer share its sheet. */
  #sheetOf(material: number): Sheet | null {
    const known = this.#sheets.get(material);
    if (known !== undefined) return known;
    const source = this.#open(material);
    const shared = [...this.#sheets.values()].find(
      (sheet) => sheet !== null && source?.layerId != null && sheet.source.layerId === source.layerId,
    );
    const sheet = shared ?? (source && { source, material, canvas: null, layer: null, previewing: false });
    this.#sheets.set(material, sheet);
    return sheet;
  }

  /** The sheets that are not as they were, in the order in which they were met. */
  #drawn(): { readonly canvas: PixelCanvas; readonly layer: DecalLayer | null; readonly material: number }[] {
    return [...new Set(this.#sheets.values())].flatMap((sheet) =>
      sheet?.canvas?.changed ? [{ canvas: sheet.canvas, layer: sheet.layer, material: sheet.material }] : [],
    );
  }

  async #workOff(): Promise<void> {
    while (this.#changes.length > 0) {
      const touched = new Set<Sheet>();
      for (const { sheet, change } of this.#changes.splice(0)) {
        const { layer, picture } = await sheet.source.begun;
        sheet.layer = layer;
        sheet.canvas ??= new PixelCanvas(picture, sheet.source.alphaLock);
        await change(sheet.canvas);
        touched.add(sheet);
      }
      if (!this.#over) await this.#show(touched);
    }
  }

  /** The design is shown with pictures whose keys stay: from then on a new picture is all that the engine needs. */
  async #show(touched: ReadonlySet<Sheet>): Promise<void> {
    const { session, library, store } = this.#context;
    let more = false;
    for (const sheet of touched) {
      if (!sheet.canvas?.changed && !sheet.previewing) continue;
      await library.setLive(await encodePng(sheet.canvas as PixelCanvas), slotOf(sheet));
      more ||= !sheet.previewing;
      sheet.previewing = true;
    }
    if (this.#over || !more) return;
    let design = session.recordedDesign;
    for (const sheet of new Set(this.#sheets.values())) {
      if (!sheet?.previewing) continue;
      const { layer, material } = sheet;
      const live = `live:${slotOf(sheet)}`;
      const { strings } = this.#context.board;
      design = withSheet(design, store.state.selectedId, layer, material, live, strings)?.design ?? design;
    }
    session.preview(design);
  }
}

const slotOf = ({ material }: Sheet): string => `pixels-${material}`;

/** Null where the layer is no longer there. */
function withSheet(
  design: Design,
  selectedId: string | null,
  layer: DecalLayer | null,
  material: number,
  uri: string,
  strings: Strings,
): { readonly design: Design; readonly id: string } | null {
  const png = { type: "image/png", uri } as const;
  if (layer === null) return addPixelLayer(design, selectedId, material, png, strings);
  if (findLayer(design, layer.id) === undefined) return null;
  return { design: withPixels(design, layer.id, png, strings), id: layer.id };
}

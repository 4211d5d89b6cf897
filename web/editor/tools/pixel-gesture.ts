/**
 * A change of pixel layers under way, one of each material that it meets. Their pictures are read, changed, and written as PNG
 * by the engine's own codec, the same bytes everywhere; since that takes turns of the event loop, what the tool draws waits in
 * line and is shown as it is done.
 */
import type { Picture } from "../../engine/engine-api.ts";
import { encodePng } from "../../engine/png-encoder.ts";
import { type DecalLayer, type Design, type DesignAsset, findLayer } from "../document/index.ts";
import { PixelCanvas, type PixelColor } from "./pixel-canvas.ts";
import { addMaskPixels, addPixelLayer, type MaskedPixels, withPixels } from "./pixel-layer.ts";
import type { ToolContext } from "./tool-context.ts";

const MASK_INK: PixelColor = [0, 0, 0, 255];

export type PixelChange = (canvas: PixelCanvas) => void | Promise<void>;

/** What a sheet begins with: the layer that it changes, null for a new one, and that layer's picture. */
export interface PixelStart {
  readonly layer: DecalLayer | null;
  readonly picture: Picture;
  /** What lies above it and gives way to what is drawn: on a mask, what does otherwise. */
  readonly over?: Omit<PixelStart, "over"> | null;
}

/** What a gesture needs of a material; `layerId` is that of the layer it would change now, null for a new one. */
export interface PixelSource {
  readonly width: number;
  readonly height: number;
  readonly layerId: string | null;
  readonly alphaLock: boolean;
  readonly begun: Promise<PixelStart>;
}

/** Where the pictures of a sheet are. */
interface Addresses {
  readonly own: string;
  readonly over: string | null;
}

/** One layer of a gesture. */
interface Sheet {
  readonly source: PixelSource;
  readonly material: number;
  canvas: PixelCanvas | null;
  layer: DecalLayer | null;
  over: DecalLayer | null;
  previewing: boolean;
}

export class PixelGesture {
  readonly #context: ToolContext;
  readonly #open: (material: number) => PixelSource | null;
  readonly #masked: MaskedPixels | null;
  readonly #keep: (uri: string, picture: Picture) => void;
  /** The newest picture of each canvas as PNG, and the revision that it is of. */
  readonly #written = new WeakMap<PixelCanvas, { readonly revision: number; readonly png: Uint8Array }>();
  readonly #sheets = new Map<number, Sheet | null>();
  readonly #changes: { readonly sheet: Sheet; readonly change: PixelChange }[] = [];
  #work: Promise<void> | null = null;
  #over = false;

  /**
   * @param open what there is to paint of a material; null where nothing can be
   * @param masked the mask that is painted on in place of layers
   * @param keep takes each picture that was recorded, by its address: the next stroke begins with it
   */
  constructor(
    context: ToolContext,
    open: (material: number) => PixelSource | null,
    masked: MaskedPixels | null = null,
    keep: (uri: string, picture: Picture) => void = () => {},
  ) {
    this.#context = context;
    this.#keep = keep;
    this.#open = open;
    this.#masked = masked;
  }

  /** All that counts in a mask is alpha: its texels have one colour, and none is set twice for another. */
  get ink(): PixelColor | null {
    return this.#masked && MASK_INK;
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
    const { session, library, board } = this.#context;
    const added: DesignAsset[] = [];
    try {
      while (this.#work !== null || this.#changes.length > 0) await (this.#work ?? this.#workOff());
      const drawn = this.#drawn();
      const add = async (canvas: PixelCanvas): Promise<string> => {
        const { asset } = await library.add(board.strings.tools.pixelLayer, await this.#pngOf(canvas));
        added.push(asset);
        const { width, height, rgba } = canvas;
        this.#keep(asset.uri, { width, height, rgba });
        return asset.uri;
      };
      const addresses: Addresses[] = [];
      for (const { canvas } of drawn) {
        addresses.push({ own: await add(canvas), over: canvas.over?.changed ? await add(canvas.over) : null });
      }
      // Not before: the design may have become another one while the pictures were written.
      let design = session.recordedDesign;
      let first: string | null = null;
      for (const [index, { sheet }] of drawn.entries()) {
        const placed = this.#withSheet(design, sheet, addresses[index] as Addresses);
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
    const sheet = shared ?? (source && { source, material, canvas: null, layer: null, over: null, previewing: false });
    this.#sheets.set(material, sheet);
    return sheet;
  }

  /** The sheets that are not as they were, in the order in which they were met. */
  #drawn(): { readonly canvas: PixelCanvas; readonly sheet: Sheet }[] {
    return [...new Set(this.#sheets.values())].flatMap((sheet) =>
      sheet?.canvas?.changed ? [{ canvas: sheet.canvas, sheet }] : [],
    );
  }

  async #workOff(): Promise<void> {
    while (this.#changes.length > 0) {
      const touched = new Set<Sheet>();
      for (const { sheet, change } of this.#changes.splice(0)) {
        const { layer, picture, over } = await sheet.source.begun;
        sheet.layer = layer;
        sheet.over = over?.layer ?? null;
        sheet.canvas ??= new PixelCanvas(
          picture,
          sheet.source.alphaLock,
          over ? new PixelCanvas(over.picture, false) : null,
        );
        await change(sheet.canvas);
        touched.add(sheet);
      }
      if (!this.#over) await this.#show(touched);
    }
  }

  /** The design is shown with pictures whose keys stay: from then on a new picture is all that the engine needs. */
  async #show(touched: ReadonlySet<Sheet>): Promise<void> {
    const { session } = this.#context;
    let more = false;
    for (const sheet of touched) {
      const { canvas } = sheet;
      if (canvas === null || (!canvas.changed && !sheet.previewing)) continue;
      const { own, over } = slotsOf(sheet);
      await this.#showLive(canvas, own);
      if (canvas.over) await this.#showLive(canvas.over, over);
      more ||= !sheet.previewing;
      sheet.previewing = true;
    }
    if (this.#over || !more) return;
    let design = session.recordedDesign;
    for (const sheet of new Set(this.#sheets.values())) {
      if (!sheet?.previewing) continue;
      const { own, over } = slotsOf(sheet);
      const addresses = { own: `live:${own}`, over: sheet.over && `live:${over}` };
      design = this.#withSheet(design, sheet, addresses)?.design ?? design;
    }
    session.preview(design);
  }

  /** Most moves of a pointer stay within one texel: what it drew is shown already. */
  async #showLive(canvas: PixelCanvas, slot: string): Promise<void> {
    if (this.#written.get(canvas)?.revision === canvas.revision) return;
    await this.#context.library.setLive(await this.#pngOf(canvas), slot);
  }

  async #pngOf(canvas: PixelCanvas): Promise<Uint8Array> {
    const { revision } = canvas;
    const written = this.#written.get(canvas);
    if (written?.revision === revision) return written.png;
    const png = await encodePng(canvas);
    this.#written.set(canvas, { revision, png });
    return png;
  }

  /** The design with a sheet's pictures, and the id of the layer that is chosen then; null where it has no place any more. */
  #withSheet(
    design: Design,
    { layer, over, material }: Sheet,
    addresses: Addresses,
  ): { readonly design: Design; readonly id: string } | null {
    const { store, board } = this.#context;
    const { strings } = board;
    const png = { type: "image/png", uri: addresses.own } as const;
    const masked = this.#masked;
    if (layer !== null) {
      if (findLayer(design, layer.id) === undefined) return null;
      const own = withPixels(design, layer.id, png, strings);
      const both = over && addresses.over ? withPixels(own, over.id, { ...png, uri: addresses.over }, strings) : own;
      return { design: both, id: masked?.layerId ?? layer.id };
    }
    if (masked === null) return addPixelLayer(design, store.state.selectedId, material, png, strings);
    const made = addMaskPixels(design, masked, material, png, strings);
    return made && { design: made, id: masked.layerId };
  }
}

const slotsOf = ({ material }: Sheet): { readonly own: string; readonly over: string } => ({
  own: `pixels-${material}`,
  over: `pixels-${material}-over`,
});

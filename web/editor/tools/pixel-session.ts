/** Begins changes of pixel layers, one after another, and keeps what is read from them. */
import type { MaterialInfo, ModelInfo, Picture } from "../../engine/engine-api.ts";
import { decodePicture } from "../../engine/picture-decoder.ts";
import { decodeDataUri } from "../document/data-uri.ts";
import { type DecalLayer, type DesignLayer, findLayer, hasRoom, isLocked } from "../document/index.ts";
import { PixelGesture, type PixelSource, type PixelStart } from "./pixel-gesture.ts";
import { type MaskedPixels, type MaskPixels, maskPixelLayer, masksMaterial, pixelLayerFor } from "./pixel-layer.ts";
import { TexelNeighbours } from "./texel-neighbours.ts";
import type { ToolContext } from "./tool-context.ts";

export interface PixelSize {
  readonly width: number;
  readonly height: number;
}

/** A material's texels among those of several, counted one after another from `first` on. */
export interface JoinedGrid extends PixelSize {
  readonly material: number;
  readonly first: number;
}

/** Texels: textures of other materials that have more are not looked at when a fill might reach them. */
const MOST_JOINED = 512 * 512;
/** Of a target without a picture that is not open yet: the engine's. */
const UNKNOWN_SIZE = 1024;
/** Pictures kept decoded: the newest, and what an undo or two goes back to. */
const PICTURES_KEPT = 6;

export class PixelSession {
  readonly #context: ToolContext;
  readonly #pictures = new Map<string, Picture>();
  #line: Promise<unknown> = Promise.resolve();
  #neighbours: { readonly model: ModelInfo; readonly key: string; readonly map: TexelNeighbours } | null = null;

  constructor(context: ToolContext) {
    this.#context = context;
  }

  /** What a gesture that begins now paints on in place of a layer: the mask that is marked; null where none is. */
  masked(hides: boolean): MaskedPixels | null {
    const { editingMask } = this.#context.store.state;
    return editingMask === null ? null : { layerId: editingMask, hides };
  }

  /** Texels of the grid that is painted on a material; null while its target is not open. */
  sizeOf(material: number, masked = this.masked(false)): PixelSize | null {
    const { session, store, library } = this.#context;
    const layer = this.#layerOf(material, masked);
    const picture = layer && library.get(session.recordedDesign.assets[layer.asset]);
    return picture ?? store.state.targets.get(material) ?? this.#sizeToBe(material);
  }

  /** Of a target that is opened once something lies on it: another material that the pointer went over. */
  #sizeToBe(material: number): PixelSize | null {
    const { targetSettings } = this.#context.store.state;
    const info = this.#materialInfo(material);
    if (info === undefined || info.refusal !== null) return null;
    const size = targetSettings.get(material)?.size ?? null;
    const [width, height] = size === null ? (info.textureSize ?? [UNKNOWN_SIZE, UNKNOWN_SIZE]) : [size, size];
    return { width, height };
  }

  /** Whether a material takes no paint, which the user is told then. */
  tellBare(material: number): boolean {
    const info = this.#materialInfo(material);
    if (!info?.refusal) return false;
    this.#context.bare.tell(info);
    return true;
  }

  #materialInfo(material: number): MaterialInfo | undefined {
    return this.#context.store.state.model?.info.materials.find(({ index }) => index === material);
  }

  /** Null where nothing can be painted of the material that it begins on; the user is told why. */
  begin(material: number, masked = this.masked(false)): PixelGesture | null {
    const { board, session } = this.#context;
    const reason = this.#refusal(material, masked);
    if (reason !== null) {
      const words = board.strings.tools.refusals[reason];
      board.info({ title: words.title(this.#changed(material, masked)?.name ?? ""), message: words.message });
      return null;
    }
    if (this.#layerOf(material, masked) === undefined && !hasRoom(session.recordedDesign, 1)) {
      board.info(board.strings.tools.fullDesign);
      return null;
    }
    if (this.tellBare(material)) return null;
    // Changes that are still being written may be what makes the layers.
    const ready = this.#line;
    const gesture = new PixelGesture(
      this.#context,
      (met) => this.#open(met, masked, ready),
      masked,
      (uri, picture) => this.#keep(uri, picture),
    );
    return gesture.sizeOf(material) === null ? null : gesture;
  }

  #open(material: number, masked: MaskedPixels | null, ready: Promise<unknown>): PixelSource | null {
    const size = this.sizeOf(material, masked);
    if (size === null || this.#refusal(material, masked) !== null) return null;
    const layer = this.#layerOf(material, masked);
    const locksAlpha = this.#context.tools.settings.alphaLock || layer?.lockAlpha === true;
    return {
      ...size,
      layerId: layer?.id ?? null,
      // A mask is alpha and nothing else.
      alphaLock: masked === null && locksAlpha,
      begun: ready.then(() => this.#start(material, masked, size)),
    };
  }

  /** Why nothing can be painted of a material; null where it can. */
  #refusal(material: number, masked: MaskedPixels | null): "locked" | "hidden" | "elsewhere" | null {
    const changed = this.#changed(material, masked);
    if (changed === undefined) return null;
    if (isLocked(this.#context.session.recordedDesign, changed.id)) return "locked";
    if (!changed.visible) return "hidden";
    return masked !== null && !masksMaterial(changed, material) ? "elsewhere" : null;
  }

  /** The layer that changes, itself or its mask; undefined for one that is to be made. */
  #changed(material: number, masked: MaskedPixels | null): DesignLayer | undefined {
    const { session } = this.#context;
    return masked ? findLayer(session.recordedDesign, masked.layerId) : this.#layerOf(material, null);
  }

  #layerOf(material: number, masked: MaskedPixels | null): DecalLayer | undefined {
    const { session, store } = this.#context;
    if (masked !== null) return this.#maskPixels(material, masked)?.layer;
    return pixelLayerFor(session.recordedDesign, store.state.selectedId, material);
  }

  #maskPixels(material: number, { layerId, hides }: MaskedPixels): MaskPixels | undefined {
    const mask = findLayer(this.#context.session.recordedDesign, layerId)?.mask;
    return mask ? maskPixelLayer(mask, hides, material) : undefined;
  }

  /** Ends a gesture as one step, before any later one begins. */
  finish(gesture: PixelGesture, label: string, done: (layerId: string) => void): void {
    const { board, session } = this.#context;
    this.#line = gesture
      .end(label)
      .then((id) => {
        if (id !== null) done(id);
      })
      .catch((thrown: unknown) => board.error(this.#context.board.strings.tools.couldNotPaint, thrown));
    session.recordsLater(this.#line);
  }

  /**
   * Which texels lie beside each other on the model: those of a material, and with `others` those of the other materials that
   * are open. `neighbours` is null without a model.
   */
  joinedGrids(
    material: number,
    others: boolean,
  ): { readonly grids: readonly JoinedGrid[]; readonly neighbours: TexelNeighbours | null } {
    const { viewer, store } = this.#context;
    const met = [material, ...(others ? [...store.state.targets.keys()].filter((other) => other !== material) : [])];
    const grids: JoinedGrid[] = [];
    let first = 0;
    for (const each of met) {
      const size = this.sizeOf(each);
      if (size === null || (each !== material && size.width * size.height > MOST_JOINED)) continue;
      grids.push({ material: each, width: size.width, height: size.height, first });
      first += size.width * size.height;
    }
    const info = store.state.model?.info;
    if (info === undefined) return { grids, neighbours: null };
    const key = grids.map(({ material: each, width, height }) => `${each} ${width} ${height}`).join();
    if (this.#neighbours?.model !== info || this.#neighbours.key !== key) {
      const places = grids.map((grid) => viewer.surface.texelPlaces(grid.material, grid.width, grid.height));
      const known = places.filter((each) => each !== null);
      const complete = known.length === places.length;
      this.#neighbours = complete ? { model: info, key, map: new TexelNeighbours(...known) } : null;
    }
    return { grids, neighbours: this.#neighbours?.map ?? null };
  }

  /** The finished texture of a material, at the grid's size: what is seen where a bucket is emptied. */
  async seen(material: number, { width, height }: PixelSize): Promise<Uint8Array> {
    const target = this.#context.store.state.targets.get(material);
    if (!target) return new Uint8Array(width * height * 4);
    const rgba = await this.#context.engine.readTexels(material, 0, 0, target.width, target.height);
    if (target.width === width && target.height === height) return rgba;
    const scaled = new Uint8Array(width * height * 4);
    for (let texel = 0; texel < width * height; texel++) {
      const x = Math.floor((((texel % width) + 0.5) / width) * target.width);
      const y = Math.floor(((Math.floor(texel / width) + 0.5) / height) * target.height);
      const at = (y * target.width + x) * 4;
      scaled.set(rgba.subarray(at, at + 4), texel * 4);
    }
    return scaled;
  }

  async #start(material: number, masked: MaskedPixels | null, { width, height }: PixelSize): Promise<PixelStart> {
    const read = async (layer: DecalLayer | null | undefined): Promise<PixelStart | null> => {
      const uri = layer && this.#context.session.recordedDesign.assets[layer.asset]?.uri;
      const picture = uri ? await this.#read(uri, layer.name) : null;
      return layer && picture?.width === width && picture.height === height ? { layer, picture } : null;
    };
    const above = masked && this.#maskPixels(material, masked)?.over;
    const [start, over] = [await read(this.#layerOf(material, masked)), await read(above)];
    if (start && (over || !above)) return { ...start, over };
    return { layer: null, picture: { width, height, rgba: new Uint8Array(width * height * 4) } };
  }

  async #read(uri: string, name: string): Promise<Picture> {
    const picture = this.#pictures.get(uri) ?? (await decodePicture(decodeDataUri(uri, name), name));
    this.#keep(uri, picture);
    return picture;
  }

  #keep(uri: string, picture: Picture): void {
    this.#pictures.delete(uri);
    this.#pictures.set(uri, picture);
    const [oldest] = this.#pictures.keys();
    if (this.#pictures.size > PICTURES_KEPT && oldest !== undefined) this.#pictures.delete(oldest);
  }
}

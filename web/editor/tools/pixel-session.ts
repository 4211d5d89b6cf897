/** Begins changes of pixel layers, one after another, and keeps what is read from them. */
import type { ModelInfo, Picture } from "../../engine/engine-api.ts";
import { decodePicture } from "../../engine/picture-decoder.ts";
import { decodeDataUri } from "../files/data-uri.ts";
import { strings } from "../strings.ts";
import { PixelGesture, type PixelStart } from "./pixel-gesture.ts";
import { pixelLayerFor } from "./pixel-layer.ts";
import { TexelNeighbours } from "./texel-neighbours.ts";
import type { ToolContext } from "./tool-context.ts";

export interface PixelSize {
  readonly width: number;
  readonly height: number;
}

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

  /** Texels of the grid that is painted on a material; null while its target is not open. */
  sizeOf(material: number): PixelSize | null {
    const { session, store, library } = this.#context;
    const layer = pixelLayerFor(session.recordedDesign, store.state.selectedId, material);
    const picture = layer && library.get(session.recordedDesign.assets[layer.asset]);
    return picture ?? store.state.targets.get(material) ?? null;
  }

  /** Null where nothing can be painted; the user is told why. */
  begin(material: number): PixelGesture | null {
    const { session, store, board, tools } = this.#context;
    const size = this.sizeOf(material);
    if (size === null) return null;
    const layer = pixelLayerFor(session.recordedDesign, store.state.selectedId, material);
    if (layer !== undefined && (layer.locked || !layer.visible)) {
      const words = strings.tools.refusals[layer.locked ? "locked" : "hidden"];
      board.info({ title: words.title(layer.name), message: words.message });
      return null;
    }
    const { alphaLock } = tools.settings;
    const lock = alphaLock || layer?.lockAlpha === true;
    // A change that is still being written may be what makes the layer.
    return new PixelGesture(
      this.#context,
      material,
      size,
      lock,
      this.#line.then(() => this.#start(material, size)),
    );
  }

  /** Ends a gesture as one step, before any later one begins. */
  finish(gesture: PixelGesture, label: string, done: (layerId: string) => void): void {
    const { board } = this.#context;
    this.#line = gesture
      .end(label)
      .then((id) => {
        if (id !== null) done(id);
      })
      .catch((thrown: unknown) => board.error(strings.tools.couldNotPaint, thrown));
  }

  /** Resolves when every gesture that was finished is recorded. */
  async settled(): Promise<void> {
    await this.#line;
  }

  /** Which texels of a material's grid lie beside each other; null without a model. */
  neighboursOf(material: number, { width, height }: PixelSize): TexelNeighbours | null {
    const { viewer, store } = this.#context;
    const info = store.state.model?.info;
    if (info === undefined) return null;
    const key = `${material} ${width} ${height}`;
    if (this.#neighbours?.model !== info || this.#neighbours.key !== key) {
      const places = viewer.surface.texelPlaces(material, width, height);
      this.#neighbours = places && { model: info, key, map: new TexelNeighbours(places) };
    }
    return this.#neighbours?.map ?? null;
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

  async #start(material: number, { width, height }: PixelSize): Promise<PixelStart> {
    const { session, store } = this.#context;
    const layer = pixelLayerFor(session.recordedDesign, store.state.selectedId, material);
    const uri = layer && session.recordedDesign.assets[layer.asset]?.uri;
    if (layer !== undefined && uri !== undefined) {
      const picture = await this.#read(uri, layer.name);
      if (picture.width === width && picture.height === height) return { layer, picture };
    }
    return { layer: null, picture: { width, height, rgba: new Uint8Array(width * height * 4) } };
  }

  async #read(uri: string, name: string): Promise<Picture> {
    const picture = this.#pictures.get(uri) ?? (await decodePicture(decodeDataUri(uri, name), name));
    this.#pictures.delete(uri);
    this.#pictures.set(uri, picture);
    const [oldest] = this.#pictures.keys();
    if (this.#pictures.size > PICTURES_KEPT && oldest !== undefined) this.#pictures.delete(oldest);
    return picture;
  }
}

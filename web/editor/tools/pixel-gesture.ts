/**
 * A change of a pixel layer under way. Its picture is read, changed, and written as PNG by the engine's own codec, the same
 * bytes everywhere; since that takes turns of the event loop, what the tool draws waits in line and is shown as it is done.
 */
import type { Picture } from "../../engine/engine-api.ts";
import { encodePng } from "../../engine/png-encoder.ts";
import type { DecalLayer } from "../document/index.ts";
import { strings } from "../strings.ts";
import { PixelCanvas } from "./pixel-canvas.ts";
import { addPixelLayer, withPixels } from "./pixel-layer.ts";
import type { ToolContext } from "./tool-context.ts";

export type PixelChange = (canvas: PixelCanvas) => void | Promise<void>;

/** What a gesture begins with: the layer that it changes, null for a new one, and that layer's picture. */
export interface PixelStart {
  readonly layer: DecalLayer | null;
  readonly picture: Picture;
}

export class PixelGesture {
  readonly width: number;
  readonly height: number;
  readonly material: number;
  readonly #context: ToolContext;
  readonly #alphaLock: boolean;
  readonly #begun: Promise<PixelStart>;
  readonly #changes: PixelChange[] = [];
  #work: Promise<void> | null = null;
  #canvas: PixelCanvas | null = null;
  #previewing = false;
  #over = false;

  constructor(
    context: ToolContext,
    material: number,
    size: { readonly width: number; readonly height: number },
    alphaLock: boolean,
    begun: Promise<PixelStart>,
  ) {
    this.#context = context;
    this.material = material;
    this.width = size.width;
    this.height = size.height;
    this.#alphaLock = alphaLock;
    this.#begun = begun;
  }

  /** Changes the picture, soon; changes are made in the order of these calls. */
  draw(change: PixelChange): void {
    this.#changes.push(change);
    this.#work ??= this.#workOff().finally(() => {
      this.#work = null;
    });
    // Whoever ends the gesture hears of a fault; here it must not go unhandled.
    this.#work.catch(() => {});
  }

  /** Records what was drawn as one step, and gives the layer's id; null when nothing changed. Rejects as the engine does. */
  async end(label: string): Promise<string | null> {
    this.#over = true;
    try {
      while (this.#work !== null || this.#changes.length > 0) await (this.#work ?? this.#workOff());
      const { layer } = await this.#begun;
      if (!this.#canvas?.changed) {
        this.#context.session.cancelPreview();
        return null;
      }
      const { session, library, store } = this.#context;
      const { asset } = await library.add(strings.tools.pixelLayer, await encodePng(this.#canvas));
      const png = { type: "image/png", uri: asset.uri } as const;
      const { design, id } =
        layer === null
          ? addPixelLayer(session.recordedDesign, store.state.selectedId, this.material, png)
          : { design: withPixels(session.recordedDesign, layer.id, png), id: layer.id };
      session.record(design, label);
      return id;
    } catch (thrown) {
      this.#context.session.cancelPreview();
      throw thrown;
    }
  }

  cancel(): void {
    this.#over = true;
    this.#changes.length = 0;
    if (this.#previewing) this.#context.session.cancelPreview();
  }

  async #workOff(): Promise<void> {
    const { layer, picture } = await this.#begun;
    this.#canvas ??= new PixelCanvas(picture, this.#alphaLock);
    while (this.#changes.length > 0) {
      for (const change of this.#changes.splice(0)) await change(this.#canvas);
      if (!this.#over && this.#canvas.changed) await this.#show(this.#canvas, layer);
    }
  }

  /** The design is shown with a picture whose key stays: from then on a new picture is all that the engine needs. */
  async #show(canvas: PixelCanvas, layer: DecalLayer | null): Promise<void> {
    const { session, library, store } = this.#context;
    const { asset } = await library.setLive(await encodePng(canvas));
    if (this.#over || this.#previewing) return;
    this.#previewing = true;
    const png = { type: "image/png", uri: asset.uri } as const;
    const { recordedDesign } = session;
    session.preview(
      layer === null
        ? addPixelLayer(recordedDesign, store.state.selectedId, this.material, png).design
        : withPixels(recordedDesign, layer.id, png),
    );
  }
}

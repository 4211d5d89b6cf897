/** A target's layers cut off at its material's zones: the cover as an image of the core, made anew when the zones change. */
import type { ImageHandle, Session } from "../core/session.ts";
import type { Target } from "../core/target.ts";
import type { EngineLayer, TargetInfo } from "./engine-api.ts";
import type { TextureWindow } from "./open-target.ts";
import type { PrintZones } from "./print-zones.ts";
import { clippedLayers, clipsMaterial, type TexelRect, ZONE_PICTURE, zoneCover } from "./zone-clip.ts";

/** Most texels that the cover is copied in at once. */
const COPY_TEXELS = 1 << 22;

interface MadeCover {
  readonly zones: PrintZones;
  readonly image: ImageHandle;
  readonly place: TexelRect;
}

type ImageOf = (asset: string) => ImageHandle | undefined;

export class ZoneClip {
  readonly #session: Session;
  readonly #target: Target;
  readonly #info: TargetInfo;
  readonly #window: TextureWindow | null;
  #made: MadeCover | null = null;

  constructor(session: Session, target: Target, info: TargetInfo, window: TextureWindow | null) {
    this.#session = session;
    this.#target = target;
    this.#info = info;
    this.#window = window;
  }

  /** The layers as the target shall show them. `zones` are those that the session has. */
  apply(
    layers: readonly EngineLayer[],
    zones: PrintZones | null,
    imageOf: ImageOf,
  ): { readonly layers: readonly EngineLayer[]; readonly imageOf: ImageOf } {
    if (zones === null || !clipsMaterial(zones, this.#info.material)) {
      this.forget();
      return { layers, imageOf };
    }
    if (this.#made?.zones !== zones) {
      this.forget();
      this.#made = this.#make(zones);
    }
    const { image, place } = this.#made;
    return {
      layers: clippedLayers(layers, this.#info.material, place),
      imageOf: (asset) => (asset === ZONE_PICTURE ? image : imageOf(asset)),
    };
  }

  /** Gives the image back. */
  forget(): void {
    if (this.#made !== null && !this.#session.core.crashed) this.#session.destroyImage(this.#made.image);
    this.#made = null;
  }

  #make(zones: PrintZones): MadeCover {
    const { width, height } = this.#info;
    const all = new Uint8Array(width * height);
    const rowsAtOnce = Math.max(1, Math.floor(COPY_TEXELS / width));
    for (let row = 0; row < height; row += rowsAtOnce) {
      all.set(this.#target.zoneMask(null, row, Math.min(rowsAtOnce, height - row)), row * width);
    }
    const { rect, picture } = zoneCover(all, width);
    const image = this.#session.createImage(picture.width, picture.height, picture.rgba);
    const { windowX, windowY, textureWidth, textureHeight } = this.#window ?? {
      windowX: 0,
      windowY: 0,
      textureWidth: width,
      textureHeight: height,
    };
    const place = {
      x: (windowX + rect.x) / textureWidth,
      y: (windowY + rect.y) / textureHeight,
      width: rect.width / textureWidth,
      height: rect.height / textureHeight,
    };
    return { zones, image, place };
  }
}

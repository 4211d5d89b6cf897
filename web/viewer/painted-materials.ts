/** The model's materials and the live textures that take the place of their base colour pictures. */
import type { MeshStandardMaterial, Texture, WebGLRenderer } from "three";
import type { TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import { LiveTexture } from "./live-texture.ts";
import type { ModelScene } from "./model-scene.ts";

export interface UploadCost {
  /** Time of the main thread. */
  readonly milliseconds: number;
  readonly bytes: number;
}

export class PaintedMaterials {
  readonly #renderer: WebGLRenderer;
  readonly #scene: ModelScene;
  /** The model's own pictures, which live textures copy their settings from and which are freed with the model. */
  readonly #own = new Map<MeshStandardMaterial, Texture | null>();
  readonly #bound = new Map<number, { info: TargetInfo; live: LiveTexture }>();
  /** Textures of targets that were replaced: shown until the new one has its first picture. */
  readonly #retired = new Map<number, LiveTexture>();
  readonly #pixelated = new Map<number, boolean | null>();

  constructor(renderer: WebGLRenderer, scene: ModelScene) {
    this.#renderer = renderer;
    this.#scene = scene;
    for (const material of [...scene.materials.values()].flat()) {
      this.#own.set(material, material.map);
    }
  }

  /** Whether a material's texels are shown as squares, now and in targets to come; null: as the model asks. */
  setPixelated(material: number, pixelated: boolean | null): void {
    this.#pixelated.set(material, pixelated);
    const bound = this.#bound.get(material);
    if (bound !== undefined) bound.live.pixelated = pixelated;
  }

  get boundMaterials(): readonly number[] {
    return [...this.#bound.keys()];
  }

  /** A target of the same size keeps its texture; another one takes over with its first update. */
  bind(info: TargetInfo): void {
    const before = this.#bound.get(info.material);
    const same =
      before !== undefined &&
      before.info.width === info.width &&
      before.info.height === info.height &&
      before.info.mipLevels === info.mipLevels;
    if (!same) {
      this.#retire(info.material, before?.live);
      this.#bound.set(info.material, {
        info,
        live: this.#makeLive(info),
      });
    }
  }

  /** Updates of a target that was not bound, or of one of another size, are left out. */
  apply(update: TargetUpdate): UploadCost {
    const bound = this.#bound.get(update.material);
    if (bound === undefined || !bound.live.fits(update)) {
      return { milliseconds: 0, bytes: 0 };
    }
    const begin = performance.now();
    const bytes = bound.live.upload(update);
    const milliseconds = performance.now() - begin;
    this.#show(update.material, bound.live);
    return { milliseconds, bytes };
  }

  /** After a lost context the GPU has forgotten every texel: storage is made anew, to be filled by full updates. */
  rebuild(): void {
    for (const [material, { info, live }] of this.#bound) {
      const again = this.#makeLive(info);
      this.#bound.set(material, { info, live: again });
      // A frame that is drawn meanwhile must not bring the old texture's storage back. The old one needs no disposal: the
      // context took its storage along.
      if (this.#scene.materials.get(material)?.some((three) => three.map === live.texture)) {
        this.#show(material, again);
      }
    }
  }

  dispose(): void {
    for (const live of [...[...this.#bound.values()].map((bound) => bound.live), ...this.#retired.values()]) {
      live.dispose();
    }
    for (const [material, texture] of this.#own) {
      material.map = texture;
    }
    this.#bound.clear();
    this.#retired.clear();
  }

  #makeLive(info: TargetInfo): LiveTexture {
    const live = new LiveTexture(this.#renderer, info, this.#ownTexture(info.material));
    const pixelated = this.#pixelated.get(info.material);
    if (pixelated !== undefined) live.pixelated = pixelated;
    return live;
  }

  #ownTexture(index: number): Texture | null {
    const material = this.#scene.materials.get(index)?.[0];
    return (material && this.#own.get(material)) ?? null;
  }

  #show(index: number, live: LiveTexture): void {
    for (const material of this.#scene.materials.get(index) ?? []) {
      if (material.map === live.texture) {
        continue;
      }
      const own = this.#own.get(material);
      if (material.map === null) {
        // A map where there was none changes the shader; a swap of pictures does not.
        material.needsUpdate = true;
      }
      material.map = live.texture;
      // Not seen any more: 22 MB of the GPU's memory for one of 2048².
      own?.dispose();
      if (own === null) {
        // The target's own base is the colour factor, so the factor would count twice.
        material.color.setRGB(1, 1, 1);
        material.opacity = 1;
      }
    }
    this.#retired.get(index)?.dispose();
    this.#retired.delete(index);
  }

  #retire(index: number, live: LiveTexture | undefined): void {
    if (live === undefined) {
      return;
    }
    // One that was retired but never followed by a picture is still what the material shows.
    if (this.#retired.has(index)) {
      live.dispose();
    } else {
      this.#retired.set(index, live);
    }
  }
}

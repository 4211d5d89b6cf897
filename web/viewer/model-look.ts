/**
 * How the model is shown: lit as its materials say, or flat with its texels' own colours; with a map in place of its
 * texture; with its edges over it. Each material has an unlit twin, which takes its place on the meshes.
 */
import {
  type Camera,
  Color,
  DataTexture,
  LinearFilter,
  type Mesh,
  MeshBasicMaterial,
  type MeshStandardMaterial,
  NearestFilter,
  type Scene,
  type WebGLRenderer,
} from "three";
import { layLike } from "./live-texture.ts";
import { type ModelScene, meshesOf } from "./model-scene.ts";
import { MODEL_LAYER, OVERLAY_LAYER } from "./view-layers.ts";
import type { MapPicture } from "./viewer-api.ts";

/** Where no map is known: materials that are no targets. */
const UNMAPPED = new Color(0.22, 0.22, 0.22);

export class ModelLook {
  readonly #scene: ModelScene;
  readonly #meshes: readonly Mesh[];
  readonly #own: readonly MeshStandardMaterial[];
  readonly #twins = new Map<MeshStandardMaterial, MeshBasicMaterial>();
  readonly #wires = new MeshBasicMaterial({ wireframe: true, transparent: true, depthWrite: false, toneMapped: false });
  #maps: ReadonlyMap<number, DataTexture> | null = null;
  #flat = false;
  #wired = false;

  constructor(scene: ModelScene) {
    this.#scene = scene;
    this.#meshes = meshesOf(scene.root);
    this.#own = this.#meshes.map((mesh) => mesh.material as MeshStandardMaterial);
  }

  set unlit(value: boolean) {
    this.#flat = value;
    this.#dress();
  }

  set wireframe(value: boolean) {
    this.#wired = value;
    for (const material of [...this.#own, ...this.#twins.values()]) {
      this.#yieldToWires(material);
    }
  }

  get wireframe(): boolean {
    return this.#wired;
  }

  /** Pictures by glTF material; null shows the textures. */
  setMaps(pictures: ReadonlyMap<number, MapPicture> | null): void {
    for (const texture of this.#maps?.values() ?? []) {
      texture.dispose();
    }
    this.#maps = pictures && new Map([...pictures].map(([index, picture]) => [index, this.#textureOf(index, picture)]));
    this.#dress();
  }

  /** Before a frame: the live textures may have changed places. */
  update(): void {
    if (this.#isFlat) {
      for (const [material, twin] of this.#twins) {
        this.#copyPicture(material, twin);
      }
    }
  }

  /** Draws the meshes' edges over the frame. The camera must see what else is in the scene by OVERLAY_LAYER alone. */
  drawWires(renderer: WebGLRenderer, scene: Scene, camera: Camera, color: Color, opacity: number): void {
    if (!this.#wired) {
      return;
    }
    this.#wires.color.copy(color);
    this.#wires.opacity = opacity;
    const { autoClear, shadowMap } = renderer;
    const shadows = shadowMap.autoUpdate;
    renderer.autoClear = false;
    camera.layers.set(MODEL_LAYER);
    scene.overrideMaterial = this.#wires;
    renderer.render(scene, camera);
    scene.overrideMaterial = null;
    camera.layers.enable(OVERLAY_LAYER);
    renderer.autoClear = autoClear;
    shadowMap.autoUpdate = shadows;
  }

  /** Gives the meshes their own materials back; to be called before the scene is freed. */
  dispose(): void {
    this.setMaps(null);
    this.unlit = false;
    for (const twin of this.#twins.values()) {
      twin.dispose();
    }
    this.#wires.dispose();
  }

  get #isFlat(): boolean {
    return this.#flat || this.#maps !== null;
  }

  #dress(): void {
    for (const [place, mesh] of this.#meshes.entries()) {
      const own = this.#own[place] as MeshStandardMaterial;
      mesh.material = this.#isFlat ? this.#twinOf(own) : own;
    }
    this.update();
  }

  #twinOf(material: MeshStandardMaterial): MeshBasicMaterial {
    let twin = this.#twins.get(material);
    if (twin === undefined) {
      const { side, transparent, alphaTest, depthWrite, vertexColors } = material;
      twin = new MeshBasicMaterial({ side, transparent, alphaTest, depthWrite, vertexColors, toneMapped: false });
      this.#twins.set(material, twin);
      this.#yieldToWires(twin);
    }
    return twin;
  }

  #copyPicture(material: MeshStandardMaterial, twin: MeshBasicMaterial): void {
    const map = this.#maps === null ? material.map : (this.#maps.get(this.#indexOf(material)) ?? null);
    if ((map === null) !== (twin.map === null)) {
      twin.needsUpdate = true;
    }
    twin.map = map;
    twin.opacity = material.opacity;
    if (this.#maps === null) {
      twin.color.copy(material.color);
    } else {
      twin.color.copy(map === null ? UNMAPPED : WHITE);
    }
  }

  #textureOf(index: number, { width, height, rgba }: MapPicture): DataTexture {
    const texture = new DataTexture(rgba as Uint8Array<ArrayBuffer>, width, height);
    layLike(texture, this.#scene.materials.get(index)?.[0]?.map ?? null);
    texture.magFilter = NearestFilter;
    texture.minFilter = LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }

  #indexOf(material: MeshStandardMaterial): number {
    for (const [index, materials] of this.#scene.materials) {
      if (materials.includes(material)) {
        return index;
      }
    }
    return -1;
  }

  /** Faces step back a little, or lines in their plane would flicker. */
  #yieldToWires(material: MeshStandardMaterial | MeshBasicMaterial): void {
    material.polygonOffset = this.#wired;
    material.polygonOffsetFactor = 1;
    material.polygonOffsetUnits = 1;
  }
}

const WHITE = new Color(1, 1, 1);

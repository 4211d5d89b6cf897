/**
 * Brings the core's layers of one target in line with a list: by id, with the fewest calls, so that only what changed
 * is projected again. The list is the truth; what the core has is derived from it.
 */
import { BlendSpaces, Blends, Filters, type LayerDef, LayerKinds, Occlusions, Projectors, Wraps } from "../core/abi.ts";
import type { ImageHandle } from "../core/session.ts";
import type { LayerHandle, Target } from "../core/target.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { BlendMode, EngineLayer, Projector } from "./engine-api.ts";

/** The ABI's numbers under the standard's names, which are hyphenated. */
const BLEND_NUMBERS: Readonly<Record<BlendMode, number>> = {
  ...Blends,
  "color-dodge": Blends.colorDodge,
  "color-burn": Blends.colorBurn,
  "hard-light": Blends.hardLight,
  "soft-light": Blends.softLight,
};

interface SyncedLayer {
  readonly id: string;
  readonly handle: LayerHandle;
  def: Partial<LayerDef>;
}

export class LayerSync {
  readonly #target: Target;
  /** Bottom to top, as the core has them. */
  #order: SyncedLayer[] = [];
  /** Layers that the core refused, so that each is reported once and not once a frame. */
  readonly #refused = new Map<string, Partial<LayerDef>>();

  constructor(target: Target) {
    this.#target = target;
  }

  /**
   * `layers` are this target's, bottom to top; `imageOf` gives the picture of an asset, undefined while it is unknown
   * (its layers wait). A layer that the core refuses is reported once and left out; a crash is thrown.
   */
  apply(
    layers: readonly EngineLayer[],
    imageOf: (asset: string) => ImageHandle | undefined,
    report: (error: TexelcastError) => void,
  ): void {
    const wanted = new Map<string, Partial<LayerDef>>();
    for (const layer of layers) {
      const image = layer.type === "decal" ? imageOf(layer.asset) : 0;
      if (image !== undefined) wanted.set(layer.id, coreLayer(layer, image));
    }
    this.#order = this.#order.filter((layer) => {
      if (wanted.has(layer.id)) return true;
      this.#target.destroyLayer(layer.handle);
      return false;
    });
    let index = 0;
    for (const [id, def] of wanted) {
      try {
        if (this.#place(id, def, index)) index++;
      } catch (error) {
        if (!(error instanceof TexelcastError) || error.code === "engine-crashed") throw error;
        this.#refuse(id, def, error, report);
      }
    }
  }

  /** Creates, changes and moves one layer as needed; false for one that was refused as it is. */
  #place(id: string, def: Partial<LayerDef>, index: number): boolean {
    const refused = this.#refused.get(id);
    if (refused !== undefined && sameDef(refused, def)) return false;
    const at = this.#order.findIndex((layer) => layer.id === id);
    const found = this.#order[at];
    if (found === undefined) {
      const handle = this.#target.createLayer(def);
      this.#order.push({ id, handle, def });
      this.#move(this.#order.length - 1, index);
    } else {
      if (!sameDef(found.def, def)) this.#target.updateLayer(found.handle, def);
      found.def = def;
      this.#move(at, index);
    }
    this.#refused.delete(id);
    return true;
  }

  #move(from: number, to: number): void {
    const layer = this.#order[from];
    if (layer === undefined || from === to) return;
    this.#target.moveLayer(layer.handle, to);
    this.#order.splice(from, 1);
    this.#order.splice(to, 0, layer);
  }

  #refuse(id: string, def: Partial<LayerDef>, error: TexelcastError, report: (error: TexelcastError) => void): void {
    this.#order = this.#order.filter((layer) => {
      if (layer.id === id) this.#target.destroyLayer(layer.handle);
      return layer.id !== id;
    });
    this.#refused.set(id, def);
    report(
      new TexelcastError(error.code, `The layer “${id}” cannot be drawn: ${error.message}`, {
        field: `layers[id=${id}]`,
        cause: error,
      }),
    );
  }
}

function coreLayer(layer: EngineLayer, image: ImageHandle): Partial<LayerDef> {
  const shared = {
    visible: Number(layer.visible),
    opacity: layer.opacity,
    blend: BLEND_NUMBERS[layer.blend],
    blendSpace: BlendSpaces[layer.blendSpace],
    lockAlpha: Number(layer.lockAlpha),
  };
  if (layer.type === "fill") return { ...shared, kind: LayerKinds.fill, color: layer.color };
  return {
    ...shared,
    kind: LayerKinds.decal,
    image,
    filter: Filters[layer.filter],
    wrap: Wraps[layer.wrap],
    flipX: Number(layer.flipX),
    flipY: Number(layer.flipY),
    backfaces: Number(layer.backfaces),
    angleFadeStart: layer.angleFade[0],
    angleFadeEnd: layer.angleFade[1],
    occlusion: Occlusions[layer.occlusion],
    ...coreProjector(layer.projector),
  };
}

function coreProjector(projector: Projector): Partial<LayerDef> {
  const kind = { projector: Projectors[projector.kind] };
  if (projector.kind === "uv") {
    const { center, size, angle } = projector;
    return { ...kind, uvCenter: center, uvSize: size, uvAngleDegrees: angle };
  }
  const posed = { ...kind, positionModel: projector.position, rotation: projector.rotation };
  if (projector.kind === "perspective") {
    const { fov, aspect, near, far } = projector;
    return { ...posed, fovDegrees: fov, aspect, nearDistance: near, farDistance: far };
  }
  if (projector.kind === "cylindrical") {
    const { radius, height, arc, depth } = projector;
    return { ...posed, radius, height, arcDegrees: arc, depth };
  }
  return { ...posed, size: projector.size };
}

function sameDef(a: Partial<LayerDef>, b: Partial<LayerDef>): boolean {
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]) as Set<keyof LayerDef>;
  return [...keys].every((key) => sameNumbers(a[key], b[key]));
}

function sameNumbers(a: number | readonly number[] | undefined, b: number | readonly number[] | undefined): boolean {
  if (typeof a !== "object" || typeof b !== "object") return Object.is(a, b);
  return a.length === b.length && a.every((number, i) => Object.is(number, b[i]));
}

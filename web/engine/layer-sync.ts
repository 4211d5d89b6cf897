/**
 * Brings the core's layers of one target in line with a list: by id, with the fewest calls, so that only what changed
 * is projected again. The list is the truth; what the core has is derived from it.
 */
import type { LayerDef } from "../core/abi.ts";
import type { ImageHandle } from "../core/session.ts";
import type { LayerHandle, Target } from "../core/target.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { coreDab, coreLayer } from "./core-layer.ts";
import type { EngineDab } from "./engine-api.ts";
import { pictureOf } from "./layer-picture.ts";
import type { EnginePaintingLayer } from "./layer-tree.ts";

/** What the core is told of a layer. */
interface WantedLayer {
  readonly def: Partial<LayerDef>;
  /** Of a stroke; none for the other kinds. */
  readonly dabs: readonly EngineDab[];
}

interface SyncedLayer {
  readonly id: string;
  readonly handle: LayerHandle;
  def: Partial<LayerDef>;
  dabs: readonly EngineDab[];
}

const NO_DABS: readonly EngineDab[] = [];

export class LayerSync {
  readonly #target: Target;
  /** Bottom to top, as the core has them. */
  #order: SyncedLayer[] = [];
  /** Layers that the core refused, so that each is reported once and not once a frame. */
  readonly #refused = new Map<string, WantedLayer>();

  constructor(target: Target) {
    this.#target = target;
  }

  /**
   * `layers` are this target's, bottom to top; `imageOf` gives the picture of an asset, undefined while it is unknown
   * (its layers wait). A layer that the core refuses is reported once and left out; a crash is thrown.
   */
  apply(
    layers: readonly EnginePaintingLayer[],
    imageOf: (asset: string) => ImageHandle | undefined,
    report: (error: TexelcastError) => void,
  ): void {
    const wanted = new Map<string, WantedLayer>();
    for (const layer of layers) {
      const picture = pictureOf(layer);
      // Words become pictures before they come here; those that could not yet, wait.
      const image = picture === null ? 0 : typeof picture === "string" ? imageOf(picture) : undefined;
      if (image === undefined) continue;
      const dabs = layer.type === "stroke" ? layer.dabs : NO_DABS;
      wanted.set(layer.id, { def: coreLayer(layer, image), dabs });
    }
    this.#order = this.#order.filter((layer) => {
      if (wanted.has(layer.id)) return true;
      this.#target.destroyLayer(layer.handle);
      return false;
    });
    let index = 0;
    for (const [id, layer] of wanted) {
      try {
        if (this.#place(id, layer, index)) index++;
      } catch (error) {
        if (!(error instanceof TexelcastError) || error.code === "engine-crashed") throw error;
        this.#refuse(id, layer, error, report);
      }
    }
  }

  /** Creates, changes and moves one layer as needed; false for one that was refused as it is. */
  #place(id: string, wanted: WantedLayer, index: number): boolean {
    const { def } = wanted;
    const refused = this.#refused.get(id);
    if (refused !== undefined && sameNumbersOf(refused.def, def) && sameDabs(refused.dabs, wanted.dabs)) return false;
    const at = this.#order.findIndex((layer) => layer.id === id);
    const found = this.#order[at];
    if (found === undefined) {
      const made: SyncedLayer = { id, handle: this.#target.createLayer(def), def, dabs: NO_DABS };
      this.#order.push(made);
      this.#syncDabs(made, wanted.dabs);
      this.#move(this.#order.length - 1, index);
    } else {
      if (found.def.kind !== def.kind) found.dabs = NO_DABS;
      if (!sameNumbersOf(found.def, def)) this.#target.updateLayer(found.handle, def);
      found.def = def;
      this.#syncDabs(found, wanted.dabs);
      this.#move(at, index);
    }
    this.#refused.delete(id);
    return true;
  }

  /** A stroke that grew is told of its new dabs alone; any other change begins it anew. */
  #syncDabs(layer: SyncedLayer, dabs: readonly EngineDab[]): void {
    let kept = commonDabs(layer.dabs, dabs);
    if (kept < layer.dabs.length) {
      this.#target.clearDabs(layer.handle);
      kept = 0;
    }
    if (kept < dabs.length) this.#target.addDabs(layer.handle, dabs.slice(kept).map(coreDab));
    layer.dabs = dabs;
  }

  #move(from: number, to: number): void {
    const layer = this.#order[from];
    if (layer === undefined || from === to) return;
    this.#target.moveLayer(layer.handle, to);
    this.#order.splice(from, 1);
    this.#order.splice(to, 0, layer);
  }

  #refuse(id: string, wanted: WantedLayer, error: TexelcastError, report: (error: TexelcastError) => void): void {
    this.#order = this.#order.filter((layer) => {
      if (layer.id === id) this.#target.destroyLayer(layer.handle);
      return layer.id !== id;
    });
    this.#refused.set(id, wanted);
    report(
      new TexelcastError(error.code, `The layer “${id}” cannot be drawn: ${error.message}`, {
        field: `layers[id=${id}]`,
        cause: error,
      }),
    );
  }
}

/** How many dabs two lists begin with alike. */
function commonDabs(a: readonly EngineDab[], b: readonly EngineDab[]): number {
  const most = Math.min(a.length, b.length);
  for (let i = 0; i < most; i++) {
    const [left, right] = [a[i], b[i]];
    // Lists that grow share their objects, so the numbers are seldom looked at.
    if (left === undefined || right === undefined) return i;
    if (left !== right && !sameNumbersOf(coreDab(left), coreDab(right))) return i;
  }
  return most;
}

const sameDabs = (a: readonly EngineDab[], b: readonly EngineDab[]): boolean =>
  a.length === b.length && commonDabs(a, b) === a.length;

type Numbers = Readonly<Record<string, number | readonly number[] | undefined>>;

function sameNumbersOf(a: Numbers, b: Numbers): boolean {
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].every((key) => sameNumbers(a[key], b[key]));
}

function sameNumbers(a: number | readonly number[] | undefined, b: number | readonly number[] | undefined): boolean {
  if (typeof a !== "object" || typeof b !== "object") return Object.is(a, b);
  return a.length === b.length && a.every((number, i) => Object.is(number, b[i]));
}

/** A stroke under way: shown in each frame, one step of the history when it ends. */

import type { MaterialInfo } from "../../engine/engine-api.ts";
import {
  type Brush,
  type Design,
  findLayer,
  freeIdIn,
  layerMaterials,
  type Mirror,
  makeStrokeLayer,
  mirroredProjector,
  type StrokeLayer,
} from "../document/index.ts";
import type { DecalReach } from "../state/decal-reach.ts";
import type { DesignSession } from "../state/design-session.ts";
import { DabChain, type DabChainOptions } from "./dab-chain.ts";
import type { PathStep } from "./pointer-path.ts";

/** What a brush does between its press and its release. */
export interface PaintGesture {
  extend(steps: readonly PathStep[]): void;
  /** It takes no more: what a stroke may hold is painted. */
  readonly full: boolean;
  /** Records what was painted as one step. */
  end(): void;
  cancel(): void;
}

export interface StrokeGestureOptions extends DabChainOptions {
  readonly brush: Brush;
  readonly name: string;
  readonly opacity: number;
  readonly erases: boolean;
  readonly mirror: Mirror | null;
  readonly alphaLock: boolean;
  /**
   * The design with the stroke where it goes, and the id of the layer that it belongs to; null while that cannot be told, and where
   * the design no longer has a place for it.
   */
  readonly put: (design: Design, stroke: StrokeLayer) => { readonly design: Design; readonly layerId: string } | null;
  readonly session: DesignSession;
  readonly reach: DecalReach;
}

export class StrokeGesture {
  readonly #options: StrokeGestureOptions;
  readonly #chain: DabChain;
  #id: string;
  /** The design of which it is known that no layer has its id: to look through it again in each frame takes a third of it where strokes are a thousand. */
  #free: Design;
  /** All that the stroke meets: over a border it paints both sides. */
  readonly #materials = new Set<number>();
  #firstMaterial: number | null = null;
  #frame = 0;

  constructor(options: StrokeGestureOptions) {
    this.#options = options;
    this.#chain = new DabChain(options);
    this.#free = options.session.recordedDesign;
    this.#id = freeIdIn(this.#free);
  }

  get full(): boolean {
    return this.#chain.full;
  }

  /** Indices of the materials that it has met so far. */
  get materials(): readonly number[] {
    return [...this.#materials];
  }

  /** The material of the part that it began on, where it met nothing that takes paint. */
  get bare(): MaterialInfo | null {
    const [dab] = this.#chain.dabs;
    if (this.#materials.size > 0 || !dab) return null;
    return this.#options.reach.bareOf(dab, false, this.#firstMaterial);
  }

  extend(steps: readonly PathStep[]): void {
    const { reach, mirror } = this.#options;
    for (const dab of this.#chain.extend(steps)) {
      const twin = mirror === null ? null : mirroredProjector(dab, mirror);
      for (const projector of twin === null ? [dab] : [dab, twin]) {
        for (const material of reach.all(projector, false)) this.#materials.add(material);
      }
    }
    this.#firstMaterial ??= steps.find((step) => step !== null)?.hit.material ?? null;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#show();
    });
  }

  /** Ends the stroke without recording it, and gives it; null when it painted nothing. */
  finish(): StrokeLayer | null {
    this.#stopFrame();
    if (this.#chain.dabs.length > 0 && this.bare === null) return this.#stroke(this.#options.session.recordedDesign);
    this.#options.session.cancelPreview();
    return null;
  }

  /** Records the stroke; the id of the layer that it became part of, null when it painted nothing or had no place to go. */
  end(label: string): string | null {
    const { session, put } = this.#options;
    const stroke = this.finish();
    const placed = stroke && put(session.recordedDesign, stroke);
    if (placed === null) {
      session.cancelPreview();
      return null;
    }
    session.record(placed.design, label);
    return placed.layerId;
  }

  cancel(): void {
    this.#stopFrame();
    this.#options.session.cancelPreview();
  }

  /** Shows the stroke as it is: `put` can tell now where it goes. */
  refresh(): void {
    this.#show();
  }

  #show(): void {
    const { session, put } = this.#options;
    if (this.#chain.dabs.length === 0) return;
    const design = session.recordedDesign;
    const placed = put(design, this.#stroke(design));
    if (placed !== null) session.preview(placed.design);
  }

  /** For a design that may have changed since the press: by what another finger did, or by a stroke that took its time. */
  #stroke(design: Design): StrokeLayer {
    if (design !== this.#free && findLayer(design, this.#id) !== undefined) this.#id = freeIdIn(design);
    this.#free = design;
    const { brush, name, opacity, erases, alphaLock, mirror } = this.#options;
    const materials = [...this.#materials].sort((a, b) => a - b);
    return makeStrokeLayer({
      id: this.#id,
      name,
      brush,
      opacity,
      blend: erases ? "erase" : "normal",
      lockAlpha: alphaLock,
      mirror,
      material: layerMaterials(materials.length > 0 ? materials : [this.#firstMaterial ?? 0]),
      dabs: this.#chain.dabs,
    });
  }

  #stopFrame(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }
}

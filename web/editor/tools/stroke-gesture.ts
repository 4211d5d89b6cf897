/** A stroke under way: shown in each frame, one step of the history when it ends. */
import {
  type Brush,
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
import { type PaintTarget, withStroke } from "./paint-target.ts";
import type { PathStep } from "./pointer-path.ts";

export interface StrokeGestureOptions extends DabChainOptions {
  readonly brush: Brush;
  readonly name: string;
  readonly opacity: number;
  readonly erases: boolean;
  readonly mirror: Mirror | null;
  readonly alphaLock: boolean;
  readonly target: PaintTarget;
  readonly session: DesignSession;
  readonly reach: DecalReach;
}

export class StrokeGesture {
  readonly #options: StrokeGestureOptions;
  readonly #chain: DabChain;
  readonly #id: string;
  /** All that the stroke meets: over a border it paints both sides. */
  readonly #materials = new Set<number>();
  #firstMaterial: number | null = null;
  #frame = 0;

  constructor(options: StrokeGestureOptions) {
    this.#options = options;
    this.#chain = new DabChain(options);
    this.#id = freeIdIn(options.session.recordedDesign);
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

  /** The id of the layer that the stroke became part of; null when it painted nothing. */
  end(label: string): string | null {
    this.#stopFrame();
    const { session, target } = this.#options;
    if (this.#chain.dabs.length === 0) {
      session.cancelPreview();
      return null;
    }
    const { design, layerId } = withStroke(session.recordedDesign, target, this.#stroke());
    session.record(design, label);
    return layerId;
  }

  cancel(): void {
    this.#stopFrame();
    this.#options.session.cancelPreview();
  }

  #show(): void {
    const { session, target } = this.#options;
    if (this.#chain.dabs.length === 0) return;
    session.preview(withStroke(session.recordedDesign, target, this.#stroke()).design);
  }

  #stroke(): StrokeLayer {
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

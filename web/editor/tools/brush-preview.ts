/** The brush's ring in both views: on the surface in one, as it lies in the texture in the other. */
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import type { ToolContext } from "./tool-context.ts";

export class BrushPreview {
  readonly #context: ToolContext;
  readonly #inner: () => number;
  #hit: SurfaceHit | null = null;

  /** `inner`: of the radius, where the brush begins to fade. */
  constructor(context: ToolContext, inner: () => number) {
    this.#context = context;
    this.#inner = inner;
  }

  show(hit: SurfaceHit | null): void {
    this.#hit = hit;
    this.refresh();
  }

  /** The brush has changed under a pointer that rests. */
  refresh(): void {
    const { viewer, textureView, tools, store } = this.#context;
    const hit = this.#hit;
    const { size } = tools.settings;
    if (hit === null || size === null) {
      viewer.setRing(null);
      textureView.setRing(null);
      return;
    }
    const radius = size / 2;
    const inner = this.#inner();
    viewer.setRing({ hit, radius, inner });
    const shown = hit.material === store.state.material;
    const radii = inner > 0 && inner < 1 ? [radius, radius * inner] : [radius];
    textureView.setRing(shown ? radii.map((part) => viewer.surface.circleInTexture(hit, part)) : null);
  }
}

/** The 2D view: a material's unfolded texture, live, with UV outlines over it. */
import type { TextureView } from "./viewer-api.ts";

export interface TextureViewOptions {
  /** Accessible name of the view; default "Texture". */
  readonly label?: string;
  /** The GPU lost a target's picture: give a full update again. */
  readonly onNeedsFullUpdate?: (material: number) => void;
}

/** Builds a texture view that fills `host`, which must have a size of its own. */
export function createTextureView(host: HTMLElement, options: TextureViewOptions = {}): TextureView {
  throw new Error(`The texture view "${options.label ?? ""}" in <${host.localName}> is being built.`);
}

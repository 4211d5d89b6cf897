/** The 3D view: the model, its live texture, picking and the decal gizmo, behind one interface. */
import type { ModelViewer } from "./viewer-api.ts";

export interface ModelViewerOptions {
  /** Accessible name of the view; default "3D view". */
  readonly label?: string;
}

/** Builds a viewer that fills `host`, which must have a size of its own. */
export function createModelViewer(host: HTMLElement, options: ModelViewerOptions = {}): ModelViewer {
  throw new Error(`The viewer "${options.label ?? ""}" in <${host.localName}> is being built.`);
}

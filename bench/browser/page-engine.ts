/** What the page asks of each contestant, and how a GPU's share is timed. */
import type { Picture } from "../../web/engine/engine-api.ts";
import type { DragStep, Run } from "../engines/engine.ts";
import type { BenchMesh } from "../work.ts";

export interface PageEngine {
  readonly name: string;
  /** Untimed: takes the mesh and the decal that the next steps are about. */
  load(mesh: BenchMesh, decal: Picture): Promise<void>;
  /** Untimed: makes ready for a texture of size x size. */
  prepare(size: number): Promise<void>;
  /** One step of a drag. */
  project(step: DragStep): Promise<Run>;
  /** RGBA of the newest step's texture, row 0 at the top, untimed; null where none is painted. */
  readTexture(): Promise<Uint8Array | null>;
  close(): void;
}

/**
 * Gives commands to the GPU, and reads one pixel of what they made in the next frame, which waits until it is there.
 * Gives back the page's own time in both, without the wait for the frame, and the time that the whole took.
 */
export async function timeWithGpu(
  give: () => void,
  readPixel: () => void,
): Promise<{ readonly milliseconds: number; readonly untilRead: number }> {
  const start = performance.now();
  give();
  const given = performance.now();
  await nextFrame();
  const frame = performance.now();
  readPixel();
  const end = performance.now();
  return { milliseconds: given - start + (end - frame), untilRead: end - start };
}

/** Of what is bound for reading. */
export function readOnePixel(gl: WebGL2RenderingContext): void {
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

export function nextFrame(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => resolve());
  });
}

/** Texels with any alpha: how many an engine painted that does not say so itself. */
export function countPainted(rgba: Uint8Array): number {
  let painted = 0;
  for (let at = 3; at < rgba.length; at += 4) if (rgba[at] > 0) painted++;
  return painted;
}

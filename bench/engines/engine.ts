/** What the benchmark asks of an engine: to do the same two steps on the same work. */
import type { Picture, PlanarProjector } from "../../web/engine/engine-api.ts";
import type { BenchMesh } from "../work.ts";

/** One timed run. `texels`: written or painted, by which the engines can be seen to do the same work. */
export interface Run {
  readonly milliseconds: number;
  readonly texels: number;
  /** Where a GPU takes part: from the start until a pixel of the result has been read, in the next frame. */
  readonly untilRead?: number;
}

/** One move of a drag. */
export interface DragStep {
  readonly projector: PlanarProjector;
  /** The plain method knows none, and paints through. */
  readonly occlusion: "none" | "self";
}

export interface BenchEngine {
  readonly name: string;
  /** Untimed: takes the mesh and the decal that the next runs are about. */
  load(mesh: BenchMesh, decal: Picture): Promise<void>;
  /** Bakes a map of size x size from nothing. */
  bake(size: number): Promise<Run>;
  /** Projects the decal over the newest bake's map, whose base is white. */
  project(step: DragStep): Promise<Run>;
  close(): void;
}

/**
 * Slides of decals that come into line: near to a plane that its middle can lie in, a decal goes onto it, and a line shows which.
 * Shift, which holds a slide to an axis of the view, and Ctrl or Cmd leave it where the pointer has it.
 */
import { Vector3 } from "three";
import type { PlanarProjector, Vec3 } from "../engine/engine-api.ts";
import { ALIGNMENT_REACH, type AlignmentLine, AlignmentLines } from "./alignment-lines.ts";
import {
  type AlignmentPlane,
  broughtOnto,
  chosenPlanes,
  planesOf,
  planesThrough,
  waysOnto,
} from "./alignment-planes.ts";
import type { ProjectorDrag } from "./box-drag.ts";
import { axisOf, type DecalPose, poseOf, projectorOf } from "./decal-pose.ts";
import { FreeKey } from "./free-key.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery } from "./surface-query.ts";
import type { ViewerDecal } from "./viewer-api.ts";

/** A plane of model space that a decal's middle can come to lie in; metres, the normal is unit. */
export interface ModelMiddle {
  readonly point: Vec3;
  readonly normal: Vec3;
}

/** What a decal that slides comes into line with. */
export interface Surroundings {
  readonly middles: readonly ModelMiddle[];
  readonly boxes: readonly PlanarProjector[];
}

/** Of the decal with this id; null: with nothing. */
export type FindSurroundings = (id: string) => Surroundings | null;

export class AlignedSlides {
  /** Asked when a slide has begun, and the editor knows what goes along. */
  find: FindSurroundings = () => null;
  readonly #lines: AlignmentLines;
  readonly #free: FreeKey;
  readonly #screen: ScreenSpace;
  readonly #query: () => SurfaceQuery | null;

  /** @param query the visible surface at rest; null while there is none, or the model is posed */
  constructor(root: HTMLElement, screen: ScreenSpace, query: () => SurfaceQuery | null) {
    this.#lines = new AlignmentLines(root);
    this.#free = new FreeKey(root);
    this.#screen = screen;
    this.#query = query;
  }

  /** The slide, with its steps brought into line. */
  over(slide: ProjectorDrag, { id }: ViewerDecal): ProjectorDrag {
    let planes: readonly AlignmentPlane[] | null = null;
    return {
      kind: slide.kind,
      get material() {
        return slide.material;
      },
      readout: (projector) => slide.readout(projector),
      move: (pointer) => {
        const projector = slide.move(pointer);
        planes ??= planesAround(this.find(id));
        const isFree = pointer.shift || this.#free.held || projector?.kind !== "planar";
        const aligned = isFree ? null : this.#aligned(poseOf(projector), planes);
        this.#lines.draw(aligned === null ? [] : this.#linesOf(aligned, planes));
        return aligned === null ? projector : projectorOf(aligned);
      },
    };
  }

  hideLines(): void {
    this.#lines.draw([]);
  }

  dispose(): void {
    this.#lines.dispose();
    this.#free.dispose();
  }

  /** Null where nothing is near. */
  #aligned(pose: DecalPose, planes: readonly AlignmentPlane[]): DecalPose | null {
    const query = this.#query();
    const chosen = this.#withinReach(planes, pose);
    if (query === null || chosen.length === 0) return null;
    // Where both cannot be had, the nearer one may.
    return (
      broughtOnto(query, pose, chosen) ?? (chosen.length > 1 ? broughtOnto(query, pose, chosen.slice(0, 1)) : null)
    );
  }

  #withinReach(planes: readonly AlignmentPlane[], pose: DecalPose): AlignmentPlane[] {
    const reach = ALIGNMENT_REACH * this.#screen.metresPerPixel(pose.position);
    const near = waysOnto(planes, pose).filter(({ way }) => way.length() <= reach);
    return chosenPlanes(
      near.sort((one, other) => one.way.length() - other.way.length()),
      pose,
    );
  }

  #linesOf(pose: DecalPose, planes: readonly AlignmentPlane[]): AlignmentLine[] {
    return planesThrough(planes, pose).flatMap((plane) => this.#lineOf(plane, pose));
  }

  /** From middle to middle; along a plane of the model's own, or where both middles lie in the decal, a little beyond it. */
  #lineOf({ normal, of }: AlignmentPlane, pose: DecalPose): AlignmentLine[] {
    const along = new Vector3().crossVectors(normal, axisOf(pose, 2)).normalize();
    const half = along.multiplyScalar(0.75 * Math.max(pose.size.x, pose.size.y));
    const other = of !== null && of.position.distanceTo(pose.position) > half.length() ? of.position : null;
    const from = other === null ? pose.position.clone().sub(half) : pose.position;
    const to = other ?? pose.position.clone().add(half);
    const [start, end] = [this.#screen.project(from), this.#screen.project(to)];
    return start && end ? [[start, end]] : [];
  }
}

export function middlePlane({ point, normal }: ModelMiddle): AlignmentPlane {
  return { point: new Vector3(...point), normal: new Vector3(...normal), of: null };
}

function planesAround(surroundings: Surroundings | null): AlignmentPlane[] {
  if (surroundings === null) return [];
  const { middles, boxes } = surroundings;
  return [...middles.map(middlePlane), ...boxes.flatMap((box) => planesOf(poseOf(box)))];
}

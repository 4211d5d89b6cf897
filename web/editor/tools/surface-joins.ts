/** Whether a brush that went from one place to another on the screen went over the surface, or jumped across a gap. */
import type { SurfaceHit, ToolSurface, Vec3 } from "../../viewer/viewer-api.ts";

/** Of the way between two places: how far from the surface its middle may lie. A sphere's quarter turn stays below. */
const MOST_SAG = 0.22;

/**
 * @param near metres within which two places are joined whatever lies between them: a dab is larger than that
 */
export function surfaceJoins(
  surface: Pick<ToolSurface, "near">,
  near: number,
): (a: SurfaceHit, b: SurfaceHit) => boolean {
  return (a, b) => {
    const way = distance(a.position, b.position);
    if (way <= near) return true;
    const middle = a.position.map((part, axis) => (part + (b.position[axis] as number)) / 2) as unknown as Vec3;
    const nearest = surface.near(middle);
    return nearest !== null && distance(nearest.position, middle) <= MOST_SAG * way;
  };
}

const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

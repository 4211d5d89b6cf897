/** What an eye sees of the resting model: for each pixel of its picture, which place of which texture. */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { PerspectiveProjector } from "../engine/engine-api.ts";
import { DOUBLE_SIDED, type RestingSurface } from "./resting-surface.ts";

/** Row by row from the top. */
export interface SurfaceSight {
  readonly width: number;
  readonly height: number;
  /** glTF material index; -1 beside the model. */
  readonly materials: Int32Array;
  /** Two numbers a pixel: texture coordinates as the model has them, not wrapped. */
  readonly uvs: Float32Array;
}

type Corner = readonly [x: number, y: number, z: number];

/**
 * Casts one ray through the middle of each pixel. A ray from the eye meets a triangle where it lies on one side of all three
 * planes through the eye and an edge, so that triangles need not be cut where they reach behind it.
 */
export function seenFrom(
  surface: Pick<RestingSurface, "positions" | "uvs" | "index" | "materialOfTriangle" | "flagsOfTriangle">,
  eye: PerspectiveProjector,
  width: number,
  height: number,
): SurfaceSight {
  const materials = new Int32Array(width * height).fill(-1);
  const uvs = new Float32Array(width * height * 2);
  const depths = new Float64Array(width * height).fill(eye.far);
  const halfHeight = Math.tan((eye.fov * Math.PI) / 360);
  const halfWidth = halfHeight * eye.aspect;
  const toEye = new Matrix4()
    .compose(new Vector3(...eye.position), new Quaternion(...eye.rotation).normalize(), new Vector3(1, 1, 1))
    .invert();
  const seen = new Float64Array(surface.positions.length);
  const point = new Vector3();
  for (let at = 0; at < seen.length; at += 3) {
    point
      .fromArray(surface.positions, at)
      .applyMatrix4(toEye)
      .toArray(seen as unknown as number[], at);
  }
  const cornerOf = (vertex: number): Corner => [
    seen[vertex * 3] as number,
    seen[vertex * 3 + 1] as number,
    seen[vertex * 3 + 2] as number,
  ];
  for (let triangle = 0; triangle < surface.materialOfTriangle.length; triangle++) {
    const vertices = [...surface.index.subarray(triangle * 3, triangle * 3 + 3)] as [number, number, number];
    const [a, b, c] = vertices.map(cornerOf) as [Corner, Corner, Corner];
    const edges = [cross(b, c), cross(c, a), cross(a, b)] as const;
    const volume = dot(a, edges[0]);
    const isBack = volume > 0;
    if (volume === 0 || (isBack && ((surface.flagsOfTriangle[triangle] ?? 0) & DOUBLE_SIDED) === 0)) continue;
    const [left, right] = rangeOf([a, b, c], 0, halfWidth, width);
    const [bottom, top] = rangeOf([a, b, c], 1, halfHeight, height);
    const [first, second, third] = edges;
    for (let y = height - 1 - top; y <= height - 1 - bottom; y++) {
      const up = (1 - (2 * y + 1) / height) * halfHeight;
      for (let x = left; x <= right; x++) {
        const aside = ((2 * x + 1) / width - 1) * halfWidth;
        const shareA = (aside * first[0] + up * first[1] - first[2]) / volume;
        const shareB = (aside * second[0] + up * second[1] - second[2]) / volume;
        const shareC = (aside * third[0] + up * third[1] - third[2]) / volume;
        if (shareA < 0 || shareB < 0 || shareC < 0) continue;
        const depth = 1 / (shareA + shareB + shareC);
        const pixel = y * width + x;
        if (!(depth >= eye.near && depth < (depths[pixel] as number))) continue;
        depths[pixel] = depth;
        materials[pixel] = surface.materialOfTriangle[triangle] as number;
        for (const axis of [0, 1]) {
          const uvOf = (corner: 0 | 1 | 2): number => surface.uvs[vertices[corner] * 2 + axis] as number;
          uvs[pixel * 2 + axis] = (uvOf(0) * shareA + uvOf(1) * shareB + uvOf(2) * shareC) * depth;
        }
      }
    }
  }
  return { width, height, materials, uvs };
}

/** The pixels that a triangle can cover along an axis, from low to high; all where a corner is not before the eye. */
function rangeOf(corners: readonly Corner[], axis: 0 | 1, half: number, pixels: number): [number, number] {
  if (corners.some(([, , z]) => z > -1e-9)) return [0, pixels - 1];
  const places = corners.map((corner) => ((corner[axis] / -corner[2] / half + 1) / 2) * pixels - 0.5);
  return [Math.max(0, Math.ceil(Math.min(...places))), Math.min(pixels - 1, Math.floor(Math.max(...places)))];
}

const cross = (a: Corner, b: Corner): Corner => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a: Corner, b: Corner): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

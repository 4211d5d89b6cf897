/** A creature as scans and sculpts come: a body and thin legs that cross it, a soup of triangles without normals or coordinates. */
import { Quaternion, Vector3 } from "three";
import type { MeshParts } from "./model-builder.ts";

/** Three corners. */
export type Face = readonly [Vector3, Vector3, Vector3];

const AROUND = 8;
const LEG = 0.05;

/** Poles are triangles without area. */
function body(): Face[] {
  const at = (u: number, v: number): Vector3 => {
    const [down, round] = [(Math.PI * v) / AROUND, (Math.PI * u) / AROUND];
    return new Vector3(
      0.6 * Math.sin(down) * Math.cos(round),
      1 + 0.45 * Math.cos(down),
      -0.8 * Math.sin(down) * Math.sin(round),
    );
  };
  return Array.from({ length: AROUND * AROUND * 2 }, (_, i): Face[] => {
    const [u, v] = [i % (2 * AROUND), Math.floor(i / (2 * AROUND))];
    const [a, b, c, d] = [at(u, v), at(u, v + 1), at(u + 1, v + 1), at(u + 1, v)];
    return [
      [a, b, c],
      [a, c, d],
    ];
  }).flat();
}

function leg(side: number, z: number): Face[] {
  const path = [
    new Vector3(side * 0.4, 1, z),
    new Vector3(side, 1.6, z * 1.5),
    new Vector3(side * 1.6, 1.5, z * 2),
    new Vector3(side * 2.2, 0, z * 2.6),
  ] as const;
  const rings = path.map((point, i) => {
    const along = (path[Math.min(3, i + 1)] as Vector3)
      .clone()
      .sub(path[Math.max(0, i - 1)] as Vector3)
      .normalize();
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), along);
    return Array.from({ length: AROUND }, (_, k) => {
      const angle = (2 * Math.PI * k) / AROUND;
      return new Vector3(LEG * Math.cos(angle), LEG * Math.sin(angle), 0).applyQuaternion(turn).add(point);
    });
  });
  return rings.slice(1).flatMap((ring, i) =>
    ring.flatMap((_, k): Face[] => {
      const next = (k + 1) % AROUND;
      const [a, b] = [rings[i]?.[k] as Vector3, rings[i]?.[next] as Vector3];
      const [c, d] = [ring[next] as Vector3, ring[k] as Vector3];
      return [
        [a, b, c],
        [a, c, d],
      ];
    }),
  );
}

export const creature = (): Face[] => [...body(), ...[-0.3, 0, 0.3, 0.6].flatMap((z) => [...leg(1, z), ...leg(-1, z)])];

export const turnedOver = (faces: readonly Face[]): Face[] => faces.map(([a, b, c]) => [a, c, b]);

export const soupOf = (faces: readonly Face[]): MeshParts => ({
  positions: faces.flatMap((face) => face.flatMap((corner) => corner.toArray())),
  material: 0,
});

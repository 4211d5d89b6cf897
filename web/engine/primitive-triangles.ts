/** The triangles of a primitive, whatever its mode lists them as (glTF 2.0, 3.7.2.1). */
import type { Accessors } from "./accessors.ts";
import { badContainer, indexAt, type JsonObject } from "./gltf-json.ts";

const TRIANGLES = 4;
const STRIP = 5;
const FAN = 6;

/** Points and lines are not. */
export function isOfTriangles(primitive: JsonObject): boolean {
  const mode = indexAt(primitive, "mode") ?? TRIANGLES;
  return mode >= TRIANGLES && mode <= FAN;
}

/** Three vertices each. Throws "bad-container" for a vertex beyond the last. */
export function trianglesOf(
  primitive: JsonObject,
  vertexCount: number,
  accessors: Accessors,
  name: string,
): Uint32Array {
  const index = indexAt(primitive, "indices");
  const listed =
    index === undefined ? Uint32Array.from({ length: vertexCount }, (_, i) => i) : accessors.readNumbers(index);
  if (listed.some((vertex) => vertex >= vertexCount)) {
    throw badContainer(name, `“accessors[${index}]” names a vertex beyond the last`, `accessors[${index}]`);
  }
  const mode = indexAt(primitive, "mode") ?? TRIANGLES;
  if (mode === TRIANGLES) return Uint32Array.from(listed.subarray(0, listed.length - (listed.length % 3)));
  const triangles: number[] = [];
  for (let i = 0; i + 2 < listed.length; i++) {
    const corners = mode === STRIP ? [i, i + 1 + (i % 2), i + 2 - (i % 2)] : [i + 1, i + 2, 0];
    triangles.push(...corners.map((corner) => listed[corner] as number));
  }
  return Uint32Array.from(triangles);
}

import { BoxGeometry, type BufferGeometry, CylinderGeometry, PlaneGeometry, SphereGeometry, Vector3 } from "three";
import type { PlanarProjector } from "../../web/engine/engine-api.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import { SurfaceQuery } from "../../web/viewer/surface-query.ts";
import type { SurfaceHit } from "../../web/viewer/viewer-api.ts";

/** A query on three's own shapes, which are of material 0 and single-sided. */
export function queryOf(...geometries: BufferGeometry[]): SurfaceQuery {
  const parts = geometries.map((geometry) => ({
    positions: [...geometry.getAttribute("position").array],
    normals: [...geometry.getAttribute("normal").array],
    uvs: [...geometry.getAttribute("uv").array],
    index: [...(geometry.index?.array ?? [])],
  }));
  let first = 0;
  const index = parts.flatMap((part) => {
    const shifted = part.index.map((vertex) => vertex + first);
    first += part.positions.length / 3;
    return shifted;
  });
  return new SurfaceQuery({
    positions: Float32Array.from(parts.flatMap((part) => part.positions)),
    normals: Float32Array.from(parts.flatMap((part) => part.normals)),
    uvs: Float32Array.from(parts.flatMap((part) => part.uvs)),
    index: Uint32Array.from(index),
    materialOfTriangle: new Uint32Array(index.length / 3),
    flagsOfTriangle: new Uint8Array(index.length / 3),
    meshOfTriangle: new Uint32Array(index.length / 3),
    faceOfTriangle: Uint32Array.from({ length: index.length / 3 }, (_, triangle) => triangle),
  });
}

/** Two metres high, radius 1, standing on its middle. */
export function cylinder(): BufferGeometry {
  return new CylinderGeometry(1, 1, 2, 96, 24);
}

export function sphere(): BufferGeometry {
  return new SphereGeometry(1, 96, 64);
}

/** Two metres wide. */
export function cube(): BufferGeometry {
  return new BoxGeometry(2, 2, 2, 8, 8, 8);
}

/** Faces +Z, two metres wide. */
export function sheet(): BufferGeometry {
  return new PlaneGeometry(2, 2, 8, 8);
}

/** Lays boxes onto a surface as a camera before it (+Z) does: upright. */
export function placedFromFront(query: SurfaceQuery) {
  const axes = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
  return (hit: Pick<SurfaceHit, "position" | "normal">, width: number, aspect: number): PlanarProjector => {
    const place = { position: new Vector3(...hit.position), normal: new Vector3(...hit.normal) };
    return projectorOf(placeOnSurface(query, place, width, aspect, axes, null));
  };
}

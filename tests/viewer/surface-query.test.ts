import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { DOUBLE_SIDED, FACETED } from "../../web/viewer/resting-surface.ts";
import { SurfaceQuery, type SurfaceSample } from "../../web/viewer/surface-query.ts";
import { expectVector } from "./pose-helpers.ts";
import { cube, queryOf, sheet, sphere } from "./surface-helpers.ts";

const BACK = new Vector3(0, 0, -1);

/** One triangle in the plane z = 0 that faces +Z, with normals that lean. */
function triangle(flags: number): SurfaceQuery {
  return new SurfaceQuery({
    positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
    normals: new Float32Array([0, 0, 1, 0.6, 0, 0.8, 0, 0, 1]),
    uvs: new Float32Array([0, 0, 2, 0, 0, 4]),
    index: new Uint32Array([0, 1, 2]),
    materialOfTriangle: new Uint32Array([7]),
    flagsOfTriangle: new Uint8Array([flags]),
    meshOfTriangle: new Uint32Array(64),
    faceOfTriangle: new Uint32Array(64),
  });
}

describe("a ray to the resting surface", () => {
  it("meets the nearest triangle that looks against it", () => {
    const hit = queryOf(sphere()).raycast(new Vector3(0, 0, 5), BACK);
    expectVector(hit?.position as Vector3, new Vector3(0, 0, 1), 1e-3);
    expect(hit?.distance).toBeCloseTo(4, 3);
    expectVector(hit?.normal as Vector3, new Vector3(0, 0, 1), 1e-2);
  });

  it("passes through the back of a single-sided surface", () => {
    expect(triangle(0).raycast(new Vector3(0.2, 0.2, -1), new Vector3(0, 0, 1))).toBeNull();
    expect(queryOf(sphere()).raycast(new Vector3(0, 0, 0), BACK)).toBeNull();
  });

  it("stops at the back of a double-sided surface, and gives its true normal", () => {
    const hit = triangle(DOUBLE_SIDED).raycast(new Vector3(0.2, 0.2, -1), new Vector3(0, 0, 1));
    expect(hit?.normal.z).toBeGreaterThan(0.9);
  });

  it("interpolates normal and texture coordinates, and knows the material", () => {
    const hit = triangle(0).raycast(new Vector3(0.5, 0.25, 1), BACK) as SurfaceSample;
    expect(hit.uv[0]).toBeCloseTo(1, 6);
    expect(hit.uv[1]).toBeCloseTo(1, 6);
    expect(hit.material).toBe(7);
    expectVector(hit.normal, new Vector3(0.3, 0, 0.9).normalize(), 1e-6);
  });

  it("takes the face's normal where the mesh has none of its own", () => {
    const hit = triangle(FACETED).raycast(new Vector3(0.5, 0.25, 1), BACK);
    expectVector(hit?.normal as Vector3, new Vector3(0, 0, 1), 1e-9);
  });

  it("tells how far the surface is where nothing else of it is asked for", () => {
    expect(queryOf(sphere()).distanceAlong(new Vector3(0, 0, 5), BACK, 10)).toBeCloseTo(4, 3);
    expect(queryOf(sphere()).distanceAlong(new Vector3(0, 0, 5), BACK, 3)).toBeNull();
    expect(triangle(0).distanceAlong(new Vector3(0.2, 0.2, -1), new Vector3(0, 0, 1), 10)).toBeNull();
  });

  it("meets nothing in a model without triangles", () => {
    const empty = queryOf();
    expect(empty.raycast(new Vector3(0, 0, 5), BACK)).toBeNull();
    expect(empty.closest(new Vector3())).toBeNull();
  });
});

describe("what lies between", () => {
  it("is clear as far as the surface itself", () => {
    const query = queryOf(sphere());
    expect(query.isClear(new Vector3(0, 0, 5), new Vector3(0, 0, 1))).toBe(true);
  });

  it("is not clear behind the model", () => {
    const query = queryOf(sphere());
    expect(query.isClear(new Vector3(0, 0, 5), new Vector3(0, 0, -1))).toBe(false);
  });
});

describe("the averaged normal", () => {
  it("is the sphere's own on a sphere", () => {
    const query = queryOf(sphere());
    const direction = new Vector3(1, 2, 3).normalize();
    const place = query.raycast(direction.clone().multiplyScalar(4), direction.clone().negate()) as SurfaceSample;
    expect(query.smoothNormal(place, 0.3).angleTo(direction)).toBeLessThan(0.02);
  });

  it("leans over an edge before the edge is reached, and changes there without a jump", () => {
    const query = queryOf(cube());
    const normalAt = (x: number, z: number) =>
      query.smoothNormal(query.closest(new Vector3(x, 0.1, z)) as SurfaceSample, 0.3);
    const middle = normalAt(0, 1);
    const nearEdge = normalAt(0.85, 1);
    expect(middle.z).toBeCloseTo(1, 6);
    expect(nearEdge.x).toBeGreaterThan(0.1);
    const before = normalAt(0.999, 1);
    const after = normalAt(1, 0.999);
    expect(before.angleTo(after)).toBeLessThan(0.35);
  });

  it("is the same from wherever the drag has come", () => {
    const cubes = queryOf(cube());
    const ball = queryOf(sphere());
    for (const [query, ends] of [
      [cubes, [new Vector3(1, 0.1, 0.999), new Vector3(-0.2, 1, 0.9)]],
      [ball, [new Vector3(1, 0.1, 0), new Vector3(-0.2, -0.7, 0.9)]],
    ] as const) {
      const places = ends.map((end) => query.closest(end) as SurfaceSample);
      const fresh = places.map((place) => query.smoothNormal(place, 0.3));
      for (let step = 0; step < 20; step++) {
        const along = (places[0] as SurfaceSample).position
          .clone()
          .lerp((places[1] as SurfaceSample).position, step / 20);
        query.smoothNormal(query.closest(along) as SurfaceSample, 0.3);
      }
      for (const [index, place] of places.entries()) {
        expect(query.smoothNormal(place, 0.3).toArray()).toEqual(fresh[index]?.toArray());
      }
    }
  });

  it("does not count the other side of a thin wall", () => {
    const wall = cube();
    wall.scale(1, 1, 0.01);
    const query = queryOf(wall);
    const place = query.raycast(new Vector3(0, 0, 5), BACK) as SurfaceSample;
    expect(query.smoothNormal(place, 0.4).z).toBeGreaterThan(0.999);
  });

  it("does not count another part of the model that is close by", () => {
    const shelf = cube();
    shelf.scale(0.5, 0.1, 0.5);
    shelf.translate(0, 0.3, 0.6);
    const query = queryOf(sheet(), shelf);
    const place = query.closest(new Vector3(0, 0, 0)) as SurfaceSample;
    expectVector(query.smoothNormal(place, 0.4), new Vector3(0, 0, 1), 1e-6);
  });
});

import { describe, expect, it } from "vitest";
import type { Projector } from "../../web/engine/engine-api.ts";
import { type ReachVolume, reachVolume } from "../../web/viewer/reached-materials.ts";
import { SurfaceQuery } from "../../web/viewer/surface-query.ts";

/** Squares of one metre, each of the material of its place in the list, at these places; they face +Z or, turned, -Z. */
function squares(...places: readonly { at: readonly [number, number, number]; turned?: boolean }[]): SurfaceQuery {
  const corners = [
    [-0.5, -0.5],
    [0.5, -0.5],
    [0.5, 0.5],
    [-0.5, 0.5],
  ] as const;
  return new SurfaceQuery({
    positions: Float32Array.from(
      places.flatMap(({ at: [x, y, z] }) => corners.flatMap(([dx, dy]) => [x + dx, y + dy, z])),
    ),
    normals: new Float32Array(places.length * 12),
    uvs: new Float32Array(places.length * 8),
    index: Uint32Array.from(
      places.flatMap(({ turned }, square) =>
        (turned ? [0, 2, 1, 0, 3, 2] : [0, 1, 2, 0, 2, 3]).map((vertex) => 4 * square + vertex),
      ),
    ),
    materialOfTriangle: Uint32Array.from(places.flatMap((_, square) => [square, square])),
    flagsOfTriangle: new Uint8Array(places.length * 2),
    meshOfTriangle: new Uint32Array(64),
    faceOfTriangle: new Uint32Array(64),
  });
}

const box = (x: number, size = 0.4): Projector => ({
  kind: "planar",
  position: [x, 0, 0],
  rotation: [0, 0, 0, 1],
  size: [size, 0.4, 0.2],
});

function reached(query: SurfaceQuery, projector: Projector, backfaces = false): number[] {
  const volume = reachVolume(projector, backfaces);
  return volume === null ? [] : query.materialsWithin(volume);
}

describe("the materials that a decal reaches", () => {
  const pair = squares({ at: [-0.5, 0, 0] }, { at: [0.5, 0, 0] });

  it("are those of both sides of a border that it lies over, and of one side elsewhere", () => {
    expect(reached(pair, box(-0.5))).toEqual([0]);
    expect(reached(pair, box(0.1))).toEqual([0, 1]);
    expect(reached(pair, box(0.5))).toEqual([1]);
    expect(reached(pair, box(5))).toEqual([]);
  });

  it("are found where the decal lies wholly within a triangle, far from its corners", () => {
    expect(reached(pair, box(-0.3, 0.001))).toEqual([0]);
  });

  it("leave out what lies before or behind the box", () => {
    expect(reached(squares({ at: [0, 0, 0] }, { at: [0, 0, 0.2] }, { at: [0, 0, -0.2] }), box(0))).toEqual([0]);
  });

  it("leave out what its corner misses, though the boxes around both overlap", () => {
    const turned: Projector = {
      kind: "planar",
      position: [0, 0, 0],
      rotation: [0, 0, Math.sin(Math.PI / 8), Math.cos(Math.PI / 8)],
      size: [0.4, 0.4, 0.2],
    };
    const nearCorner = squares({ at: [0, 0, 0] }, { at: [0.66, 0.66, 0] });
    expect(reached(nearCorner, turned)).toEqual([0]);
  });

  it("leave out surfaces that look away, except for a decal that paints back faces", () => {
    const plate = squares({ at: [0, 0, 0.01] }, { at: [0, 0, -0.01], turned: true });
    expect(reached(plate, box(0))).toEqual([0]);
    expect(reached(plate, box(0), true)).toEqual([0, 1]);
  });

  it("are those that an eye sees in its frame between near and far", () => {
    const eye: Projector = {
      kind: "perspective",
      position: [-0.3, 0, 1],
      rotation: [0, 0, 0, 1],
      fov: 30,
      aspect: 1,
      near: 0.5,
      far: 2,
    };
    expect(reached(pair, eye)).toEqual([0]);
    expect(reached(pair, { ...eye, aspect: 2 } as Projector)).toEqual([0, 1]);
    expect(reached(pair, { ...eye, near: 1.2 } as Projector)).toEqual([]);
    expect(reached(pair, { ...eye, position: [0, 0, -1], rotation: [0, 1, 0, 0] } as Projector)).toEqual([]);
  });

  it("are those in a label's bounding box that look outward", () => {
    const label: Projector = {
      kind: "cylindrical",
      position: [0, 0, -1],
      rotation: [0, 0, 0, 1],
      radius: 1,
      height: 0.4,
      arc: 40,
      depth: 0.1,
    };
    expect(reached(pair, label)).toEqual([0, 1]);
    expect(reached(pair, { ...label, position: [-0.5, 0, -1] } as Projector)).toEqual([0]);
    expect(reached(pair, { ...label, position: [0, 2, -1] } as Projector)).toEqual([]);
    expect(reached(squares({ at: [0, 0, 0], turned: true }), label)).toEqual([]);
  });

  it("are found each, also where a model has more than fit in a word", () => {
    const many = squares(...Array.from({ length: 70 }, (_, place) => ({ at: [place, 0, 0] as const })));
    const all = Array.from({ length: 70 }, (_, place) => place);
    expect(reached(many, box(34.5, 80))).toEqual(all);
    expect(reached(many, box(34.5, 10))).toEqual(all.slice(29, 41));
  });

  it("are not looked for where only those lie that are found", () => {
    const at = Array.from({ length: 4000 }, (_, place) => [place % 60, Math.floor(place / 60), 0] as const);
    const field = squares(...at.map((each) => ({ at: each })));
    // Two materials in turns, and one that lies apart.
    field.surface.materialOfTriangle.forEach((_, triangle) => {
      field.surface.materialOfTriangle[triangle] = triangle === 0 ? 2 : Math.floor(triangle / 2) % 2;
    });
    const query = new SurfaceQuery(field.surface);
    const volume = reachVolume({ ...box(35), size: [40, 200, 0.2] } as Projector, false) as ReachVolume;
    let looks = 0;
    const counted: ReachVolume = {
      touchesBox: (bounds) => {
        looks += 1;
        return volume.touchesBox(bounds);
      },
      reachesTriangle: (triangle) => volume.reachesTriangle(triangle),
    };
    expect(query.materialsWithin(counted)).toEqual([0, 1]);
    expect(looks).toBeLessThan(100);
  });

  it("are not asked of a flat stamp, which lies in the texture", () => {
    expect(reachVolume({ kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 }, false)).toBeNull();
  });
});

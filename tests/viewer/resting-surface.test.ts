import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Skeleton,
  SkinnedMesh,
  Texture,
  Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import type { ModelScene } from "../../web/viewer/model-scene.ts";
import { DOUBLE_SIDED, FACETED, gatherRestingSurface, type RestingSurface } from "../../web/viewer/resting-surface.ts";
import { expectVector } from "./pose-helpers.ts";

function sceneOf(...meshes: Mesh[]): ModelScene {
  const root = new Group();
  const materials = new Map<number, MeshStandardMaterial[]>();
  for (const [index, mesh] of meshes.entries()) {
    root.add(mesh);
    materials.set(index, [mesh.material as MeshStandardMaterial]);
  }
  return { root, animations: [], materials, labels: new Map(), dispose: () => {} };
}

function triangleGeometry(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 3));
  geometry.setAttribute("normal", new BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]), 3));
  geometry.setAttribute("uv", new BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1]), 2));
  return geometry;
}

function vertexOf(surface: RestingSurface, vertex: number): Vector3 {
  return new Vector3().fromArray(surface.positions, vertex * 3);
}

/** The direction in which a triangle's corners run anticlockwise. */
function windingOf(surface: RestingSurface, triangle: number): Vector3 {
  const [a, b, c] = [0, 1, 2].map((corner) => vertexOf(surface, surface.index[triangle * 3 + corner] as number));
  return (b as Vector3)
    .clone()
    .sub(a as Vector3)
    .cross((c as Vector3).clone().sub(a as Vector3))
    .normalize();
}

describe("the resting surface", () => {
  it("is in model space: node transforms are applied to positions and normals", () => {
    const mesh = new Mesh(triangleGeometry(), new MeshStandardMaterial());
    mesh.position.set(0, 5, 0);
    mesh.rotation.y = Math.PI / 2;
    mesh.scale.setScalar(2);
    const surface = gatherRestingSurface(sceneOf(mesh));
    expectVector(vertexOf(surface, 1), new Vector3(0, 5, -2), 1e-6);
    expectVector(new Vector3().fromArray(surface.normals), new Vector3(1, 0, 0), 1e-6);
  });

  it("keeps the outside outside in a mirrored node", () => {
    const mesh = new Mesh(triangleGeometry(), new MeshStandardMaterial());
    mesh.scale.set(-1, 1, 1);
    const surface = gatherRestingSurface(sceneOf(mesh));
    expectVector(windingOf(surface, 0), new Vector3(0, 0, 1), 1e-6);
    expectVector(new Vector3().fromArray(surface.normals), new Vector3(0, 0, 1), 1e-6);
  });

  it("places a skinned mesh by its joints alone, whatever its own node says", () => {
    const geometry = triangleGeometry();
    geometry.setAttribute("skinIndex", new BufferAttribute(new Uint16Array(12), 4));
    geometry.setAttribute("skinWeight", new BufferAttribute(new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]), 4));
    const bone = new Bone();
    bone.position.set(0, 3, 0);
    const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial());
    mesh.position.set(100, 0, 0);
    const scene = sceneOf(mesh);
    scene.root.add(bone);
    scene.root.updateMatrixWorld(true);
    mesh.bind(new Skeleton([bone], [new Matrix4().makeTranslation(0, 0, 1)]), new Matrix4());
    const surface = gatherRestingSurface(scene);
    expectVector(vertexOf(surface, 1), new Vector3(1, 3, 1), 1e-6);
  });

  it("turns round those triangles alone whose own joint mirrors", () => {
    const geometry = new BufferGeometry();
    const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([...corners, ...corners]), 3));
    const joints = new Uint16Array(24);
    for (let vertex = 3; vertex < 6; vertex++) joints[vertex * 4] = 1;
    geometry.setAttribute("skinIndex", new BufferAttribute(joints, 4));
    const weights = Float32Array.from({ length: 24 }, (_, i) => Number(i % 4 === 0));
    geometry.setAttribute("skinWeight", new BufferAttribute(weights, 4));
    const mirror = new Bone();
    mirror.scale.x = -1;
    const bones = [new Bone(), mirror];
    const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial());
    const scene = sceneOf(mesh);
    scene.root.add(...bones);
    scene.root.updateMatrixWorld(true);
    mesh.bind(new Skeleton(bones, [new Matrix4(), new Matrix4()]), new Matrix4());
    const surface = gatherRestingSurface(scene);
    for (const triangle of [0, 1]) expectVector(windingOf(surface, triangle), new Vector3(0, 0, 1), 1e-6);
  });

  it("applies morph targets at their default weights", () => {
    const geometry = triangleGeometry();
    geometry.morphAttributes.position = [new BufferAttribute(new Float32Array([0, 0, 2, 0, 0, 2, 0, 0, 2]), 3)];
    geometry.morphTargetsRelative = true;
    const mesh = new Mesh(geometry, new MeshStandardMaterial());
    mesh.morphTargetInfluences = [0.25];
    expectVector(vertexOf(gatherRestingSurface(sceneOf(mesh)), 0), new Vector3(0, 0, 0.5), 1e-6);
  });

  it("takes the texture coordinates that the picture names, texture transform applied", () => {
    const geometry = triangleGeometry();
    geometry.setAttribute("uv1", new BufferAttribute(new Float32Array([0.5, 0.5, 0.5, 0.5, 0.5, 0.5]), 2));
    const map = new Texture();
    map.channel = 1;
    map.repeat.set(2, 4);
    map.offset.set(0.1, 0);
    const surface = gatherRestingSurface(sceneOf(new Mesh(geometry, new MeshStandardMaterial({ map }))));
    expect(surface.uvs[0]).toBeCloseTo(1.1, 6);
    expect(surface.uvs[1]).toBeCloseTo(2, 6);
  });

  it("knows material, sides and facets of each triangle, over several meshes", () => {
    const faceted = triangleGeometry();
    faceted.deleteAttribute("normal");
    const surface = gatherRestingSurface(
      sceneOf(
        new Mesh(new BoxGeometry(), new MeshStandardMaterial()),
        new Mesh(faceted, new MeshStandardMaterial({ side: DoubleSide })),
      ),
    );
    expect(surface.materialOfTriangle).toHaveLength(13);
    expect([surface.materialOfTriangle[0], surface.materialOfTriangle[12]]).toEqual([0, 1]);
    expect([surface.flagsOfTriangle[0], surface.flagsOfTriangle[12]]).toEqual([0, DOUBLE_SIDED | FACETED]);
    expectVector(vertexOf(surface, surface.index[36 + 1] as number), new Vector3(1, 0, 0), 1e-6);
  });
});

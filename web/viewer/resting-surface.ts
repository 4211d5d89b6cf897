/**
 * The model's triangles at rest, in model space (spec.md, section 1): what picking and sliding work on. Skins and morphs
 * are applied once, so a query costs the same on an animated figure as on a mug.
 */
import {
  type BufferAttribute,
  DoubleSide,
  type InterleavedBufferAttribute,
  Matrix3,
  Matrix4,
  type Mesh,
  type MeshStandardMaterial,
  type SkinnedMesh,
  Vector2,
  Vector3,
} from "three";
import { type ModelScene, shapedMeshes } from "./model-scene.ts";

/** Flags of a triangle, to be combined. */
export const DOUBLE_SIDED = 1;
/** The mesh has no vertex normals: the face's own counts. */
export const FACETED = 2;

/** Indexed triangles; three numbers a vertex (two for `uvs`), metres. Normals are unit, zero in faceted meshes. */
export interface RestingSurface {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** Of the painted set, texture transform applied; zeros where the mesh has none. */
  readonly uvs: Float32Array;
  readonly index: Uint32Array;
  /** glTF material index of each triangle. */
  readonly materialOfTriangle: Uint32Array;
  /** DOUBLE_SIDED and FACETED of each triangle. */
  readonly flagsOfTriangle: Uint8Array;
  /** Place of each triangle's mesh in the scene's order (`meshesOf`). */
  readonly meshOfTriangle: Uint32Array;
  /** Place of each triangle among all of its material, as `Engine.uvTriangles` counts them. */
  readonly faceOfTriangle: Uint32Array;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Gathers all meshes of a scene whose materials carry the model's textures, or live ones with their settings. The scene must be at rest. */
export function gatherRestingSurface(scene: ModelScene): RestingSurface {
  scene.root.updateMatrixWorld(true);
  const meshes = shapedMeshes(scene);
  const vertexCount = sum(meshes.map((mesh) => mesh.geometry.getAttribute("position").count));
  const triangleCount = sum(meshes.map(trianglesOf));
  const surface = {
    positions: new Float32Array(vertexCount * 3),
    normals: new Float32Array(vertexCount * 3),
    uvs: new Float32Array(vertexCount * 2),
    index: new Uint32Array(triangleCount * 3),
    materialOfTriangle: new Uint32Array(triangleCount),
    flagsOfTriangle: new Uint8Array(triangleCount),
    meshOfTriangle: new Uint32Array(triangleCount),
    faceOfTriangle: new Uint32Array(triangleCount),
  };
  const faces = new Map<number, number>();
  let firstVertex = 0;
  let firstTriangle = 0;
  for (const [place, mesh] of meshes.entries()) {
    const material = mesh.material as MeshStandardMaterial;
    const mirrored = writeVertices(mesh, surface, firstVertex);
    writeUvs(mesh, material, surface.uvs, firstVertex);
    writeTriangles(mesh, surface.index, firstVertex, firstTriangle, mirrored);
    const end = firstTriangle + trianglesOf(mesh);
    const index = gltfIndexOf(scene, material);
    surface.materialOfTriangle.fill(index, firstTriangle, end);
    surface.meshOfTriangle.fill(place, firstTriangle, end);
    const firstFace = faces.get(index) ?? 0;
    for (let triangle = firstTriangle; triangle < end; triangle++) {
      surface.faceOfTriangle[triangle] = firstFace + triangle - firstTriangle;
    }
    faces.set(index, firstFace + end - firstTriangle);
    const sides = material.side === DoubleSide ? DOUBLE_SIDED : 0;
    const facets = mesh.geometry.getAttribute("normal") === undefined ? FACETED : 0;
    surface.flagsOfTriangle.fill(sides | facets, firstTriangle, end);
    firstVertex += mesh.geometry.getAttribute("position").count;
    firstTriangle = end;
  }
  return surface;
}

/** Writes where the scene's vertices are now, as an animation has posed them: in the order of `gatherRestingSurface`. */
export function writePose(scene: ModelScene, target: Pick<RestingSurface, "positions" | "normals">): void {
  scene.root.updateMatrixWorld(true);
  let firstVertex = 0;
  for (const mesh of shapedMeshes(scene)) {
    writeVertices(mesh, target, firstVertex);
    firstVertex += mesh.geometry.getAttribute("position").count;
  }
}

/** Those triangles of a surface whose mesh is chosen; vertices stay where they are. */
export function triangleSubset(surface: RestingSurface, isChosen: (mesh: number) => boolean): RestingSurface {
  const kept: number[] = [];
  for (let triangle = 0; triangle < surface.meshOfTriangle.length; triangle++) {
    if (isChosen(surface.meshOfTriangle[triangle] as number)) {
      kept.push(triangle);
    }
  }
  const pick = (values: Uint32Array): Uint32Array => Uint32Array.from(kept, (triangle) => values[triangle] as number);
  const index = new Uint32Array(kept.length * 3);
  for (const [place, triangle] of kept.entries()) {
    index.set(surface.index.subarray(triangle * 3, triangle * 3 + 3), place * 3);
  }
  return {
    ...surface,
    index,
    materialOfTriangle: pick(surface.materialOfTriangle),
    flagsOfTriangle: Uint8Array.from(kept, (triangle) => surface.flagsOfTriangle[triangle] as number),
    meshOfTriangle: pick(surface.meshOfTriangle),
    faceOfTriangle: pick(surface.faceOfTriangle),
  };
}

/** Returns of each vertex whether its transform mirrors, which turns its triangles' winding: one joint may, and another not. */
function writeVertices(
  mesh: Mesh,
  surface: Pick<RestingSurface, "positions" | "normals">,
  firstVertex: number,
): Uint8Array {
  const positions = mesh.geometry.getAttribute("position");
  const normals = mesh.geometry.getAttribute("normal");
  const skin = isSkinned(mesh) ? skinOf(mesh) : null;
  const matrix = new Matrix4();
  const normalMatrix = new Matrix3();
  const position = new Vector3();
  const normal = new Vector3();
  matrix.copy(mesh.matrixWorld);
  normalMatrix.getNormalMatrix(matrix);
  const mirrored = new Uint8Array(positions.count).fill(Number(matrix.determinant() < 0));
  for (let vertex = 0; vertex < positions.count; vertex++) {
    if (skin !== null) {
      skin.matrixAt(vertex, matrix);
      normalMatrix.getNormalMatrix(matrix);
      mirrored[vertex] = Number(matrix.determinant() < 0);
    }
    position.fromBufferAttribute(positions, vertex);
    addMorphs(mesh, "position", vertex, position);
    position.applyMatrix4(matrix).toArray(surface.positions, (firstVertex + vertex) * 3);
    if (normals !== undefined) {
      normal.fromBufferAttribute(normals, vertex);
      addMorphs(mesh, "normal", vertex, normal);
      normal
        .applyNormalMatrix(normalMatrix)
        .normalize()
        .toArray(surface.normals, (firstVertex + vertex) * 3);
    }
  }
  return mirrored;
}

function isSkinned(mesh: Mesh): mesh is SkinnedMesh {
  return (mesh as Partial<SkinnedMesh>).isSkinnedMesh === true;
}

/** Linear blend skinning as the GPU does it; glTF places skinned vertices by their joints alone. */
function skinOf(mesh: SkinnedMesh): { matrixAt(vertex: number, target: Matrix4): void } {
  const joints = mesh.geometry.getAttribute("skinIndex") as Attribute;
  const weights = mesh.geometry.getAttribute("skinWeight") as Attribute;
  const palette = mesh.skeleton.bones.map((bone, joint) =>
    new Matrix4().multiplyMatrices(bone.matrixWorld, mesh.skeleton.boneInverses[joint] as Matrix4),
  );
  return {
    matrixAt(vertex, target) {
      const sum = target.elements.fill(0);
      for (let influence = 0; influence < 4; influence++) {
        const weight = weights.getComponent(vertex, influence);
        const bone = palette[joints.getComponent(vertex, influence)];
        if (weight !== 0 && bone !== undefined) {
          for (let element = 0; element < 16; element++) {
            sum[element] = (sum[element] as number) + weight * (bone.elements[element] as number);
          }
        }
      }
    },
  };
}

/** glTF's morph targets are offsets. */
function addMorphs(mesh: Mesh, name: "position" | "normal", vertex: number, target: Vector3): void {
  const morphs = mesh.geometry.morphAttributes[name];
  const weights = mesh.morphTargetInfluences;
  if (morphs === undefined || weights === undefined) {
    return;
  }
  for (const [morph, attribute] of morphs.entries()) {
    const weight = weights[morph] ?? 0;
    if (weight !== 0) {
      target.x += weight * attribute.getX(vertex);
      target.y += weight * attribute.getY(vertex);
      target.z += weight * attribute.getZ(vertex);
    }
  }
}

function writeUvs(mesh: Mesh, material: MeshStandardMaterial, uvs: Float32Array, firstVertex: number): void {
  const map = material.map;
  const channel = map?.channel ?? 0;
  const attribute = mesh.geometry.getAttribute(channel === 0 ? "uv" : `uv${channel}`);
  if (attribute === undefined) {
    return;
  }
  if (map?.matrixAutoUpdate) map.updateMatrix();
  const uv = new Vector2();
  for (let vertex = 0; vertex < attribute.count; vertex++) {
    uv.set(attribute.getX(vertex), attribute.getY(vertex));
    if (map) {
      uv.applyMatrix3(map.matrix);
    }
    uv.toArray(uvs, (firstVertex + vertex) * 2);
  }
}

function writeTriangles(
  mesh: Mesh,
  index: Uint32Array,
  firstVertex: number,
  first: number,
  mirrored: Uint8Array,
): void {
  const own = mesh.geometry.index;
  const vertexOf = (place: number): number => (own === null ? place : own.getX(place));
  for (let triangle = 0; triangle < trianglesOf(mesh); triangle++) {
    const turns = mirrored[vertexOf(triangle * 3)] === 1;
    for (let corner = 0; corner < 3; corner++) {
      const source = triangle * 3 + (turns && corner > 0 ? 3 - corner : corner);
      index[(first + triangle) * 3 + corner] = firstVertex + vertexOf(source);
    }
  }
}

function gltfIndexOf(scene: ModelScene, material: MeshStandardMaterial): number {
  for (const [index, materials] of scene.materials) {
    if (materials.includes(material)) {
      return index;
    }
  }
  return 0;
}

function trianglesOf(mesh: Mesh): number {
  const { index } = mesh.geometry;
  return Math.floor((index?.count ?? mesh.geometry.getAttribute("position")?.count ?? 0) / 3);
}

function sum(values: number[]): number {
  return values.reduce((total, value) => total + value, 0);
}

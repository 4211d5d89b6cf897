/** A model's bytes as a three.js scene, with the glTF material index of every three.js material. */
import {
  type AnimationClip,
  type Group,
  type InterleavedBufferAttribute,
  type Material,
  Matrix4,
  Mesh,
  type MeshStandardMaterial,
  type SkinnedMesh,
  Vector3,
} from "three";
import { type GLTF, GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import type { ModelInfo } from "../engine/engine-api.ts";

export interface ModelScene {
  readonly root: Group;
  readonly animations: readonly AnimationClip[];
  /** glTF material index to the three.js materials made of it (the loader clones some for vertex colours or flat shading). */
  readonly materials: ReadonlyMap<number, readonly MeshStandardMaterial[]>;
  /** What the file calls its meshes. */
  readonly labels: ReadonlyMap<Mesh, MeshLabel>;
  /** Frees geometries, materials and the textures that they hold at that time. */
  dispose(): void;
}

/** A mesh as the file names it; names may be empty. */
export interface MeshLabel {
  readonly node: string;
  readonly material: string;
  /** Its node has other meshes besides: primitives of other materials. */
  readonly several: boolean;
  /** The node's glTF extras. */
  readonly extras: unknown;
}

/** What three.js reads wrongly in some files; `mended-scene.ts` knows in which. */
const DOUBTFUL = /"sparse"|"targets"|texture_t|JOINTS_1|wrap.":3/;

/** Loads `info.glb`. Rejects with a TexelcastError of code "bad-model" where three.js cannot read it. */
export async function loadModelScene(info: ModelInfo): Promise<ModelScene> {
  const given = await parse(info.glb).catch(() => null);
  // For a file without scenes there is none, though it is typed as if there were.
  const gltf =
    given?.scene &&
    !DOUBTFUL.test(JSON.stringify(given.parser.json)) &&
    !given.parser.json.nodes?.some(isSkewed) &&
    !meshesOf(given.scene).some(hasCutElements)
      ? given
      : await (await import("./mended-scene.ts")).mendedScene(info, given, parse);
  const materials = new Map<number, MeshStandardMaterial[]>();
  const meshes = meshesOf(gltf.scene);
  for (const mesh of meshes) {
    const material = mesh.material as MeshStandardMaterial;
    const index = materialIndexOf(gltf, material);
    materials.set(index, [...new Set(materials.get(index)).add(material)]);
  }
  return {
    root: gltf.scene,
    animations: gltf.animations,
    materials,
    labels: new Map(meshes.map((mesh) => [mesh, labelOf(gltf, mesh)])),
    dispose: () => disposeTree(gltf.scene),
  };
}

/** Of a node of the file's, whether no move, turn and size make its matrix: three.js takes it for the next best of these. */
export function isSkewed({ matrix = [] }: { readonly matrix?: readonly number[] }): boolean {
  // Without one all is NaN.
  const own = new Matrix4().fromArray(matrix);
  const { x, y, z } = new Vector3().setFromMatrixScale(own);
  // A box of such edges has the most room where they are upright on each other.
  return x * y * z > Math.abs(own.determinant()) * 1.000000001;
}

/** Three.js counts what lies apart from where the gaps' grid begins, and some elements may reach over its next line. */
function hasCutElements({ geometry }: Mesh): boolean {
  const attributes = Object.values(geometry.attributes) as InterleavedBufferAttribute[];
  // Plain attributes have neither offset nor data.
  return attributes.some(({ offset, itemSize, data }) => offset + itemSize > data?.stride);
}

function parse(glb: Uint8Array): Promise<GLTF> {
  // A copy, as its buffer may be longer.
  return new GLTFLoader().parseAsync(glb.slice().buffer as ArrayBuffer, "");
}

/** Every mesh below `root`, in the scene's order. */
export function meshesOf(root: Group): Mesh[] {
  const meshes: Mesh[] = [];
  root.traverse((object) => {
    if (object instanceof Mesh) {
      meshes.push(object);
    }
  });
  return meshes;
}

/** The meshes of a scene that have a shape, in its order: what part numbers count. */
export function shapedMeshes(scene: ModelScene): Mesh[] {
  return meshesOf(scene.root).filter(({ geometry }) => geometry.hasAttribute("position"));
}

/** Where the scene's vertices are, metres, three numbers each, as it stands now. */
export function positionsOf(scene: ModelScene): Float32Array {
  scene.root.updateMatrixWorld(true);
  const meshes = shapedMeshes(scene);
  const count = meshes.reduce((sum, { geometry }) => sum + geometry.getAttribute("position").count, 0);
  const positions = new Float32Array(count * 3);
  const vertex = new Vector3();
  let at = 0;
  for (const mesh of meshes) {
    for (let index = 0; index < mesh.geometry.getAttribute("position").count; index++, at += 3) {
      mesh.getVertexPosition(index, vertex).applyMatrix4(mesh.matrixWorld).toArray(positions, at);
    }
  }
  return positions;
}

/** Three's own names are made unique and fit for its animation paths; the file's are what the user gave. */
function labelOf(gltf: GLTF, mesh: Mesh): MeshLabel {
  const nodeIndexOf = (object: object | null) => gltf.parser.associations.get(object as Mesh)?.nodes;
  const index = nodeIndexOf(mesh) ?? nodeIndexOf(mesh.parent) ?? -1;
  const { nodes, meshes } = gltf.parser.json as {
    nodes?: { name?: string; mesh?: number; extras?: unknown }[];
    meshes?: { name?: string; primitives?: unknown[] }[];
  };
  const node = nodes?.[index];
  const source = meshes?.[node?.mesh ?? -1];
  return {
    node: node?.name || source?.name || "",
    // Three takes whatever the file has.
    material: String((mesh.material as Material).name),
    several: Number(source?.primitives?.length) > 1,
    extras: node?.extras,
  };
}

/** A material that no file entry stands for is glTF's implied default: the core lists it after the file's last. */
function materialIndexOf(gltf: GLTF, material: Material): number {
  const reference = gltf.parser.associations.get(material) as { materials?: number } | undefined;
  return reference?.materials ?? (gltf.parser.json.materials as unknown[] | undefined)?.length ?? 0;
}

function disposeTree(root: Group): void {
  for (const mesh of meshesOf(root)) {
    mesh.geometry.dispose();
    // A skin's joints lie in a texture.
    (mesh as Partial<SkinnedMesh>).skeleton?.dispose();
    const material = mesh.material as Material;
    for (const value of Object.values(material)) {
      if (value?.isTexture) {
        value.dispose();
        // GLTFLoader decodes to ImageBitmaps, which the garbage collector frees late.
        value.source.data?.close?.();
      }
    }
    material.dispose();
  }
}

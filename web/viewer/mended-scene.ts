/**
 * A model in which something is left out that glTF lets be left out and three.js does not, or that three.js reads in another way than
 * glTF has it. Loaded when three.js fails, or might have gone wrong.
 */
import { type Group, Mesh, type MeshStandardMaterial, RepeatWrapping, Texture } from "three";
import type { GLTF } from "three/examples/jsm/loaders/GLTFLoader.js";
import { goesBeyond } from "../engine/beyond-texture.ts";
import { fillTextures } from "../engine/blank-textures.ts";
import type { ModelInfo } from "../engine/engine-api.ts";
import { parseJson, readContainer, writeGlb } from "../engine/gltf-container.ts";
import { type JsonObject, listOf } from "../engine/gltf-json.ts";
import { packGltf } from "../engine/gltf-packer.ts";
import { notShown } from "../engine/model-fault.ts";
import { settleSkins } from "./all-joints.ts";
import { isSkewed } from "./model-scene.ts";
import { plainGeometry } from "./plain-geometry.ts";

/**
 * `given`, null where `parse` cannot read the file, or another one where that was wrong. Rejects with a TexelcastError that says what
 * is wrong with the file, where `parse` cannot read it even so.
 */
export async function mendedScene(
  { glb, name, materials }: Pick<ModelInfo, "glb" | "name" | "materials">,
  given: GLTF | null,
  parse: (glb: Uint8Array) => Promise<GLTF>,
): Promise<GLTF> {
  const container = readContainer({ name, bytes: glb });
  try {
    const json = parseJson(container);
    const plain = plainGeometry(json, container.binary, name);
    const gltf = given?.scene && plain === null ? given : await parse(mended(json, plain));
    keepSkews(gltf);
    placeTextures(gltf.scene);
    repeatTextures(gltf, materials);
    settleSkins(gltf.scene);
    return gltf;
  } catch (cause) {
    throw notShown(container.json, name, cause);
  }

  function mended(json: JsonObject, plain: Uint8Array | null): Uint8Array {
    fillTextures(json, name);
    giveScene(json, name);
    const bytes = writeGlb(json, plain ?? container.binary, container.extraChunks);
    const packed = packGltf(readContainer({ name, bytes }));
    return writeGlb(packed.json, packed.binary);
  }
}

/** The core paints all nodes of a file without scenes. */
function giveScene(json: JsonObject, name: string): void {
  if (listOf(json, "scenes", name).length > 0) return;
  const nodes = listOf(json, "nodes", name);
  const children = new Set<unknown>(nodes.flatMap((node) => (Array.isArray(node.children) ? node.children : [])));
  json.scenes = [{ nodes: [...nodes.keys()].filter((index) => !children.has(index)) }];
  delete json.scene;
}

/** Has nodes stand by their matrix where it skews, and not by the move, the turn and the size that come next to it. */
function keepSkews({ scene, parser }: GLTF): void {
  const nodes: Parameters<typeof isSkewed>[0][] = parser.json.nodes ?? [];
  scene.traverse((object) => {
    const { matrix } = nodes[parser.associations.get(object)?.nodes ?? -1] ?? {};
    if (matrix === undefined || !isSkewed({ matrix })) return;
    object.matrixAutoUpdate = false;
    object.matrix.fromArray(matrix);
    object.matrixWorldNeedsUpdate = true;
  });
}

/** KHR_texture_transform scales before it turns, three.js the other way round. */
function placeTextures(root: Group): void {
  root.traverse((object) => {
    const values = object instanceof Mesh ? Object.values(object.material) : [];
    for (const texture of values) {
      if (!(texture instanceof Texture) || texture.rotation === 0) continue;
      const { matrix, offset, repeat, rotation } = texture;
      const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
      texture.matrixAutoUpdate = false;
      matrix.set(c * repeat.x, s * repeat.y, offset.x, -s * repeat.x, c * repeat.y, offset.y, 0, 0, 1);
    }
  });
}

/** Tells of base colour textures that their samplers hold at the edge or mirror where, once they are painted, they are to repeat. */
function repeatTextures({ scene, parser }: GLTF, infos: ModelInfo["materials"]): void {
  scene.traverse((object) => {
    const material = object instanceof Mesh ? (object.material as MeshStandardMaterial) : null;
    const info = infos[parser.associations.get(material as MeshStandardMaterial)?.materials ?? -1];
    if (!material?.map || info === undefined) return;
    const { wrapS, wrapT } = material.map;
    const painted = {
      wrapS: goesBeyond(info, 0) ? RepeatWrapping : wrapS,
      wrapT: goesBeyond(info, 1) ? RepeatWrapping : wrapT,
    };
    if (painted.wrapS === wrapS && painted.wrapT === wrapT) return;
    // Other materials, and other uses in this one, may have the same texture.
    material.map = material.map.clone();
    material.map.userData.painted = painted;
  });
}

/** A model in which something is left out that glTF lets be left out, and three.js does not. Loaded when three.js fails. */
import type { GLTF } from "three/examples/jsm/loaders/GLTFLoader.js";
import { fillTextures } from "../engine/blank-textures.ts";
import type { ModelInfo } from "../engine/engine-api.ts";
import { parseJson, readContainer, writeGlb } from "../engine/gltf-container.ts";
import { type JsonObject, listOf } from "../engine/gltf-json.ts";
import { packGltf } from "../engine/gltf-packer.ts";
import { notShown } from "../engine/model-fault.ts";

/** Rejects with a TexelcastError that says what is wrong with the file, where `parse` cannot read it even so. */
export async function parseMended(
  { glb, name }: Pick<ModelInfo, "glb" | "name">,
  parse: (glb: Uint8Array) => Promise<GLTF>,
): Promise<GLTF> {
  const container = readContainer({ name, bytes: glb });
  try {
    const json = parseJson(container);
    fillTextures(json, name);
    giveScene(json, name);
    const bytes = writeGlb(json, container.binary, container.extraChunks);
    const packed = packGltf(readContainer({ name, bytes }));
    return await parse(writeGlb(packed.json, packed.binary));
  } catch (cause) {
    throw notShown(container.json, name, cause);
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

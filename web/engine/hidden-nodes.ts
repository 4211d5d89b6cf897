/** Nodes that KHR_node_visibility hides: what hangs on them is no part of the model as a viewer shows it at rest (spec.md, 1). */
import { forgetExtension } from "./extension-names.ts";
import { parseJson, readContainer, writeGlb } from "./gltf-container.ts";
import { isObject, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { NODE_VISIBILITY } from "./model-extensions.ts";

/** The uncompressed GLB without the extension and without the meshes that it hides; all nodes are there and keep their indices. */
export function withoutHidden(glb: Uint8Array<ArrayBuffer>, name: string): Uint8Array<ArrayBuffer> {
  const container = readContainer({ name, bytes: glb });
  const json = parseJson(container);
  const nodes = listOf(json, "nodes", name);
  const hidden = new Set<JsonObject>();
  const hide = (node: JsonObject): void => {
    const waiting = [node];
    for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
      if (hidden.has(next)) continue;
      hidden.add(next);
      const children = Array.isArray(next.children) ? next.children : [];
      waiting.push(...children.map((child) => nodes[child as number]).filter(isObject));
    }
  };
  for (const node of nodes) {
    const extensions = objectAt(node, "extensions");
    if (objectAt(extensions, NODE_VISIBILITY)?.visible === false) hide(node);
    if (extensions !== undefined) delete extensions[NODE_VISIBILITY];
  }
  for (const node of hidden) {
    for (const drawn of ["mesh", "skin", "weights"]) delete node[drawn];
  }
  forgetExtension(json, NODE_VISIBILITY);
  return writeGlb(json, container.binary, container.extraChunks);
}

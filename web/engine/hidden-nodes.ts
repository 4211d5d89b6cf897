/** Nodes that KHR_node_visibility hides: what hangs on them is no part of the model as a viewer shows it at rest (spec.md, 1). */
import { forgetExtension } from "./extension-names.ts";
import { parseJson, readContainer, writeGlb } from "./gltf-container.ts";
import { extensionsUsed, isObject, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { NODE_VISIBILITY } from "./model-extensions.ts";

/** What a hidden node no longer has. */
const DRAWN = ["mesh", "skin", "weights"] as const;

/** The uncompressed GLB without the extension and without the meshes that it hides; all nodes are there and keep their indices. */
export function withoutHidden(glb: Uint8Array<ArrayBuffer>, name: string): Uint8Array<ArrayBuffer> {
  const container = readContainer({ name, bytes: glb });
  const json = parseJson(container);
  const nodes = listOf(json, "nodes", name);
  const hidden = hiddenOf(nodes);
  for (const node of nodes) {
    const extensions = objectAt(node, "extensions");
    if (extensions !== undefined) delete extensions[NODE_VISIBILITY];
  }
  for (const node of hidden) {
    for (const drawn of DRAWN) delete node[drawn];
  }
  forgetExtension(json, NODE_VISIBILITY);
  return writeGlb(json, container.binary, container.extraChunks);
}

/** Gives a model's JSON back what `withoutHidden` took from it, as `before`, the file's own, has it. A mesh of many instances stands once. */
export function giveHidden(json: JsonObject, before: JsonObject, name: string): void {
  if (!extensionsUsed(before).includes(NODE_VISIBILITY)) return;
  const nodes = listOf(json, "nodes", name);
  const nodesBefore = listOf(before, "nodes", name);
  const hidden = hiddenOf(nodesBefore);
  for (const [index, own] of nodesBefore.entries()) {
    const node = nodes[index];
    if (node === undefined) continue;
    const visibility = objectAt(own, "extensions")?.[NODE_VISIBILITY];
    if (visibility !== undefined) node.extensions = { ...objectAt(node, "extensions"), [NODE_VISIBILITY]: visibility };
    if (!hidden.has(own)) continue;
    for (const drawn of DRAWN) if (own[drawn] !== undefined) node[drawn] = own[drawn];
  }
  for (const key of ["extensionsUsed", "extensionsRequired"]) {
    const [list, listBefore] = [json[key] ?? [], before[key]];
    if (!Array.isArray(list) || !Array.isArray(listBefore) || !listBefore.includes(NODE_VISIBILITY)) continue;
    json[key] = [...list, NODE_VISIBILITY];
  }
}

/** Those that say so, and all below them. */
function hiddenOf(nodes: readonly JsonObject[]): ReadonlySet<JsonObject> {
  const hidden = new Set<JsonObject>();
  const waiting = nodes.filter((node) => objectAt(objectAt(node, "extensions"), NODE_VISIBILITY)?.visible === false);
  for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
    if (hidden.has(next)) continue;
    hidden.add(next);
    const children = Array.isArray(next.children) ? next.children : [];
    waiting.push(...children.map((child) => nodes[child as number]).filter(isObject));
  }
  return hidden;
}

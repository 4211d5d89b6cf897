/** How large a mesh stands in its scene: charts are cut and measured by the size that a viewer sees (glTF 2.0, 3.5.3). */

import type { Accessors } from "../accessors.ts";
import { affineOf, IDENTITY, type Linear, placeOf, times } from "../affine-map.ts";
import { indexAt, type JsonObject, listOf } from "../gltf-json.ts";

/**
 * What the first node with this mesh makes of its directions and lengths; of a skinned one, what its first joint does. A mesh
 * of several nodes has one set of texture coordinates, so one of them has to say.
 */
export function scaleOfMesh(json: JsonObject, mesh: number, accessors: Accessors, name: string): Linear {
  const nodes = listOf(json, "nodes", name);
  const node = nodes.findIndex((each) => each.mesh === mesh);
  if (node < 0) return IDENTITY.linear;
  const skin = listOf(json, "skins", name)[indexAt(nodes[node], "skin") ?? -1];
  if (skin === undefined) return worldOf(nodes, node);
  const joint = Array.isArray(skin.joints) && typeof skin.joints[0] === "number" ? skin.joints[0] : -1;
  const world = worldOf(nodes, joint);
  const bind = indexAt(skin, "inverseBindMatrices");
  return bind === undefined ? world : times(world, affineOf(accessors.readNumbers(bind)).linear);
}

function worldOf(nodes: readonly JsonObject[], node: number): Linear {
  let world = IDENTITY.linear;
  let at = node;
  // A file may call a node its own ancestor: no chain is longer than there are nodes.
  for (let steps = 0; steps <= nodes.length && nodes[at] !== undefined; steps++) {
    world = times(placeOf(nodes[at] as JsonObject).linear, world);
    const child = at;
    at = nodes.findIndex(({ children }) => Array.isArray(children) && children.includes(child));
  }
  return world;
}

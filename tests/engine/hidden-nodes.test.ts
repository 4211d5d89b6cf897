import { afterEach, describe, expect, it } from "vitest";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { type JsonObject, listOf } from "../../web/engine/gltf-json.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";

afterEach(endHosts);

const EXTENSION = "KHR_node_visibility";
const hidden = (visible: unknown): JsonObject => ({ extensions: { [EXTENSION]: { visible } as JsonObject } });

/** The square in three places along x: by itself, below node 1, and below that one's child. */
function squares(...about: readonly JsonObject[]): Uint8Array {
  const nodes: JsonObject[] = [
    { mesh: 0, translation: [0, 0, 0] },
    { mesh: 0, translation: [10, 0, 0], children: [2] },
    { mesh: 0, translation: [10, 0, 0] },
  ];
  return buildGlb({
    meshes: [plane(1, 0)],
    materials: [{ name: "paint" }],
    more: {
      scenes: [{ nodes: [0, 1] }],
      nodes: nodes.map((node, i) => ({ ...node, ...about[i] })),
      extensionsUsed: [EXTENSION],
      extensionsRequired: [EXTENSION],
    },
  });
}

async function reachOf(bytes: Uint8Array): Promise<{ triangles: number | undefined; from: number; to: number }> {
  const info = await startHost().loadModel({ name: "parts.glb", bytes });
  return { triangles: info.materials[0]?.triangles, from: info.boundsMin[0], to: info.boundsMax[0] };
}

describe("a node hidden by KHR_node_visibility", () => {
  it("is no part of the model, nor is what hangs on it", async () => {
    expect(await reachOf(squares({}, hidden(false)))).toEqual({ triangles: 2, from: -0.5, to: 0.5 });
  });

  it("leaves in what it hangs on", async () => {
    expect(await reachOf(squares({}, {}, hidden(false)))).toEqual({ triangles: 4, from: -0.5, to: 10.5 });
  });

  it("stays in where it says that it is visible", async () => {
    const all = { triangles: 6, from: -0.5, to: 20.5 };
    expect(await reachOf(squares(hidden(true), hidden(undefined)))).toEqual(all);
    expect(await reachOf(squares())).toEqual(all);
  });

  it("is hidden below a hidden node whatever it says itself", async () => {
    expect(await reachOf(squares({}, hidden(false), hidden(true)))).toEqual({ triangles: 2, from: -0.5, to: 0.5 });
  });

  it("is there, hidden, in the file that is written", async () => {
    const engine = startHost();
    const bytes = squares({}, hidden(false));
    await engine.loadModel({ name: "parts.glb", bytes });
    await engine.openTarget({ material: 0, width: 16 });
    const { json } = readContainer({ name: "written", bytes: await engine.exportGlb() });
    const before = readContainer({ name: "parts.glb", bytes }).json;
    expect(listOf(json, "nodes", "written")).toEqual(listOf(before, "nodes", "parts.glb"));
    expect(json.extensionsRequired).toEqual([EXTENSION]);
  });

  it("is there, hidden, in an unwrapped model, with the new coordinates", async () => {
    const bytes = squares({}, hidden(false), { name: "below" });
    const { glb } = await unwrapModel({ name: "parts.glb", bytes }, { materials: [0], size: 64 });
    const { json } = readContainer({ name: "unwrapped", bytes: glb });
    const before = readContainer({ name: "parts.glb", bytes }).json;
    expect(json.nodes).toEqual(before.nodes);
    expect(json.extensionsUsed).toEqual([EXTENSION]);
    expect(json.extensionsRequired).toEqual([EXTENSION]);
    expect(await reachOf(glb)).toEqual({ triangles: 2, from: -0.5, to: 0.5 });
  });

  it("hides nothing for long where nodes hang on each other in a ring", async () => {
    const ring = squares({}, { ...hidden(false), children: [2] }, { children: [1] });
    await expect(startHost().loadModel({ name: "ring.glb", bytes: ring })).rejects.toMatchObject({ code: "bad-model" });
  });
});

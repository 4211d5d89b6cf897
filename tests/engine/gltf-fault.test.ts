import { afterEach, describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import { gltfFault } from "../../web/engine/gltf-fault.ts";
import type { JsonObject, JsonValue } from "../../web/engine/gltf-json.ts";
import { loadModelScene, meshesOf } from "../../web/viewer/model-scene.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { manySidedModel } from "../support/many-sided-model.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { letThreeReadPictures } from "../support/three-in-node.ts";

afterEach(endHosts);

letThreeReadPictures();
vi.spyOn(console, "warn").mockReturnValue();
vi.spyOn(console, "error").mockReturnValue();

const STRANGE: readonly JsonValue[] = [-1, 0.5, 1e9, "x", null, true, [], {}, [null]];

type Step = string | number;

const TRANSFORM = ["materials", 0, "pbrMetallicRoughness", "baseColorTexture", "extensions", "KHR_texture_transform"];

/** Every member, and the first two elements of every list. */
function placesIn(value: JsonValue | undefined, path: readonly Step[] = []): (readonly Step[])[] {
  if (typeof value !== "object" || value === null) return [];
  const keys: Step[] = Array.isArray(value) ? [...value.keys()].slice(0, 2) : Object.keys(value);
  return keys.flatMap((key) => {
    const place = [...path, key];
    return [place, ...placesIn((value as Record<Step, JsonValue>)[key], place)];
  });
}

function withValue(json: JsonObject, path: readonly Step[], value: JsonValue): JsonObject {
  const copy = structuredClone(json);
  let parent = copy as unknown as Record<Step, Record<Step, JsonValue>>;
  for (const key of path.slice(0, -1)) parent = parent[key] as unknown as typeof parent;
  (parent as unknown as Record<Step, JsonValue>)[path.at(-1) ?? ""] = structuredClone(value);
  return copy;
}

/** Opens the file as the page does: engine, textures, 3D view. Null where all of it works. */
async function openAsPage(host: EngineHost, bytes: Uint8Array): Promise<unknown> {
  try {
    const info = await host.loadModel({ name: "m.glb", bytes });
    const scene = await loadModelScene(info);
    const named = [...scene.labels.values()].every((label) =>
      [label.node, label.material].every((name) => typeof name === "string"),
    );
    scene.dispose();
    if (!named) return new Error("a label is no text");
    for (const { index, refusal } of info.materials) {
      if (refusal === null) await host.openTarget({ material: index, width: 8, height: 8 });
    }
    return null;
  } catch (error) {
    return error;
  }
}

/** What JavaScript says of itself, and no file's owner understands. */
const RAW = /is not a function|Cannot (read|convert)|undefined|\bnull\b.*reading|is not iterable|NaN|\[object/;

async function faultsOf({ json, binary }: { json: JsonObject; binary: Uint8Array }): Promise<string[]> {
  const host = startHost();
  const faults: string[] = [];
  for (const place of placesIn(json)) {
    for (const value of STRANGE) {
      const error = await openAsPage(host, writeGlb(withValue(json, place, value), binary));
      if (error === null) continue;
      const told = error instanceof TexelcastError ? `${error.message} ${error.value ?? ""}` : `untyped: ${error}`;
      const isClear =
        error instanceof TexelcastError &&
        !["internal", "engine-crashed"].includes(error.code) &&
        error.subject?.startsWith("m.glb") &&
        (error.hint ?? "") !== "" &&
        !RAW.test(told);
      if (!isClear) faults.push(`${place.join(".")} = ${JSON.stringify(value)}: ${told}`);
    }
  }
  return faults;
}

describe("a model whose JSON has a wrong value somewhere", () => {
  it("opens or is refused in plain words that name the file and what to do, whichever member it is", async () => {
    expect(await faultsOf(manySidedModel())).toEqual([]);
  });

  it("does so with compressed geometry, too", async () => {
    const { draco, meshopt } = await compressedModels(buildGlb({ meshes: [plane()] }));
    for (const bytes of [draco, meshopt]) {
      const { json, binary } = readContainer({ name: "m.glb", bytes });
      expect(await faultsOf({ json, binary: binary ?? new Uint8Array() })).toEqual([]);
    }
  });

  it.each<[Step[], JsonValue, string]>([
    [["meshes", 0, "name"], {}, "“meshes[0].name” must be a text, and is {}"],
    [["nodes", 0, "mesh"], 7, "“nodes[0].mesh” must be the number of one of the 1 meshes, from 0 on, and is 7"],
    [["materials", 0, "normalTexture"], null, "“materials[0].normalTexture” must be an object, and is null"],
    [
      ["materials", 1, "extensions", "KHR_materials_sheen", "sheenColorFactor"],
      [1, 1],
      "“materials[1].extensions.KHR_materials_sheen.sheenColorFactor” must be a list of 3 numbers, and is [1,1]",
    ],
    [
      ["animations", 0, "channels", 0, "sampler"],
      -1,
      "“animations[0].channels[0].sampler” must be the number of one of the 1 samplers, from 0 on, and is -1",
    ],
    [["animations"], "x", '“animations” must be a list, and is "x"'],
    [
      ["textures", 0, "sampler"],
      0.5,
      "“textures[0].sampler” must be the number of one of the 1 samplers, from 0 on, and is 0.5",
    ],
    [
      ["nodes", 0, "rotation"],
      [0, 0, 0, 2],
      "“nodes[0].rotation” must be a unit quaternion, whose squares add up to 1, and is [0,0,0,2]",
    ],
  ])("names the member %j, what it must be and what it is", async (place, value, told) => {
    const { json, binary } = manySidedModel();
    const error = gltfFault(withValue(json, place, value), "m.glb");
    expect(error?.message).toBe(`“m.glb” is not a sound glTF file: ${told}.`);
    expect(error).toMatchObject({ code: "bad-container", subject: "m.glb", value: expect.any(String) });
    expect(error?.field).toMatch(/^\w+/);
    expect(binary.length).toBeGreaterThan(0);
  });

  it.each<[Step[], JsonValue, string]>([
    [["nodes", 0, "rotation"], [0, 0, 0, 0], "nodes[0].rotation"],
    [["materials", 0, "pbrMetallicRoughness", "baseColorTexture"], {}, "baseColorTexture.index"],
    [["materials", 0, "pbrMetallicRoughness", "baseColorTexture"], 0, "baseColorTexture"],
    [[...TRANSFORM, "scale"], ["a", 1], `${TRANSFORM.at(-1)}.scale`],
    [[...TRANSFORM, "rotation"], "90", `${TRANSFORM.at(-1)}.rotation`],
  ])("is refused by the engine, for the page and the program alike, where %j is %j", async (place, value, field) => {
    const { json, binary } = manySidedModel();
    const bytes = writeGlb(withValue(json, place, value), binary);
    const refusal = await startHost()
      .loadModel({ name: "m.glb", bytes })
      .catch((error: unknown) => error);
    expect(refusal).toMatchObject({ code: "bad-container", subject: "m.glb", hint: expect.any(String) });
    expect((refusal as TexelcastError).field).toContain(field);
  });

  it("takes a rotation that is off by what rounding makes of it", async () => {
    const { json, binary } = manySidedModel();
    for (const rotation of [
      [0, 0, 0, 1.003],
      [0.708, 0, 0.706, 0],
    ]) {
      const bytes = writeGlb(withValue(json, ["nodes", 0, "rotation"], rotation), binary);
      await startHost().loadModel({ name: "m.glb", bytes });
    }
  });

  it("is no fault while nothing is wrong", async () => {
    expect(gltfFault(manySidedModel().json, "m.glb")).toBeNull();
    for (const bytes of Object.values(await compressedModels(buildGlb({ meshes: [plane()] })))) {
      expect(gltfFault(readContainer({ name: "m.glb", bytes }).json, "m.glb")).toBeNull();
    }
  });
});

describe("a model that leaves out what glTF lets be left out", () => {
  async function meshCount(change: (json: JsonObject) => void): Promise<number> {
    const { json, binary } = manySidedModel();
    change(json);
    const host = startHost();
    const scene = await loadModelScene(await host.loadModel({ name: "m.glb", bytes: writeGlb(json, binary) }));
    const count = meshesOf(scene.root).length;
    scene.dispose();
    return count;
  }

  it("is shown all the same without scenes, with all of its nodes", async () => {
    const whole = await meshCount(() => undefined);
    expect(
      await meshCount((json) => {
        delete json.scenes;
        delete json.scene;
      }),
    ).toBe(whole);
  });

  it("is shown all the same with a texture that has no picture", async () => {
    const whole = await meshCount(() => undefined);
    expect(
      await meshCount((json) => {
        json.textures = [{}];
      }),
    ).toBe(whole);
  });
});

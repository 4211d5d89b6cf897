import { type Document, WebIO } from "@gltf-transform/core";
import { EXTMeshGPUInstancing } from "@gltf-transform/extensions";
import { InstancedMesh, Matrix4, type Object3D } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { afterEach, describe, expect, it } from "vitest";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import { type JsonObject, listOf } from "../../web/engine/gltf-json.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { buildModel, type ModelParts, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";

afterEach(endHosts);

const EXTENSION = "EXT_mesh_gpu_instancing";
const SQUARE: ModelParts = { meshes: [plane(1, 0)], materials: [{ name: "paint" }] };

interface Places {
  readonly translation?: readonly number[];
  readonly rotation?: readonly number[];
  readonly scale?: readonly number[];
}

/** The square where the places say, as @gltf-transform writes it. */
async function instanced(places: Places, change: (document: Document) => void = () => undefined): Promise<Uint8Array> {
  const io = new WebIO().registerExtensions([EXTMeshGPUInstancing]);
  const { json, binary } = buildModel(SQUARE);
  const document = await io.readBinary(writeGlb(json, binary));
  const extension = document.createExtension(EXTMeshGPUInstancing).setRequired(true);
  const batch = extension.createInstancedMesh();
  const [buffer] = document.getRoot().listBuffers();
  const list = (name: string, type: "VEC3" | "VEC4", numbers: readonly number[] | undefined): void => {
    if (numbers === undefined) return;
    const accessor = document.createAccessor().setType(type).setArray(Float32Array.from(numbers));
    batch.setAttribute(name, accessor.setBuffer(buffer ?? null));
  };
  list("TRANSLATION", "VEC3", places.translation);
  list("ROTATION", "VEC4", places.rotation);
  list("SCALE", "VEC3", places.scale);
  const [node] = document.getRoot().listNodes();
  node?.setName("Tile").setTranslation([0, 0, 5]).setScale([2, 2, 2]).setExtension(EXTENSION, batch);
  change(document);
  return await io.writeBinary(document);
}

const THREE_PLACES: Places = {
  translation: [0, 0, 0, 3, 0, 0, 0, 4, 1],
  rotation: [0, 0, 0, 1, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 0.5, 0.5, 0.5, 0.5],
  scale: [1, 1, 1, 2, 1, 1, 1, 0.5, 1],
};

/** Where a viewer draws each mesh, one matrix each, to a hundred-thousandth. */
async function drawnAt(glb: Uint8Array): Promise<string[]> {
  const buffer = Uint8Array.from(glb).buffer;
  const { scene } = await new GLTFLoader().parseAsync(buffer, "");
  scene.updateMatrixWorld(true);
  const drawn: Matrix4[] = [];
  scene.traverse((object: Object3D & { isMesh?: boolean }) => {
    if (object instanceof InstancedMesh) {
      for (let i = 0; i < object.count; i++) {
        const own = new Matrix4();
        object.getMatrixAt(i, own);
        drawn.push(own.premultiply(object.matrixWorld));
      }
    } else if (object.isMesh) drawn.push(object.matrixWorld);
  });
  return drawn.map(({ elements }) => elements.map((value) => (Math.round(value * 1e5) / 1e5 + 0).toString()).join(" "));
}

/** The GLB with its JSON changed. */
function changed(glb: Uint8Array, change: (json: JsonObject) => void): Uint8Array {
  const { json, binary } = readContainer({ name: "x", bytes: glb });
  const copy = structuredClone(json);
  change(copy);
  return writeGlb(copy, binary);
}

const attributesOf = (json: JsonObject): JsonObject => {
  const node = listOf(json, "nodes", "x")[0] as { extensions: Record<string, { attributes: JsonObject }> };
  return (node.extensions[EXTENSION] as { attributes: JsonObject }).attributes;
};

describe("a mesh in many places by EXT_mesh_gpu_instancing", () => {
  it("stands where a viewer that knows the extension draws it", async () => {
    const bytes = await instanced(THREE_PLACES);
    const { glb } = await loadModelFile({ name: "tiles.glb", bytes });
    expect(await drawnAt(glb)).toEqual(await drawnAt(bytes));
    const { json } = readContainer({ name: "shown", bytes: glb });
    expect(json.extensionsRequired).toBeUndefined();
    expect(listOf(json, "nodes", "shown").map(({ name }) => name)).toEqual(["Tile", "Tile 1", "Tile 2", "Tile 3"]);
  });

  it("is baked and painted in all of them", async () => {
    const engine = startHost();
    const info = await engine.loadModel({ name: "tiles.glb", bytes: await instanced(THREE_PLACES) });
    expect(info.materials).toMatchObject([{ name: "paint", triangles: 6 }]);
    // The square reaches half a metre to either side; its node is twice as large, five metres in front.
    expect(info.boundsMin).toEqual([-1, -2, 5]);
    expect(info.boundsMax[1]).toBeCloseTo(9, 5);
  });

  it("stands there too where the places are compressed", async () => {
    const bytes = await instanced({ translation: [0, 0, 0, 7, 0, 0] });
    const { meshopt } = await compressedModels(bytes);
    const { glb } = await loadModelFile({ name: "packed.glb", bytes: meshopt });
    expect(await drawnAt(glb)).toEqual(await drawnAt(bytes));
  });

  it("takes turns in whole numbers", async () => {
    const bytes = await instanced({ rotation: [0, 0, 0, 1] }, (document) => {
      const accessor = document
        .getRoot()
        .listAccessors()
        .find((each) => each.getType() === "VEC4");
      accessor?.setArray(Int8Array.of(0, 0, 90, 90)).setNormalized(true);
    });
    const { glb } = await loadModelFile({ name: "turned.glb", bytes });
    const { json } = readContainer({ name: "shown", bytes: glb });
    const [, child] = listOf(json, "nodes", "shown");
    expect(child?.rotation).toEqual([0, 0, expect.closeTo(Math.SQRT1_2, 12), expect.closeTo(Math.SQRT1_2, 12)]);
  });

  it("is one mesh again in the file that is written", async () => {
    const engine = startHost();
    await engine.loadModel({ name: "tiles.glb", bytes: await instanced(THREE_PLACES) });
    await engine.openTarget({ material: 0, width: 16 });
    const written = await engine.exportGlb();
    const { json } = readContainer({ name: "written", bytes: written });
    expect(listOf(json, "nodes", "written")).toHaveLength(1);
    expect(json.extensionsRequired).toEqual([EXTENSION]);
    expect(await drawnAt(changed(written, bare))).toEqual(await drawnAt(await instanced(THREE_PLACES)));
  });

  it("stays one where it hangs on a skeleton, as its node has no say there", async () => {
    const bytes = changed(await instanced(THREE_PLACES), (json) => {
      const [node] = listOf(json, "nodes", "x");
      json.skins = [{ joints: [0] }];
      Object.assign(node as JsonObject, { skin: 0 });
    });
    const { glb } = await loadModelFile({ name: "skin.glb", bytes });
    expect(listOf(readContainer({ name: "shown", bytes: glb }).json, "nodes", "shown")).toHaveLength(1);
  });

  it.each([
    ["lists of different lengths", (json: JsonObject) => shorten(json, "SCALE"), "bad-container", /3 and .*2/],
    ["a list that is not there", missing, "bad-container", /99/],
    ["a list of another type", swapped, "bad-container", /TRANSLATION/],
    ["more than can be baked", (json: JsonObject) => claim(json, 1e9), "out-of-budget", /1000000000/],
  ] as const)("is refused for %s, by the node's name in the file", async (_, change, code, said) => {
    const bytes = changed(await instanced(THREE_PLACES), change);
    await expect(loadModelFile({ name: "bad.glb", bytes })).rejects.toMatchObject({
      code,
      subject: "bad.glb",
      message: expect.stringMatching(said),
    });
  });
});

/** Without pictures, which Node cannot decode for a viewer. */
function bare(json: JsonObject): void {
  delete json.textures;
  delete json.images;
  for (const material of listOf(json, "materials", "x")) delete material.pbrMetallicRoughness;
}

function shorten(json: JsonObject, key: string): void {
  const accessor = listOf(json, "accessors", "x")[attributesOf(json)[key] as number];
  Object.assign(accessor as JsonObject, { count: 2 });
}

function missing(json: JsonObject): void {
  attributesOf(json).SCALE = 99;
}

function swapped(json: JsonObject): void {
  const attributes = attributesOf(json);
  attributes.TRANSLATION = attributes.ROTATION as number;
}

function claim(json: JsonObject, count: number): void {
  for (const index of Object.values(attributesOf(json))) {
    const accessor = listOf(json, "accessors", "x")[index as number] as JsonObject;
    delete accessor.bufferView;
    accessor.count = count;
  }
}

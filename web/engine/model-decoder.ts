/**
 * Undoes geometry compression (KHR_draco_mesh_compression, EXT_ and KHR_meshopt_compression) by @gltf-transform, with
 * the same decoders in the browser and in Node. They are loaded only when a model needs them.
 */
/// <reference path="./draco3dgltf.d.ts" />

import { TexelcastError } from "../core/texelcast-error.ts";
import { accessorBeyond } from "./accessor-bounds.ts";
import { COMPONENT_BYTES, SHAPES } from "./accessor-shapes.ts";
import { fillTextures } from "./blank-textures.ts";
import { readCodec } from "./codec-wasm.ts";
import { stringifyExact } from "./exact-numbers.ts";
import { forgetExtension } from "./extension-names.ts";
import { writeGlb } from "./gltf-container.ts";
import { gltfFault } from "./gltf-fault.ts";
import { badContainer, extensionsUsed, indexAt, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { MESHOPT_EXTENSIONS, type PackedGltf } from "./gltf-packer.ts";
import { allPrimitives } from "./gltf-primitives.ts";
import { COMPRESSION, DRACO } from "./model-extensions.ts";

const [EXT_MESHOPT, KHR_MESHOPT] = MESHOPT_EXTENSIONS;

/** Meshopt's counts are not bounded by the compressed size, so they are bounded here, before anything is allocated. */
const MAX_DECODED_BYTES = 2 ** 30;

/**
 * No file's size bounds what an accessor without a buffer view counts either: zeros, or what Draco holds. (@gltf-transform takes eight
 * times as much while it works on them.)
 */
const MAX_UNVIEWED_BYTES = 2 ** 28;

const TRIANGLE_STRIP = 5;

/** Meshopt's filters, and how long elements they work on, bytes. Its decoder leaves out one that it does not know. */
const FILTERED_BYTES: Readonly<Record<string, (stride: number) => boolean>> = {
  NONE: () => true,
  OCTAHEDRAL: (stride) => stride === 4 || stride === 8,
  QUATERNION: (stride) => stride === 8,
  EXPONENTIAL: (stride) => stride % 4 === 0,
  COLOR: (stride) => stride === 4 || stride === 8,
};
const MODES: readonly unknown[] = ["ATTRIBUTES", "TRIANGLES", "INDICES"];

/**
 * The model without compression, as a GLB; materials keep their indices. `packed` is left as it was. Throws "bad-model"
 * when the compressed data cannot be decoded.
 */
export async function decodeModel(packed: PackedGltf, name: string): Promise<Uint8Array<ArrayBuffer>> {
  const json = withExtMeshopt(JSON.parse(stringifyExact(packed.json)) as JsonObject, name);
  checkMeshopt(json, name);
  checkUnviewedSizes(json, name);
  // What ends early would be read as fewer elements, and triangles be missing.
  const beyond = accessorBeyond(packed.json, name);
  if (beyond !== null) throw gltfFault(packed.json, name) ?? beyond;
  fillTextures(json, name);
  listStrips(json, name);
  // What version and which extensions a model may ask for, the core says, of compressed ones as of all.
  json.asset = { version: "2.0" };
  delete json.extensionsRequired;
  const names = extensionsUsed(json);
  const used = COMPRESSION.filter((extension) => names.includes(extension));
  const [{ Format, GLB_BUFFER, Logger, WebIO }, { ALL_EXTENSIONS }] = await Promise.all([
    import("@gltf-transform/core"),
    import("@gltf-transform/extensions"),
  ]);
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  if (used.includes(DRACO)) io.registerDependencies({ "draco3d.decoder": await startDraco() });
  if (used.includes(EXT_MESHOPT)) {
    const { MeshoptDecoder } = await import("meshoptimizer/decoder");
    await MeshoptDecoder.ready;
    io.registerDependencies({ "meshopt.decoder": MeshoptDecoder });
  }
  try {
    const binary = (packed.binary ?? new Uint8Array()) as Uint8Array<ArrayBuffer>;
    type Gltf = Parameters<typeof io.readJSON>[0]["json"];
    const document = await io.readJSON({
      json: json as unknown as Gltf,
      resources: { [GLB_BUFFER]: binary },
    });
    const root = document.getRoot();
    for (const extension of root.listExtensionsUsed()) {
      if (used.includes(extension.extensionName)) extension.dispose();
    }
    // A GLB has one buffer; the others go, and what was in them moves to the first.
    const [first = document.createBuffer(), ...others] = root.listBuffers();
    // Sparse ones are filled in, too: their writer takes normalized integers for the fractions that they stand for.
    for (const accessor of root.listAccessors()) accessor.setBuffer(first).setSparse(false);
    for (const buffer of others) buffer.dispose();
    const written = await io.writeJSON(document, { format: Format.GLB });
    const plain = written.json as unknown as JsonObject;
    for (const key of ["asset", "extensionsUsed", "extensionsRequired"]) {
      if (packed.json[key] !== undefined) plain[key] = packed.json[key];
    }
    keepMatrices(packed.json, plain, name);
    for (const scene of listOf(plain, "scenes", name)) {
      if (Array.isArray(scene.nodes) && scene.nodes.length === 0) delete scene.nodes;
    }
    for (const extension of COMPRESSION) forgetExtension(plain, extension);
    return writeGlb(plain, written.resources[GLB_BUFFER] ?? null);
  } catch (cause) {
    const fault = gltfFault(packed.json, name);
    if (fault !== null) throw fault;
    throw new TexelcastError("bad-model", `The compressed geometry of “${name}” cannot be decoded.`, {
      subject: name,
      field: used.join(", "),
      hint: "Export the model again, or without compression.",
      cause,
    });
  }
}

async function startDraco(): Promise<unknown> {
  const { default: createDecoder } = await import("draco3dgltf/draco_decoder_gltf_nodejs.js");
  return await createDecoder({ wasmBinary: await readCodec("draco") });
}

/** KHR_meshopt_compression under its older name, the one that @gltf-transform knows; the members are the same. */
function withExtMeshopt(json: JsonObject, name: string): JsonObject {
  for (const item of [...listOf(json, "bufferViews", name), ...listOf(json, "buffers", name)]) {
    const extensions = objectAt(item, "extensions");
    if (extensions?.[KHR_MESHOPT] === undefined) continue;
    extensions[EXT_MESHOPT] ??= extensions[KHR_MESHOPT];
    delete extensions[KHR_MESHOPT];
  }
  for (const key of ["extensionsUsed", "extensionsRequired"]) {
    const list = json[key];
    if (Array.isArray(list)) json[key] = [...new Set(list.map((item) => (item === KHR_MESHOPT ? EXT_MESHOPT : item)))];
  }
  return json;
}

/** @gltf-transform makes a move, a turn and a size of a matrix, and one may be more than that. Nodes keep their indices. */
function keepMatrices(from: JsonObject, to: JsonObject, name: string): void {
  const nodes = listOf(to, "nodes", name);
  for (const [index, { matrix }] of listOf(from, "nodes", name).entries()) {
    const node = nodes[index];
    if (matrix === undefined || node === undefined) continue;
    for (const key of ["translation", "rotation", "scale"]) delete node[key];
    node.matrix = matrix;
  }
}

/** Draco's triangles are unpacked one by one, those of strips as well. */
function listStrips(json: JsonObject, name: string): void {
  for (const primitive of allPrimitives(json, name)) {
    if (primitive.mode === TRIANGLE_STRIP && objectAt(objectAt(primitive, "extensions"), DRACO) !== undefined)
      delete primitive.mode;
  }
}

function checkUnviewedSizes(json: JsonObject, name: string): void {
  let total = 0;
  for (const [i, accessor] of listOf(json, "accessors", name).entries()) {
    if (accessor.bufferView !== undefined) continue;
    const count = indexAt(accessor, "count") ?? 0;
    const bytes = COMPONENT_BYTES[indexAt(accessor, "componentType") ?? 0] ?? 4;
    const [columns, rows] = SHAPES[String(accessor.type)] ?? [4, 4];
    total += count * columns * rows * bytes;
    if (total <= MAX_UNVIEWED_BYTES) continue;
    throw new TexelcastError(
      "out-of-budget",
      `The accessors of “${name}” up to accessor ${i} would take more than ${MAX_UNVIEWED_BYTES / 2 ** 20} MiB without a byte of it in the file.`,
      { subject: name, field: `accessors[${i}].count`, value: String(count), hint: "Simplify the model." },
    );
  }
}

function checkMeshopt(json: JsonObject, name: string): void {
  let total = 0;
  for (const [i, view] of listOf(json, "bufferViews", name).entries()) {
    const compressed = objectAt(objectAt(view, "extensions"), EXT_MESHOPT);
    if (compressed === undefined) continue;
    const count = indexAt(compressed, "count");
    const stride = indexAt(compressed, "byteStride");
    const path = `bufferViews[${i}].extensions.${EXT_MESHOPT}`;
    if (count === undefined || stride === undefined || stride === 0 || stride > 256) {
      throw badContainer(name, `“${path}” has no sound count and byteStride`, path, compressed);
    }
    const { mode, filter = "NONE" } = compressed;
    if (!MODES.includes(mode))
      throw badContainer(name, `“${path}.mode” is none of ${MODES.join(", ")}`, `${path}.mode`, mode ?? "(absent)");
    const fits = Object.hasOwn(FILTERED_BYTES, String(filter)) ? FILTERED_BYTES[String(filter)] : undefined;
    if (!fits?.(stride)) {
      const problem = `“${path}.filter” is none that goes with elements of ${stride} bytes`;
      throw badContainer(name, problem, `${path}.filter`, filter);
    }
    if (count * stride !== indexAt(view, "byteLength")) {
      throw badContainer(name, `“${path}” does not unpack to its view's length`, `${path}.count`, count);
    }
    total += count * stride;
  }
  if (total > MAX_DECODED_BYTES) {
    throw new TexelcastError(
      "out-of-budget",
      `“${name}” would unpack to ${Math.ceil(total / 2 ** 20)} MiB of geometry.`,
      {
        subject: name,
        value: String(total),
        hint: "Simplify the model.",
      },
    );
  }
}

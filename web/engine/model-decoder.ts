/**
 * Undoes geometry compression (KHR_draco_mesh_compression, EXT_ and KHR_meshopt_compression), with the same decoders in the browser
 * and in Node. They are loaded only when a model needs them.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { accessorBeyond } from "./accessor-bounds.ts";
import { COMPONENT_BYTES, SHAPES } from "./accessor-shapes.ts";
import { stringifyExact } from "./exact-numbers.ts";
import { writeGlb } from "./gltf-container.ts";
import { gltfFault } from "./gltf-fault.ts";
import { badContainer, extensionsUsed, indexAt, type JsonObject, listOf } from "./gltf-json.ts";
import type { PackedGltf } from "./gltf-packer.ts";
import { graftGeometry } from "./graft-geometry.ts";
import { COMPRESSION } from "./model-extensions.ts";
import { separateAccessors } from "./separate-accessors.ts";
import { meshoptOf, unpackGeometry } from "./unpack-geometry.ts";

/** Meshopt's counts are not bounded by the compressed size, so they are bounded here, before anything is allocated. */
const MAX_DECODED_BYTES = 2 ** 30;

/** No file's size bounds what an accessor without a buffer view counts either: zeros, or what Draco holds. */
const MAX_UNVIEWED_BYTES = 2 ** 28;

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
 * The model without compression, as a GLB: its JSON as it was but for what compression said, every index the file's. `packed` is left
 * as it was. Throws "bad-model" when the compressed data cannot be decoded.
 */
export async function decodeModel(packed: PackedGltf, name: string): Promise<Uint8Array<ArrayBuffer>> {
  const plain = structuredClone(packed.json);
  separateAccessors(plain, name);
  const json = JSON.parse(stringifyExact(plain)) as JsonObject;
  checkMeshopt(json, name);
  checkUnviewedSizes(json, name);
  // What ends early would be read as fewer elements, and triangles be missing.
  const beyond = accessorBeyond(json, name);
  if (beyond !== null) throw gltfFault(json, name) ?? beyond;
  try {
    const binary = packed.binary ?? new Uint8Array();
    const grown = graftGeometry(plain, binary, await unpackGeometry(json, binary, name), name);
    return writeGlb(plain, grown);
  } catch (cause) {
    const fault = gltfFault(json, name);
    if (fault !== null) throw fault;
    if (cause instanceof TexelcastError) throw cause;
    const used = extensionsUsed(json).filter((extension) => COMPRESSION.includes(extension));
    throw new TexelcastError("bad-model", `The compressed geometry of “${name}” cannot be decoded.`, {
      subject: name,
      field: used.join(", "),
      hint: "Export the model again, or without compression.",
      cause,
    });
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
    const found = meshoptOf(view);
    if (found === undefined) continue;
    const { key, place: compressed } = found;
    const count = indexAt(compressed, "count");
    const stride = indexAt(compressed, "byteStride");
    const path = `bufferViews[${i}].extensions.${key}`;
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

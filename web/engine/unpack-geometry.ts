/**
 * What compression holds of a model, unpacked by @gltf-transform. It is handed nothing but that, each piece under a name, so that
 * what it makes of a file need not be told apart again: it keeps no index and no member that it has no class for.
 */
/// <reference path="./draco3dgltf.d.ts" />
import type { TypedArray } from "@gltf-transform/core";
import { readCodec } from "./codec-wasm.ts";
import { indexAt, type JsonObject, listOf, objectAt } from "./gltf-json.ts";
import { MESHOPT_EXTENSIONS } from "./gltf-packer.ts";
import { allPrimitives } from "./gltf-primitives.ts";
import { DRACO } from "./model-extensions.ts";

/** The name that @gltf-transform knows; the members of KHR_meshopt_compression are the same. */
const [EXT_MESHOPT] = MESHOPT_EXTENSIONS;
const UNSIGNED_BYTE = 5121;

export interface UnpackedGeometry {
  /** The bytes of each buffer view that meshopt compressed. */
  readonly views: ReadonlyMap<number, Uint8Array>;
  /** The values of each accessor that Draco holds. */
  readonly accessors: ReadonlyMap<number, TypedArray>;
}

/** What meshopt says of a buffer view or a buffer, under the name that it has in the file. */
export function meshoptOf(holder: JsonObject): { readonly key: string; readonly place: JsonObject } | undefined {
  for (const key of MESHOPT_EXTENSIONS) {
    const place = objectAt(objectAt(holder, "extensions"), key);
    if (place !== undefined) return { key, place };
  }
  return undefined;
}

/** What Draco says of a primitive. */
export const dracoOf = (primitive: JsonObject): JsonObject | undefined =>
  objectAt(objectAt(primitive, "extensions"), DRACO);

/** `binary` is only read. Throws what the decoders throw. */
export async function unpackGeometry(json: JsonObject, binary: Uint8Array, name: string): Promise<UnpackedGeometry> {
  const bufferViews: JsonObject[] = [];
  const accessors: JsonObject[] = [];
  for (const [index, view] of listOf(json, "bufferViews", name).entries()) {
    const place = meshoptOf(view)?.place;
    if (place === undefined) continue;
    const { byteLength } = view;
    // Read as single bytes, they come out as they are, whatever accessors lie on them.
    const bufferView = bufferViews.push({ buffer: 0, byteLength, extensions: { [EXT_MESHOPT]: place } }) - 1;
    const bytes = { componentType: UNSIGNED_BYTE, type: "SCALAR", count: byteLength };
    accessors.push({ ...bytes, name: `view ${index}`, bufferView });
  }
  const usesMeshopt = bufferViews.length > 0;
  const primitives = dracoPrimitives(json, bufferViews, accessors, name);
  const usesDraco = primitives.length > 0;
  if (!usesMeshopt && !usesDraco) return { views: new Map(), accessors: new Map() };

  const [{ GLB_BUFFER, Logger, WebIO }, { EXTMeshoptCompression, KHRDracoMeshCompression }] = await Promise.all([
    import("@gltf-transform/core"),
    import("@gltf-transform/extensions"),
  ]);
  const io = new WebIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([EXTMeshoptCompression, KHRDracoMeshCompression]);
  if (usesDraco) io.registerDependencies({ "draco3d.decoder": await startDraco() });
  if (usesMeshopt) {
    const { MeshoptDecoder } = await import("meshoptimizer/decoder");
    await MeshoptDecoder.ready;
    io.registerDependencies({ "meshopt.decoder": MeshoptDecoder });
  }
  const given: JsonObject = {
    asset: { version: "2.0" },
    extensionsUsed: [...(usesDraco ? [DRACO] : []), ...(usesMeshopt ? [EXT_MESHOPT] : [])],
    buffers: [{ byteLength: binary.length }],
    bufferViews,
    accessors,
    meshes: [{ primitives }],
  };
  type Gltf = Parameters<typeof io.readJSON>[0]["json"];
  const document = await io.readJSON({
    json: given as unknown as Gltf,
    resources: { [GLB_BUFFER]: binary as Uint8Array<ArrayBuffer> },
  });
  const unpacked = { views: new Map<number, Uint8Array>(), accessors: new Map<number, TypedArray>() };
  for (const accessor of document.getRoot().listAccessors()) {
    const [kind, index] = accessor.getName().split(" ");
    const values = accessor.getArray();
    if (values === null) throw new Error(`Nothing was unpacked for ${accessor.getName()}.`);
    if (kind === "view") unpacked.views.set(Number(index), values as Uint8Array);
    else unpacked.accessors.set(Number(index), values);
  }
  return unpacked;
}

/** Those that Draco holds, of these buffer views and accessors, which are put behind the others. */
function dracoPrimitives(
  json: JsonObject,
  bufferViews: JsonObject[],
  accessors: JsonObject[],
  name: string,
): JsonObject[] {
  const views = new Map<unknown, number>();
  const known = new Map<unknown, number>();
  const [allViews, all] = [listOf(json, "bufferViews", name), listOf(json, "accessors", name)];
  const put = (index: number): number => {
    const { componentType, type } = all[index] ?? {};
    const found = known.get(index) ?? accessors.push({ name: `accessor ${index}`, componentType, type }) - 1;
    known.set(index, found);
    return found;
  };
  return allPrimitives(json, name).flatMap((primitive) => {
    const place = dracoOf(primitive);
    if (place === undefined) return [];
    const { byteOffset, byteLength } = allViews[indexAt(place, "bufferView") ?? -1] ?? {};
    const bufferView = views.get(place.bufferView) ?? bufferViews.push({ buffer: 0, byteOffset, byteLength }) - 1;
    views.set(place.bufferView, bufferView);
    const attributes: JsonObject = {};
    for (const semantic of Object.keys(objectAt(place, "attributes") ?? {})) {
      const index = indexAt(objectAt(primitive, "attributes"), semantic);
      if (index === undefined) throw new Error(`No accessor is named for ${semantic}.`);
      attributes[semantic] = put(index);
    }
    const indices = indexAt(primitive, "indices");
    const own = { bufferView, attributes: place.attributes };
    return [{ attributes, ...(indices !== undefined && { indices: put(indices) }), extensions: { [DRACO]: own } }];
  });
}

async function startDraco(): Promise<unknown> {
  const { default: createDecoder } = await import("draco3dgltf/draco_decoder_gltf_nodejs.js");
  return await createDecoder({ wasmBinary: await readCodec("draco") });
}

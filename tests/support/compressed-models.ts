/** A model as exporters compress it. */
import { type Document, WebIO } from "@gltf-transform/core";
import {
  EXTMeshGPUInstancing,
  EXTMeshoptCompression,
  KHRDracoMeshCompression,
  KHRMaterialsUnlit,
} from "@gltf-transform/extensions";
import createDracoEncoder from "draco3dgltf/draco_encoder_gltf_nodejs.js";
import { MeshoptEncoder } from "meshoptimizer/encoder";

/** The GLB with its geometry compressed, once in each of the two ways. */
export async function compressedModels(glb: Uint8Array): Promise<Record<"draco" | "meshopt", Uint8Array>> {
  const io = new WebIO()
    .registerExtensions([KHRDracoMeshCompression, EXTMeshGPUInstancing, EXTMeshoptCompression, KHRMaterialsUnlit])
    .registerDependencies({ "draco3d.encoder": await createDracoEncoder(), "meshopt.encoder": MeshoptEncoder });
  await MeshoptEncoder.ready;
  const compress = async (change: (document: Document) => void): Promise<Uint8Array> => {
    const document = await io.readBinary(glb as Uint8Array<ArrayBuffer>);
    change(document);
    return await io.writeBinary(document);
  };
  const bits = { POSITION: 16, NORMAL: 12, TEX_COORD: 16 };
  return {
    draco: await compress((document) => {
      document.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({ quantizationBits: bits });
    }),
    meshopt: await compress((document) => {
      document.createExtension(EXTMeshoptCompression).setRequired(true);
    }),
  };
}

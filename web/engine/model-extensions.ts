/** Extensions that are undone before a model is baked and shown. */
import { MESHOPT_EXTENSIONS } from "./gltf-packer.ts";

export const DRACO = "KHR_draco_mesh_compression";
export const COMPRESSION: readonly string[] = [DRACO, ...MESHOPT_EXTENSIONS];
export const INSTANCES = "EXT_mesh_gpu_instancing";
export const NODE_VISIBILITY = "KHR_node_visibility";
export const SPECULAR_GLOSSINESS = "KHR_materials_pbrSpecularGlossiness";

/** Extensions of geometry that are undone, beside meshopt's (gltf-packer.ts). */
export const DRACO = "KHR_draco_mesh_compression";
export const INSTANCES = "EXT_mesh_gpu_instancing";

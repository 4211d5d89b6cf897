/** Extensions of geometry that are undone. */
import { MESHOPT_EXTENSIONS } from "./gltf-packer.ts";

export const DRACO = "KHR_draco_mesh_compression";
export const COMPRESSION: readonly string[] = [DRACO, ...MESHOPT_EXTENSIONS];
export const INSTANCES = "EXT_mesh_gpu_instancing";

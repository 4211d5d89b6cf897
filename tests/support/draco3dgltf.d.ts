/** The encoder half of draco3dgltf, with which the tests make compressed models. It ships no types. */
declare module "draco3dgltf/draco_encoder_gltf_nodejs.js" {
  export default function createEncoder(): Promise<unknown>;
}

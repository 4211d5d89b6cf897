/** The decoder half of draco3dgltf on its own (the package's entry would load the encoder too). It ships no types. */
declare module "draco3dgltf/draco_decoder_gltf_nodejs.js" {
  export default function createDecoder(options: { wasmBinary: Uint8Array }): Promise<unknown>;
}

/**
 * Textures that a model has as KTX 2.0 alone (KHR_texture_basisu), as PNG: what paints and what shows a model then reads them as any
 * other. Where a texture offers a plain picture too, that one is taken, which has lost less.
 */
import { forgetExtension } from "./extension-names.ts";
import { BinaryEditor } from "./gltf-binary-editor.ts";
import { indexAt, listOf, objectAt } from "./gltf-json.ts";
import type { PackedGltf } from "./gltf-packer.ts";
import { decodeKtx2 } from "./ktx2-decoder.ts";
import { BASISU_TEXTURE, type EncodedImage, imageBytes } from "./model-textures.ts";
import { encodePng } from "./png-encoder.ts";

/**
 * The model without the extension; `packed.json` is changed. Its textures and images keep their indices. Rejects with "bad-picture",
 * naming the model and the image.
 */
export async function withoutBasis({ json, binary }: PackedGltf, name: string): Promise<PackedGltf> {
  const pictures = new Map<number, EncodedImage | null>();
  for (const texture of listOf(json, "textures", name)) {
    const extensions = objectAt(texture, "extensions");
    const source = indexAt(objectAt(extensions, BASISU_TEXTURE), "source");
    if (extensions !== undefined) delete extensions[BASISU_TEXTURE];
    if (source === undefined || indexAt(texture, "source") !== undefined) continue;
    texture.source = source;
    pictures.set(source, imageBytes(json, binary, source, name));
  }
  // Only once all are found: it moves what lies behind a picture.
  const editor = new BinaryEditor(json, binary, name);
  for (const [index, picture] of pictures) {
    // One that has no bytes is told of where it is asked for, as of any other kind.
    if (picture === null) continue;
    const decoded = await decodeKtx2(picture.bytes, picture.name).catch(async (error: unknown) => {
      throw (await import("./model-fault.ts")).pictureFault(error, json, index, name);
    });
    editor.replaceImage(index, await encodePng(decoded));
  }
  forgetExtension(json, BASISU_TEXTURE);
  return { json, binary: editor.finish() };
}

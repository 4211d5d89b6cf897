/** The pictures of a package: as they are in the model where viewers of USDZ can read them, else as PNG. */
import type { JsonObject } from "../gltf-json.ts";
import { type EncodedImage, imageBytes } from "../model-textures.ts";
import { decodePicture } from "../picture-decoder.ts";
import { encodePng } from "../png-encoder.ts";
import type { PackedFile } from "./usdz-archive.ts";

export class UsdPictures {
  readonly #json: JsonObject;
  readonly #binary: Uint8Array | null;
  readonly #name: string;
  readonly #files = new Map<number, { readonly path: string; readonly image: EncodedImage }>();

  constructor(json: JsonObject, binary: Uint8Array | null, name: string) {
    this.#json = json;
    this.#binary = binary;
    this.#name = name;
  }

  /** Where an image of the model will lie; undefined for one that it has not. */
  pathOf(index: number): string | undefined {
    const known = this.#files.get(index);
    if (known !== undefined) return known.path;
    const image = imageBytes(this.#json, this.#binary, index, this.#name);
    if (image === null) return undefined;
    const path = `textures/${index}.${isJpeg(image.bytes) ? "jpg" : "png"}`;
    this.#files.set(index, { path, image });
    return path;
  }

  /** All that were asked for. Throws "bad-picture" for one that has to be written anew and cannot be read. */
  async files(): Promise<PackedFile[]> {
    const files: PackedFile[] = [];
    for (const { path, image } of this.#files.values()) {
      const isAsItIs = isJpeg(image.bytes) || isPng(image.bytes);
      files.push({
        path,
        bytes: isAsItIs ? image.bytes : await encodePng(await decodePicture(image.bytes, image.name)),
      });
    }
    return files;
  }
}

const isJpeg = (bytes: Uint8Array): boolean => bytes[0] === 0xff && bytes[1] === 0xd8;
const isPng = (bytes: Uint8Array): boolean => bytes[0] === 0x89 && bytes[1] === 0x50;

/** KTX 2.0 files of Basis Universal, encoded as tests need them. */
import * as encoders from "ktx2-encoder";
import type { Picture } from "../../web/engine/engine-api.ts";
import { buildGlb, type ModelParts, plane } from "./model-builder.ts";

export type BasisKind = "ETC1S" | "UASTC" | "UASTC, packed by Zstandard";

/** What Node finds in the package; its types there are those for pages. */
const { NodeBasisEncoder } = encoders as unknown as { readonly NodeBasisEncoder: new () => Encoder };

interface Encoder {
  init(): Promise<unknown>;
  encode(bytes: Uint8Array, options: encoders.IEncodeOptions): Promise<Uint8Array>;
}

let started: Promise<Encoder> | null = null;

/** It tells of each step, to what the console's log is while it starts. */
async function quietEncoder(): Promise<Encoder> {
  const { log } = console;
  console.log = () => undefined;
  const encoder = new NodeBasisEncoder();
  await encoder.init().finally(() => {
    console.log = log;
  });
  return encoder;
}

/** The picture with mip levels, its colours as sRGB. */
export async function ktx2File(picture: Picture, kind: BasisKind): Promise<Uint8Array> {
  const { width, height, rgba } = picture;
  started ??= quietEncoder();
  return await (await started).encode(new Uint8Array(), {
    isUASTC: kind !== "ETC1S",
    needSupercompression: kind === "UASTC, packed by Zstandard",
    qualityLevel: 255,
    generateMipmap: true,
    enableDebug: false,
    imageDecoder: () => Promise.resolve({ width, height, data: rgba }),
  });
}

/** Soft colours and a soft edge of alpha, which block compression keeps well. */
export function softPicture(width: number, height: number): Picture {
  const rgba = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const u = x / width;
      const v = y / height;
      rgba.set([40 + 180 * u, 60 + 120 * v, 200 - 90 * u, 128 + 127 * v], (y * width + x) * 4);
    }
  }
  return { width, height, rgba };
}

/** The extension that says that a texture is KTX 2.0. */
export const KTX2_TEXTURE = "KHR_texture_basisu";

/** A square whose one material has the picture as KTX 2.0 alone. */
export function ktx2Model(ktx2: Uint8Array, parts: Partial<ModelParts> = {}): Uint8Array {
  return buildGlb({
    meshes: [plane(1, 0)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ extensions: { [KTX2_TEXTURE]: { source: 0 } } }],
    images: [{ bytes: ktx2, mimeType: "image/ktx2", name: "paint" }],
    more: { extensionsUsed: [KTX2_TEXTURE], extensionsRequired: [KTX2_TEXTURE] },
    ...parts,
  });
}

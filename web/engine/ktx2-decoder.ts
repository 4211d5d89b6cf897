/**
 * KTX 2.0 files of Basis Universal (ETC1S and UASTC) to straight-alpha RGBA, by the same WebAssembly in the browser and in Node.
 * Loaded by the first model with KHR_texture_basisu.
 */
import { MAX_SIZE } from "../core/sizes.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { type BasisTranscoder, type Ktx2File, startBasis } from "./basis-transcoder.ts";
import type { Picture } from "./engine-api.ts";
import { badPicture } from "./picture-header.ts";

/** The transcoder's number for 32 bits a pixel, uncompressed. */
const RGBA32 = 13;

const AS_PNG = "Export the model with PNG, JPEG, WebP or AVIF textures.";

let started: Promise<BasisTranscoder> | null = null;

/** Rejects with "missing-file" and what WebAssembly says; a later call tries again. */
function transcoder(): Promise<BasisTranscoder> {
  started ??= startBasis().catch((error: unknown) => {
    started = null;
    throw error;
  });
  return started;
}

/** The finest level of a 2D texture. Rejects with "bad-picture" naming the file, and with "missing-file". */
export async function decodeKtx2(bytes: Uint8Array, name: string): Promise<Picture> {
  const { KTX2File } = await transcoder();
  try {
    const file = new KTX2File(bytes);
    try {
      return readFile(file, name);
    } finally {
      file.close();
      file.delete();
    }
  } catch (cause) {
    if (cause instanceof TexelcastError) throw cause;
    // After a trap its memory is not to be trusted.
    started = null;
    throw damaged(name, cause);
  }
}

function readFile(file: Ktx2File, name: string): Picture {
  if (!file.isValid()) throw damaged(name);
  if (!file.isUASTC() && !file.isETC1S()) {
    throw badPicture(name, "ktx2-kind", "it is a KTX2 texture of another kind than ETC1S and UASTC", AS_PNG);
  }
  const width = file.getWidth();
  const height = file.getHeight();
  if (width < 1 || height < 1) throw badPicture(name, "no-pixels", `it says it is ${width} × ${height} pixels`);
  if (width > MAX_SIZE || height > MAX_SIZE) {
    const problem = `it has ${width} × ${height} pixels, and ${MAX_SIZE} along a side is the most`;
    throw badPicture(name, "too-many-pixels", problem, "Make it smaller.");
  }
  if (file.getLayers() > 1 || file.getFaces() !== 1) {
    throw badPicture(name, "ktx2-kind", "it is a KTX2 array or cube, and not one picture", AS_PNG);
  }
  if (!file.startTranscoding()) throw damaged(name);
  const rgba = new Uint8Array(width * height * 4);
  if (file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32) !== rgba.length) throw damaged(name);
  if (!file.transcodeImage(rgba, 0, 0, 0, RGBA32, 0, -1, -1)) throw damaged(name);
  return { width, height, rgba };
}

const damaged = (name: string, cause?: unknown): TexelcastError =>
  badPicture(name, "damaged", "its KTX2 data is damaged", "Save or download it again.", cause);

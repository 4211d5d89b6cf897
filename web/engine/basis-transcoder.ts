/** The Basis Universal transcoder, which set-up makes of three's (scripts/bootstrap/basis-glue.mjs). */
import { readCodec } from "./codec-wasm.ts";

export interface BasisTranscoder {
  /** Once, before the first file. */
  initializeBasis(): void;
  readonly KTX2File: new (bytes: Uint8Array) => Ktx2File;
}

/** A KTX 2.0 file in the transcoder's memory, until it is deleted. Numbers stand for true (not 0) and false. */
export interface Ktx2File {
  isValid(): boolean;
  isUASTC(): boolean;
  isETC1S(): boolean;
  getWidth(): number;
  getHeight(): number;
  /** 0 where it is no array. */
  getLayers(): number;
  /** 6 for a cube. */
  getFaces(): number;
  /** Reads what all levels share. */
  startTranscoding(): number;
  getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number;
  /** `alphaForOpaque`: 0; channels: -1, those of the format. */
  transcodeImage(
    out: Uint8Array,
    level: number,
    layer: number,
    face: number,
    format: number,
    alphaForOpaque: number,
    colorChannel: number,
    alphaChannel: number,
  ): number;
  close(): void;
  delete(): void;
}

type StartBasis = (options: {
  readonly wasmBinary: Uint8Array;
  print(line: string): void;
  printErr(line: string): void;
}) => Promise<BasisTranscoder>;

/** A transcoder of its own. Rejects with "missing-file". */
export async function startBasis(): Promise<BasisTranscoder> {
  const glue: { readonly default: unknown } = await import("../../build/basis/basis-transcoder.js");
  // It would write its complaints of damaged files to the console, where they look like faults of the page.
  const quiet = (): void => undefined;
  const options = { wasmBinary: await readCodec("basis"), print: quiet, printErr: quiet };
  const transcoder = await (glue.default as StartBasis)(options);
  transcoder.initializeBasis();
  return transcoder;
}

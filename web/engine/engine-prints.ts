/** The engine's part in printing: reports, heat maps and print files, each in its turn among the engine's calls. */
import type { Picture } from "./engine-api.ts";
import { makePrintFile } from "./print-file.ts";
import { drawPrintMap } from "./print-map.ts";
import { measurePrint } from "./print-measure.ts";
import type { PrintFile, PrintFileOptions, PrintMapKind, PrintReport } from "./print-report.ts";
import type { PrintContext } from "./print-target.ts";

/** Runs work after all calls made before, once the newest layers are drawn, their fonts and all. */
export type PrintTurn = <Result>(
  work: (context: PrintContext) => Result | Promise<Result>,
  signal?: AbortSignal,
) => Promise<Result>;

export class EnginePrints {
  readonly #turn: PrintTurn;

  constructor(turn: PrintTurn) {
    this.#turn = turn;
  }

  report(): Promise<PrintReport> {
    return this.#turn(measurePrint);
  }

  map(material: number, kind: PrintMapKind): Promise<Picture> {
    return this.#turn((context) => drawPrintMap(context, material, kind));
  }

  /** @param windowSide Side of the windows in which the texture is painted; for tests, as it changes no byte. */
  file(
    options: PrintFileOptions,
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
    windowSide?: number,
  ): Promise<PrintFile> {
    return this.#turn((context) => makePrintFile({ ...context, onProgress }, options, windowSide), signal);
  }
}

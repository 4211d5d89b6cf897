/**
 * The engine's part in printing: reports, heat maps and print files, each in its turn among the engine's calls. What makes
 * them is loaded by the first that is asked for.
 */
import type { Picture } from "./engine-api.ts";
import type { PrintFile, PrintFileOptions, PrintMapKind, PrintReport } from "./print-report.ts";
import type { PrintContext } from "./print-target.ts";

/** Runs work after all calls made before, once it is loaded and the newest layers are drawn, their fonts and all. */
export type PrintTurn = <Result>(
  load: () => Promise<(context: PrintContext) => Result | Promise<Result>>,
  signal?: AbortSignal,
) => Promise<Result>;

export class EnginePrints {
  readonly #turn: PrintTurn;

  constructor(turn: PrintTurn) {
    this.#turn = turn;
  }

  report(): Promise<PrintReport> {
    return this.#turn(async () => (await import("./print-measure.ts")).measurePrint);
  }

  map(material: number, kind: PrintMapKind): Promise<Picture> {
    return this.#turn(async () => {
      const { drawPrintMap } = await import("./print-map.ts");
      return (context) => drawPrintMap(context, material, kind);
    });
  }

  /** @param windowSide Side of the windows in which the texture is painted; for tests, as it changes no byte. */
  file(
    options: PrintFileOptions,
    onProgress?: (share: number) => void,
    signal?: AbortSignal,
    windowSide?: number,
  ): Promise<PrintFile> {
    return this.#turn(async () => {
      const { makePrintFile } = await import("./print-file.ts");
      return (context) => makePrintFile({ ...context, onProgress }, options, windowSide);
    }, signal);
  }
}

/** `texelcast check`: what the print makes of a design, and whether it may go to print. */
import { parseZones } from "../../web/editor/document/index.ts";
import { printJson } from "../../web/editor/document/print-json.ts";
import type { LayerPrint, PrintFinding, PrintReport } from "../../web/engine/print-report.ts";
import type { PrintZones } from "../../web/engine/print-zones.ts";
import { withPrintJob } from "../print-job.ts";
import { readAsset, readDesign } from "../read-design.ts";
import { decodeText, MAX_TEXT_BYTES, readFileBytes } from "../read-file.ts";
import { readModel } from "../read-model.ts";
import { formatCount, formatShare, formatTable, printable } from "../terminal-text.ts";

export interface CheckOptions {
  readonly zones?: string;
  readonly json?: true;
}

/** @returns whether nothing stands against printing it. */
export async function check(modelFile: string, designFile: string, options: CheckOptions): Promise<boolean> {
  const zones = options.zones === undefined ? null : await readZones(options.zones);
  const design = await readDesign(designFile);
  const model = await readModel(modelFile);
  const job = { ...design, model, readAsset: (key: string) => readAsset(design, key), zones };
  const report = await withPrintJob(job, (engine) => engine.printReport());
  process.stdout.write(options.json ? printJson(report) : describe(report));
  return report.violations.length === 0;
}

/** @throws TexelcastError "missing-file", "bad-zones". */
export async function readZones(file: string): Promise<PrintZones> {
  const bytes = await readFileBytes(file, { code: "bad-zones", maxBytes: MAX_TEXT_BYTES });
  const hint = "A zones file is a JSON file: save it as UTF-8.";
  return parseZones(decodeText(bytes, { code: "bad-zones", what: "the zones file", file, hint }), file);
}

const HEADING = ["layer", "DPI least", "mean", "stretch", "clipped", "hidden", "outside", "margin", "cm²"];

function describe({ layers, violations, warnings, printScale }: PrintReport): string {
  if (layers.length === 0 && violations.length === 0) return "nothing is printed: no layer is shown\n";
  const rightAligned = HEADING.map((_, column) => column > 0);
  const table = formatTable([HEADING, ...layers.map(rowOf)], rightAligned);
  const told = [
    ...violations.map((found) => describeFinding("VIOLATION", found)),
    ...warnings.map((found) => describeFinding("warning", found)),
  ];
  const verdict = violations.length === 0 ? "may be printed" : "must not be printed as it is";
  return `print scale ${printScale}\n\n${table}\n\n${told.join("")}${verdict}\n`;
}

function rowOf(layer: LayerPrint): string[] {
  return [
    printable(layer.id),
    layer.dpi === null ? "-" : layer.dpi.least.toFixed(0),
    layer.dpi === null ? "-" : layer.dpi.mean.toFixed(0),
    layer.stretch === null ? "-" : `${layer.stretch.mean.toFixed(0)} %`,
    formatShare(layer.clipped),
    formatShare(layer.hidden),
    formatShare(layer.outsideZones),
    formatShare(layer.inSafeMargin),
    formatCount(Math.round(layer.areaCm2 * 10) / 10),
  ];
}

function describeFinding(kind: string, { code, layer, zone, message, hint }: PrintFinding): string {
  const about = layer === null ? `zone ${printable(zone ?? "")}` : `layer ${printable(layer)}`;
  return `${kind} ${code}, ${about}: ${message} ${hint}\n`;
}

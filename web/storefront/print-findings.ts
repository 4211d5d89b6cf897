/** What the printer would say of a design, in the order of its weight. */
import type { PrintReport } from "../element/element-api.ts";

export interface PrintFinding {
  /** Of the picture or text that it is about. */
  readonly layer: string;
  readonly message: string;
  readonly hint: string;
  /** It must not be printed so without being seen. */
  readonly grave: boolean;
}

/** @param names of layers, by their ids */
export function printFindings(report: PrintReport, names: ReadonlyMap<string, string>): PrintFinding[] {
  const told = (finding: PrintReport["warnings"][number], grave: boolean): PrintFinding => ({
    layer: names.get(finding.layer ?? "") ?? finding.layer ?? "",
    message: finding.message,
    hint: finding.hint,
    grave,
  });
  return [
    ...report.violations.map((finding) => told(finding, true)),
    ...report.warnings.map((finding) => told(finding, false)),
  ];
}

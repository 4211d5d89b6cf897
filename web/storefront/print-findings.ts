/** What the printer would say of a design, in the order of its weight. */
import type { PrintReport } from "../element/element-api.ts";

export interface PrintFinding {
  readonly message: string;
  readonly hint: string;
  /** It must not be printed so without being seen. */
  readonly grave: boolean;
}

export function printFindings(report: PrintReport): PrintFinding[] {
  return [
    ...report.violations.map(({ message, hint }) => ({ message, hint, grave: true })),
    ...report.warnings.map(({ message, hint }) => ({ message, hint, grave: false })),
  ];
}

/** What the print's report says, in a word where it is about: on a row, under the fields, above the way out. */
import { html, nothing, type TemplateResult } from "lit";
import type { PrintFinding, PrintReport } from "../../engine/print-report.ts";
import type { Desk } from "../desk/desk.ts";
import type { Words } from "../words/words.ts";

type Shown = TemplateResult | typeof nothing;

/** The report, where the product has zones and the design was measured. */
const reportOf = ({ report, zones }: Desk): PrintReport | null => (zones === null ? null : report);

export function layerBadge(desk: Desk, id: string, words: Words): Shown {
  const report = reportOf(desk);
  const layer = report?.layers.find((each) => each.id === id);
  if (!report || !layer) return nothing;
  const of = (findings: readonly PrintFinding[]): PrintFinding[] => findings.filter((each) => each.layer === id);
  const [wrong, doubtful] = [of(report.violations), of(report.warnings)];
  const tone = wrong.length > 0 ? "bad" : doubtful.length > 0 ? "caution" : "good";
  const others = [...wrong, ...doubtful].filter(({ code }) => code !== "low-dpi").length;
  // The finding's own number where there is one: the least of all texels may be a corner that nobody sees.
  const low = [...wrong, ...doubtful].find(({ code }) => code === "low-dpi")?.value ?? layer.dpi?.mean;
  const dpi = low === undefined ? "" : words.dpi(Math.round(low));
  const text = others > 0 ? words.printIssues(wrong.length + doubtful.length) : dpi || words.printGood;
  return html`<span class="badge ${tone}" part="badge">${text}</span>`;
}

/**
 * What there is to say of a layer, whole sentences, the worse first. Where a product has no zones, that is only of its letters: what
 * stands in place of those that no font has is wrong wherever it is shown.
 */
export function layerFindings({ report, zones }: Desk, id: string, words: Words): Shown {
  const { violations = [], warnings = [] } = report ?? {};
  const found = [
    ...violations.map((finding) => ({ finding, tone: "bad" })),
    ...warnings.map((finding) => ({ finding, tone: "caution" })),
  ].filter(({ finding: { layer, code } }) => layer === id && (zones !== null || code === "missing-characters"));
  if (found.length === 0) return nothing;
  return html`<ul class="findings" part="findings" role="list">
    ${found.map(({ finding, tone }) => {
      const { message, hint } = words.finding(finding, tone === "bad");
      return html`<li class=${tone}><p>${message}</p><p>${hint}</p></li>`;
    })}
  </ul>`;
}

/** All in all, and how much is printed. */
export function verdict(desk: Desk, words: Words): Shown {
  const report = reportOf(desk);
  if (!report || report.layers.length === 0) return nothing;
  const { violations, warnings, whole } = report;
  const count = violations.length + warnings.length;
  const tone = violations.length > 0 ? "bad" : count > 0 ? "caution" : "good";
  return html`<div class="line" role="status">
    <span class="badge ${tone}" part="badge">${count === 0 ? words.printGood : words.printIssues(count)}</span>
    <span>${words.area(whole.areaCm2.toFixed(1))}</span>
  </div>`;
}

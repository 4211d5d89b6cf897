/** What the element's events carry of a design. */
import type { ChangeDetail, LoadDetail, SubmitDetail } from "../element-api.ts";
import type { Mode } from "../mode.ts";
import { countsOf, DesignExport } from "./export-design.ts";
import { exportTexture, layerAreas, printOptions, printReport } from "./prints.ts";

/** Measures the design, for its badges, too; null where it is another one by then. */
export async function changeDetail(mode: Mode, exports: DesignExport): Promise<ChangeDetail | null> {
  const { desk } = mode;
  const { design } = desk;
  const named = await exports.named(design);
  const report = await printReport(mode);
  if (desk.design !== design || desk.closed) return null;
  desk.report = report;
  const areas = layerAreas(mode, report);
  const totalArea = areas.reduce((sum, { area }) => sum + area, 0);
  const { undoLabel, redoLabel } = desk.store.state;
  const steps = { canUndo: undoLabel !== null, canRedo: redoLabel !== null };
  return { design: named, counts: countsOf(design), areas, totalArea, ...steps };
}

export async function submitDetail(mode: Mode): Promise<SubmitDetail> {
  const { desk } = mode;
  const exported = await new DesignExport().whole(desk.design);
  const print = printOptions(mode, {}, desk.settings);
  const texture = await exportTexture(mode, print);
  const report = desk.zones === null ? null : await printReport(mode);
  return { ...exported, print, texture, report };
}

export function loadDetail({ desk }: Mode, began: number): LoadDetail {
  const materials = (desk.store.state.model?.info.materials ?? []).map(({ index, name, refusal }) => ({
    index,
    name,
    paintable: refusal === null,
  }));
  return { materials, milliseconds: Math.round(performance.now() - began) };
}

export { DesignExport } from "./export-design.ts";

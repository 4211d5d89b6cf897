/** What the element's events carry of a design. */
import type { ChangeDetail, SubmitDetail } from "../element-api.ts";
import type { AtDesk } from "../mode.ts";
import type { Desk } from "./desk.ts";
import { countsOf, DesignExport } from "./export-design.ts";
import { exportTexture, layerAreas, printOptions, printReport } from "./prints.ts";

/** What was met of each desk's files. */
const met = new WeakMap<Desk, DesignExport>();

/** Measures the design, for its badges, too; null where it is another one by then, or another is shown. */
export async function changeDetail(mode: AtDesk): Promise<ChangeDetail | null> {
  const { desk } = mode;
  const { design } = desk;
  const exports = met.get(desk) ?? new DesignExport();
  met.set(desk, exports);
  const named = await exports.named(design);
  const report = await printReport(mode);
  if (desk.design !== design || !desk.atRest || desk.closed) return null;
  desk.report = report;
  const areas = layerAreas(mode, report);
  const totalArea = areas.reduce((sum, { area }) => sum + area, 0);
  const { undoLabel, redoLabel } = desk.store.state;
  const steps = { canUndo: undoLabel !== null, canRedo: redoLabel !== null };
  return { design: named, counts: countsOf(design), areas, totalArea, ...steps };
}

/**
 * The design, the texture and the report of one moment: what was typed or dragged up to the call is in it, and where the user
 * goes on meanwhile all is made anew. Rejects with "cancelled" where the desk is closed.
 * @param tellChange tells the page of the newest change: what it takes for approved must be the last that it heard of
 */
export async function submitDetail(mode: AtDesk, tellChange: () => Promise<void>): Promise<SubmitDetail> {
  const { desk } = mode;
  for (;;) {
    await mode.idle();
    desk.keepShown();
    const { design } = desk;
    const exported = await new DesignExport().whole(design);
    const print = printOptions(mode, {}, desk.settings);
    const texture = await exportTexture(mode, print);
    const report = desk.zones === null ? null : await printReport(mode);
    await tellChange().catch(() => undefined);
    if (desk.design === design && desk.atRest) return { ...exported, print, texture, report };
  }
}

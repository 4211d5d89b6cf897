/** How much memory the history may hold: the user's choice, kept by the browser from visit to visit. */
import { keepChoice, keptChoice } from "../storage/kept-choice.ts";
import { DEFAULT_BUDGET } from "./history.ts";
import { MEBIBYTE } from "./megabytes.ts";

const KEY = "texelcast.history-budget";

/** Bytes. */
export const HISTORY_BUDGETS: readonly number[] = [32, 64, 128, 256, 512, 1024].map((count) => count * MEBIBYTE);

/** The default where nothing was chosen. */
export function readHistoryBudget(): number {
  const chosen = Number(keptChoice(KEY));
  return HISTORY_BUDGETS.includes(chosen) ? chosen : DEFAULT_BUDGET;
}

/** Bytes. */
export const keepHistoryBudget = (bytes: number): void => keepChoice(KEY, String(bytes));

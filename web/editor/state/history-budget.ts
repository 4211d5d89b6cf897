/** How much memory the history may hold: the user's choice, kept by the browser from visit to visit. */
import { DEFAULT_BUDGET } from "./history.ts";
import { MEBIBYTE } from "./megabytes.ts";

const KEY = "texelcast.history-budget";

/** Bytes. */
export const HISTORY_BUDGETS: readonly number[] = [32, 64, 128, 256, 512, 1024].map((count) => count * MEBIBYTE);

/** The default where nothing was chosen, or the browser lets the page keep nothing. */
export function readHistoryBudget(): number {
  try {
    const chosen = Number(localStorage.getItem(KEY));
    return HISTORY_BUDGETS.includes(chosen) ? chosen : DEFAULT_BUDGET;
  } catch {
    return DEFAULT_BUDGET;
  }
}

/** A browser that lets the page keep nothing forgets the choice with the page. */
export function keepHistoryBudget(bytes: number): void {
  try {
    localStorage.setItem(KEY, String(bytes));
  } catch {
    // The choice holds until the page is closed, which is all that can be done.
  }
}

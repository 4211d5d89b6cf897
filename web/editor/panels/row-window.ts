/** Which rows of a long list stand in the document: those in sight, and some to either side. All rows are of one height. */

/** Rows to either side of those in sight: a turn of the wheel must not show a gap before the page has come to fill it. */
const MARGIN = 12;
/** It moves on by so many rows at once, so that not every pixel of a scrolling renders the list. */
const STEP = 8;

/** Places of rows, the first included and the last not. */
export interface RowWindow {
  readonly first: number;
  readonly end: number;
}

/** Before the list has a size: as many as most lists have. */
export const FIRST_WINDOW: RowWindow = { first: 0, end: 2 * MARGIN };

/**
 * The window around what is in sight.
 *
 * @param top How far the list is scrolled, in rows.
 * @param height How much of it is seen, in rows.
 */
export function rowWindow(top: number, height: number): RowWindow {
  const first = STEP * Math.floor(top / STEP) - MARGIN;
  const end = STEP * Math.ceil((top + height) / STEP) + MARGIN;
  return { first: Math.max(0, first), end };
}

/** Places of the rows to be rendered, from the top: those in the window, and those that must be there wherever they are. */
export function renderedRows<Row>(
  rows: readonly Row[],
  { first, end }: RowWindow,
  isNeeded: (row: Row) => boolean,
): number[] {
  return [...rows.keys()].filter((at) => (at >= first && at < end) || isNeeded(rows[at] as Row));
}

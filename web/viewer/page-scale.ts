/** What a part of the page that is scaled makes of a view. */

/**
 * A view's own pixels for one of the window's, of which it is `width` wide. To hundredths: what it is wide is told in whole pixels,
 * and where nothing is scaled places stay as they are.
 */
export const scaleOf = (element: HTMLElement, width: number): number =>
  Number((element.offsetWidth / width).toFixed(2)) || 1;

/** Shapes of the page in which one view is seen at a time, with a sheet for the rest: media queries, no two of them at once. */
/** A phone held upright: the sheet lies below the view. With its keyboard open it is low as well. */
export const NARROW = "(max-width: 34.99rem), (max-width: 720px) and (min-height: 30.01rem)";
/** A phone on its side, or a window as low: the sheet stands beside the view. */
export const SIDEWAYS = "(min-width: 35rem) and (max-width: 60rem) and (max-height: 30rem)";

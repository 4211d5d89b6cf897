/** Colours of browsers that know no `light-dark()` (Safari before 17.5, Chrome before 123). */

/** Both colours, in each of which functions may stand. */
const PAIR = /light-dark\(((?:[^(),]|\([^)]*\))+),(?:[^()]|\([^)]*\))+\)/g;

/** The style with the first of each pair: whether a page is dark cannot be told there for each place of it. */
export const inLight = (style: string): string => style.replace(PAIR, "$1");

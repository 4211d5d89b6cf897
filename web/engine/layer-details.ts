/** What the core is told of a layer beside its def: a stroke's dabs, a fill's gradient and triangles. */
import type { CoreGradient } from "../core/abi.ts";
import type { LayerHandle, Target } from "../core/target.ts";
import { coreDab } from "./core-layer.ts";
import type { EngineDab } from "./engine-api.ts";
import { sameItems } from "./same-items.ts";

export interface LayerDetails {
  readonly dabs: readonly EngineDab[];
  readonly gradient: Partial<CoreGradient> | null;
  /** Null: everywhere. */
  readonly triangles: Uint32Array | null;
}

export const NO_DETAILS: LayerDetails = { dabs: [], gradient: null, triangles: null };

/** Brings what the core has in line, by what it was told before. A stroke that grew is told of its new dabs alone. */
export function syncDetails(target: Target, layer: LayerHandle, had: LayerDetails, wanted: LayerDetails): void {
  if (!sameGradients(had.gradient, wanted.gradient)) target.setGradient(layer, wanted.gradient);
  if (!sameTriangles(had.triangles, wanted.triangles)) target.setTriangles(layer, wanted.triangles);
  let kept = commonDabs(had.dabs, wanted.dabs);
  if (kept < had.dabs.length) {
    target.clearDabs(layer);
    kept = 0;
  }
  if (kept < wanted.dabs.length) target.addDabs(layer, wanted.dabs.slice(kept).map(coreDab));
}

/** Whether the core need not be told of the change. */
export const sameDetails = (a: LayerDetails, b: LayerDetails): boolean =>
  a.dabs.length === b.dabs.length &&
  commonDabs(a.dabs, b.dabs) === a.dabs.length &&
  sameGradients(a.gradient, b.gradient) &&
  sameTriangles(a.triangles, b.triangles);

/** How many dabs two lists begin with alike. */
function commonDabs(a: readonly EngineDab[], b: readonly EngineDab[]): number {
  for (let i = 0; ; i++) {
    const [left, right] = [a[i], b[i]];
    // Lists that grow share their objects, so the numbers are seldom looked at.
    if (!left || !right || (left !== right && !sameNumbersOf(coreDab(left), coreDab(right)))) return i;
  }
}

const sameGradients = (a: Partial<CoreGradient> | null, b: Partial<CoreGradient> | null): boolean =>
  a === b || (a !== null && b !== null && sameNumbersOf(a, b));

const sameTriangles = (a: Uint32Array | null, b: Uint32Array | null): boolean =>
  a === b || (a !== null && b !== null && sameItems(a, b));

type Numbers = Readonly<Record<string, number | readonly number[] | undefined>>;

/** Whether two structs have the same numbers in all fields; NaN is the same as NaN, and −0 is not 0. */
export function sameNumbersOf(a: Numbers, b: Numbers): boolean {
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].every((key) => sameNumbers(a[key], b[key]));
}

function sameNumbers(a: number | readonly number[] | undefined, b: number | readonly number[] | undefined): boolean {
  return typeof a === "object" && typeof b === "object" ? sameItems(a, b) : Object.is(a, b);
}

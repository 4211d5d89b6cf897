/** What a demo model says about its own parts, in glTF's `extras`: the page reads it for its guide and its parts list. */

import { type Atlas, type PlacedChart, placedChart } from "../geometry/atlas.ts";

/** A named place of the texture. */
export interface GuideEntry {
  readonly part: string;
  /** The side of the part, where it has several in the guide. */
  readonly face?: string;
  /** Least u and v, greatest u and v. */
  readonly uv: readonly [number, number, number, number];
}

export interface PartData {
  /** On a material: the places of its texture. */
  readonly guide?: readonly GuideEntry[];
  /** On a node: parts of one group are listed together. */
  readonly group?: string;
  /** On a node: not shown until the user shows it. */
  readonly hidden?: boolean;
}

/** Extras as the page reads them; other programs keep them and look away. */
export function partData(data: PartData): Record<string, unknown> {
  return { texelcast: data };
}

/** The charts of an atlas by name; `names` says which, and what they are called. */
export function atlasGuide(atlas: Atlas, names: Readonly<Record<string, string>>): GuideEntry[] {
  return Object.entries(names).map(([chart, part]) => ({ part, uv: uvBox(atlas, placedChart(atlas, chart)) }));
}

function uvBox(atlas: Atlas, { x, y, width, height }: PlacedChart): GuideEntry["uv"] {
  const tidy = (value: number): number => Math.round(value * 1e6) / 1e6;
  return [
    tidy(x / atlas.width),
    tidy(y / atlas.height),
    tidy((x + width) / atlas.width),
    tidy((y + height) / atlas.height),
  ];
}

/** What is in a target's map, as a picture for people to look at and as numbers; loaded when one is asked for. */
import { MapViews } from "../core/abi.ts";
import type { Target } from "../core/target.ts";
import { checkValue, oneOf } from "./check-value.ts";
import type { MapView, Picture } from "./engine-api.ts";
import type { OpenTarget } from "./open-target.ts";

export type MapChannel = "positions" | "normals" | "coverage" | "overlap";

/** @throws TexelcastError "bad-argument" for another view. */
export function mapView(target: OpenTarget, view: MapView): Picture {
  checkValue(view, oneOf(...Object.keys(MapViews)), "view");
  return target.picture((row, count) => target.core.view(MapViews[view], row, count));
}

export function mapRows(target: Target, channel: MapChannel, row: number, rowCount: number): Float32Array | Uint8Array {
  switch (channel) {
    case "positions":
      return target.readPositions(row, rowCount);
    case "normals":
      return target.readNormals(row, rowCount);
    case "coverage":
      return target.readCoverage(row, rowCount);
    case "overlap":
      return target.readOverlap(row, rowCount);
  }
}

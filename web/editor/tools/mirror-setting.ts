/** The plane across which a tool paints a second time. */
import type { ModelInfo } from "../../engine/engine-api.ts";
import type { Mirror } from "../document/index.ts";

export type MirrorSetting = "none" | Mirror["axis"];

const AXES = { x: 0, y: 1, z: 2 } as const;
/** Of the model's extent: a middle this near to the origin's plane is that plane, whatever a mug's handle adds to a side. */
const CENTRED = 0.2;

/** The model's own plane of symmetry across an axis: through the origin where the model stands about it. */
export function mirrorOf(
  setting: MirrorSetting,
  info: Pick<ModelInfo, "boundsMin" | "boundsMax"> | null,
): Mirror | null {
  if (setting === "none" || info === null) return null;
  const axis = AXES[setting];
  const [low, high] = [info.boundsMin[axis], info.boundsMax[axis]];
  const middle = (low + high) / 2;
  return { axis: setting, offset: Math.abs(middle) <= CENTRED * (high - low) ? 0 : middle, readable: false };
}

/** Keys of a brush: [ and ] its size, with Shift its hardness; digits its opacity. */
import { bracketOf } from "../state/bracket-key.ts";
import type { ToolSettings } from "./tool-settings.ts";
import type { Toolbox } from "./toolbox.ts";

const SIZE_STEP = 1.12;
const HARDNESS_STEP = 0.1;

/** True when the key was one of them. */
export function handleBrushKey(event: KeyboardEvent, tools: Toolbox): boolean {
  const change = brushKeyChange(event, tools.settings, tools.sizes);
  if (change === null) return false;
  tools.configure(change);
  return true;
}

/** What a key sets; null for other keys. `sizes`: those that the brush's field takes, metres. */
export function brushKeyChange(
  event: Pick<KeyboardEvent, "code" | "key" | "shiftKey">,
  { size, hardness }: Pick<ToolSettings, "size" | "hardness">,
  sizes: { readonly least: number; readonly most: number },
): Partial<ToolSettings> | null {
  const direction = bracketOf(event);
  if (direction !== null) {
    if (event.shiftKey) {
      const steps = Math.round(hardness / HARDNESS_STEP) + direction;
      return { hardness: Math.min(1, Math.max(0, Number((steps * HARDNESS_STEP).toFixed(2)))) };
    }
    if (size === null) return {};
    return { size: Math.min(sizes.most, Math.max(sizes.least, size * SIZE_STEP ** direction)) };
  }
  if (event.shiftKey || !/^\d$/.test(event.key)) return null;
  return { opacity: event.key === "0" ? 1 : Number(event.key) / 10 };
}

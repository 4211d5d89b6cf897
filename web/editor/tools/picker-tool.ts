/** The colour picker: takes what lies under the pointer, for as long as it is held. */
import { Pipette } from "lucide";
import { PickCursor } from "./pick-cursor.ts";
import type { PixelProbe } from "./pixel-probe.ts";
import type { Tool } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

export function pickerTool(context: ToolContext, probe: PixelProbe): Tool {
  const cursor = new PickCursor(context, (hit) => probe.pick(hit));
  return {
    id: "picker",
    label: ({ tools }) => tools.picker,
    icon: Pipette,
    shortcut: "I",
    options: ["color"],
    input: {
      cursor: "crosshair",
      down: ({ hit }) => {
        cursor.hide();
        probe.pick(hit);
        return hit !== null;
      },
      move: (samples) => probe.pick(samples.at(-1)?.hit ?? null),
      up: () => {},
      interrupted: () => {},
      hover: (sample) => {
        if (sample !== null) cursor.hide();
      },
    },
    key: (event, view) => cursor.key(event, view !== null),
    deactivate: () => cursor.hide(),
    forget: () => cursor.hide(),
  };
}

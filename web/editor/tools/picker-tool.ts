/** The colour picker: takes what lies under the pointer, for as long as it is held. */
import { Pipette } from "lucide";
import type { PixelProbe } from "./pixel-probe.ts";
import type { Tool } from "./tool.ts";

export function pickerTool(probe: PixelProbe): Tool {
  return {
    id: "picker",
    label: ({ tools }) => tools.picker,
    icon: Pipette,
    shortcut: "I",
    options: ["color"],
    input: {
      cursor: "crosshair",
      down: ({ hit }) => {
        probe.pick(hit);
        return hit !== null;
      },
      move: (samples) => probe.pick(samples.at(-1)?.hit ?? null),
      up: () => {},
      interrupted: () => {},
      hover: () => {},
    },
  };
}

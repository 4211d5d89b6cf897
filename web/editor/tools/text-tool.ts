/** The text tool: a click puts words on the surface, and the panel has them typed. */
import { Type } from "lucide";
import type { TextCommands } from "../state/text-commands.ts";
import type { Tool } from "./tool.ts";
import type { Toolbox } from "./toolbox.ts";

export function textTool(texts: TextCommands, tools: Toolbox): Tool {
  return {
    id: "text",
    label: ({ text }) => text.tool,
    icon: Type,
    shortcut: "T",
    options: [],
    input: {
      cursor: "text",
      down: ({ hit, view }) => {
        if (hit === null || view.kind !== "model") return false;
        // Placed, the words are moved and sized like any decal.
        void texts.add(hit).then(() => tools.choose("move"));
        return true;
      },
      move: () => {},
      up: () => {},
      interrupted: () => {},
      hover: () => {},
    },
  };
}

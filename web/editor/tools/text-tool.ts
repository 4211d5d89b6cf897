/** The text tool: a click puts words on the surface, and the panel has them typed. */
import { html } from "lit";
import { Type } from "lucide";
import type { TextCommands } from "../state/text-commands.ts";
import type { Strings } from "../strings.ts";
import type { Tool } from "./tool.ts";
import type { Toolbox } from "./toolbox.ts";

export function textTool(texts: TextCommands, tools: Toolbox, words: () => Strings["text"]): Tool {
  return {
    id: "text",
    label: ({ text }) => text.tool,
    icon: Type,
    shortcut: "T",
    options: [],
    // Nothing else of the page changes with it, and a finger shows no cursor.
    renderOptions: () => html`<p>${words().pressPlace}</p>`,
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

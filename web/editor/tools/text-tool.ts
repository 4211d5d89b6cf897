/** The text tool: a press, or a key at the mark that arrows move, puts words on the surface, and the panel has them typed. */
import { html } from "lit";
import { Type } from "lucide";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import type { TextCommands } from "../state/text-commands.ts";
import { PickCursor } from "./pick-cursor.ts";
import type { Tool } from "./tool.ts";
import type { ToolContext } from "./tool-context.ts";

type Context = Pick<ToolContext, "viewer" | "textureView" | "board" | "store" | "tools">;

export function textTool(texts: TextCommands, context: Context): Tool {
  // Placed, the words are moved and sized like any decal.
  const put = (hit: SurfaceHit): void => void texts.add(hit).then(() => context.tools.choose("move"));
  const cursor = new PickCursor(context, put);
  return {
    id: "text",
    label: ({ text }) => text.tool,
    icon: Type,
    shortcut: "T",
    options: [],
    // Nothing else of the page changes with it, and a finger shows no cursor.
    renderOptions: () => html`<p>${context.board.strings.text.pressPlace}</p>`,
    input: {
      cursor: "text",
      down: ({ hit, view }) => {
        cursor.hide();
        if (hit === null || view.kind !== "model") return false;
        put(hit);
        return true;
      },
      move: () => {},
      up: () => {},
      interrupted: () => {},
      hover: (sample) => {
        if (sample !== null) cursor.hide();
      },
    },
    key: (event, view) => cursor.key(event, view === "model"),
    deactivate: () => cursor.hide(),
    forget: () => cursor.hide(),
  };
}

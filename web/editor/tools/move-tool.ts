/** Decals: chosen, dragged, turned and sized by the views' own handles. */
import { MousePointer2 } from "lucide";
import type { Tool } from "./tool.ts";

export const moveTool: Tool = {
  id: "move",
  label: ({ tools }) => tools.move,
  icon: MousePointer2,
  shortcut: "V",
  options: [],
  input: null,
};

/** A tool that takes nothing: with it the view can be turned, and what lies on the model stays where it is. */
import type { ToolInput } from "./viewer-api.ts";

export const LOOK_ONLY: ToolInput = {
  cursor: "grab",
  down: () => false,
  move: () => undefined,
  up: () => undefined,
  interrupted: () => undefined,
  hover: () => undefined,
};

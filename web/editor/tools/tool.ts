/** What a tool is: how it is chosen, which settings it reads, and what it does with a view's pointer. */
import type { TemplateResult } from "lit";
import type { IconNode } from "lucide";
import type { ToolInput } from "../../viewer/viewer-api.ts";
import type { Strings } from "../strings.ts";

export const TOOL_IDS = [
  "move",
  "brush",
  "eraser",
  "pencil",
  "clone",
  "bucket",
  "line",
  "rectangle",
  "picker",
  "text",
  "fill",
  "gradient",
  "parts",
] as const;
export type ToolId = (typeof TOOL_IDS)[number];

/** Fields of the options bar, in its order. */
export const TOOL_OPTIONS = [
  "color",
  "tip",
  "size",
  "pixelSize",
  "hardness",
  "flow",
  "opacity",
  "spacing",
  "stabiliser",
  "pressure",
  "mirror",
  "tolerance",
  "contiguous",
  "filled",
  "alphaLock",
  "aligned",
] as const;
export type ToolOption = (typeof TOOL_OPTIONS)[number];

/** What the options bar lays open: seldom used options, colours, brush tips. */
export type ToolPanel = "more" | "palette" | "tips";

/** What stands in front of the sheet's tabs: that, or how the model is shown. */
export type LaidOpen = ToolPanel | "view";

export interface Tool {
  readonly id: ToolId;
  /** What it is called in the rail and by screen readers. */
  readonly label: (strings: Strings) => string;
  readonly icon: IconNode;
  /** A letter that chooses it, upper case, or "". */
  readonly shortcut: string;
  /** What of the options bar it reads. */
  readonly options: readonly ToolOption[];
  /** Both views' pointer while it is chosen; null leaves it to the decals and to panning. */
  readonly input: ToolInput | null;
  /** Whether the rail offers it now; default always. Read when the state changes. */
  readonly offered?: () => boolean;
  /** What is chosen in its place once it is not; default the brush. */
  readonly instead?: ToolId;
  /** Fields of its own in the options bar, before the common ones. */
  readonly renderOptions?: () => TemplateResult;
  readonly activate?: () => void;
  /** Ends what the pointer has under way, without a trace; false where nothing is. */
  readonly cancel?: () => boolean;
  /** Ends what is under way as if the pointer had been let go: it is the user's work. */
  readonly finish?: () => void;
  /** Another tool was chosen; what is under way must end. */
  readonly deactivate?: () => void;
  /** Another model is open, chosen or not: places on the one before mean nothing any more. */
  readonly forget?: () => void;
  /**
   * A key pressed while it is chosen and the focus is on the page or on a view, before the page's own meaning. True took it.
   */
  readonly key?: (event: KeyboardEvent, view: "model" | "texture" | null) => boolean;
}

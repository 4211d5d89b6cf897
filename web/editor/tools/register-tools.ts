/** The tools that paint, put into the toolbox. */
import { BrushTool } from "./brush-tool.ts";
import { moveTool } from "./move-tool.ts";
import { pickerTool } from "./picker-tool.ts";
import { PixelProbe } from "./pixel-probe.ts";
import type { ToolContext } from "./tool-context.ts";

export function registerTools(context: ToolContext): void {
  const probe = new PixelProbe(context);
  context.tools.register(
    moveTool,
    new BrushTool("brush", context, probe),
    new BrushTool("eraser", context, probe),
    pickerTool(probe),
  );
}

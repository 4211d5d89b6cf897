/** The tools that paint, put into the toolbox. */
import { BrushTool } from "./brush-tool.ts";
import { EraserTool } from "./eraser-tool.ts";
import { moveTool } from "./move-tool.ts";
import { pickerTool } from "./picker-tool.ts";
import { PixelProbe } from "./pixel-probe.ts";
import { PixelSession } from "./pixel-session.ts";
import { type PixelKind, PixelTool } from "./pixel-tool.ts";
import type { ToolContext } from "./tool-context.ts";

export function registerTools(context: ToolContext): void {
  const probe = new PixelProbe(context);
  const pixels = new PixelSession(context);
  const pixelTool = (kind: PixelKind): PixelTool => new PixelTool(kind, context, pixels, probe);
  context.tools.register(
    moveTool,
    new BrushTool("brush", context, probe),
    new EraserTool(context, new BrushTool("eraser", context, probe), pixelTool("eraser")),
    pixelTool("pencil"),
    pixelTool("bucket"),
    pixelTool("line"),
    pixelTool("rectangle"),
    pickerTool(probe),
  );
}

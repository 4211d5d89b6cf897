/** The tools that paint, put into the toolbox. */
import { BrushTool } from "./brush-tool.ts";
import { CloneBrush } from "./clone-brush.ts";
import { EraserTool } from "./eraser-tool.ts";
import { moveTool } from "./move-tool.ts";
import { eraserBrush, paintBrush } from "./paint-brushes.ts";
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
    new BrushTool(paintBrush(context, probe), context),
    new EraserTool(context, new BrushTool(eraserBrush(context), context), pixelTool("eraser")),
    new BrushTool(new CloneBrush(context), context),
    pixelTool("pencil"),
    pixelTool("bucket"),
    pixelTool("line"),
    pixelTool("rectangle"),
    pickerTool(context, probe),
  );
}

/** Brush and eraser: what they paint with, and where it goes. */
import { Brush as BrushIcon, Eraser } from "lucide";
import type { Brush } from "../document/index.ts";
import { strings } from "../strings.ts";
import type { BrushKind } from "./brush-tool.ts";
import { mirrorOf } from "./mirror-setting.ts";
import { paintTargetOf, withStroke } from "./paint-target.ts";
import type { PixelProbe } from "./pixel-probe.ts";
import { type PaintGesture, StrokeGesture } from "./stroke-gesture.ts";
import type { ToolContext } from "./tool-context.ts";
import { withRecent } from "./tool-settings.ts";

const COMMON = ["size", "hardness", "flow", "opacity", "spacing", "stabiliser", "pressure", "mirror"] as const;

export function paintBrush(context: ToolContext, probe: PixelProbe): BrushKind {
  return {
    id: "brush",
    label: strings.tools.brush,
    icon: BrushIcon,
    shortcut: "B",
    options: ["color", "tip", ...COMMON, "alphaLock"],
    inner: () => (context.tools.settings.tip === null ? context.tools.settings.hardness : 1),
    alt: ({ hit }) => probe.pick(hit),
    begin: () => begin(context, false),
  };
}

export function eraserBrush(context: ToolContext): BrushKind {
  return {
    id: "eraser",
    label: strings.tools.eraser,
    icon: Eraser,
    shortcut: "E",
    options: COMMON,
    inner: () => context.tools.settings.hardness,
    begin: () => begin(context, true),
  };
}

function begin(context: ToolContext, erases: boolean): PaintGesture | null {
  const { session, store, board, tools, reach } = context;
  const { selectedId, editingMask } = store.state;
  const target = paintTargetOf(session.recordedDesign, selectedId, erases, editingMask);
  if (target.kind === "refused") {
    const words = strings.tools.refusals[target.reason];
    board.info({ ...words, title: words.title(target.name) });
    return null;
  }
  const { size, spacing, pressure, opacity, alphaLock, color, recent, mirror } = tools.settings;
  tools.configure({ recent: erases ? recent : withRecent(recent, color) });
  const id = erases ? "eraser" : "brush";
  const stroke = new StrokeGesture({
    brush: brushOf(context, erases),
    name: strings.tools[id],
    size: size ?? 1,
    spacing,
    pressure,
    opacity,
    erases,
    alphaLock: alphaLock && !erases,
    mirror: mirrorOf(mirror, store.state.model?.info ?? null),
    put: (design, layer) => withStroke(design, target, layer),
    session,
    reach,
    freeAbove: (...place) => context.viewer.surface.freeAbove(...place),
  });
  return {
    extend: (steps) => stroke.extend(steps),
    end: () => {
      const layerId = stroke.end(strings.tools.steps[id]);
      if (layerId === null) return;
      if (store.state.selectedId !== layerId) session.select(layerId);
      board.announce(strings.tools.painted[id]);
    },
    cancel: () => stroke.cancel(),
  };
}

function brushOf({ tools, session }: ToolContext, erases: boolean): Brush {
  const { color, flow, hardness, tip, tinted } = tools.settings;
  if (erases) return { tip: "round", color: "#000000", hardness, flow };
  if (tip !== null && Object.hasOwn(session.recordedDesign.assets, tip)) {
    return { tip: "picture", asset: tip, color: tinted ? color : null, flow };
  }
  return { tip: "round", color, hardness, flow };
}

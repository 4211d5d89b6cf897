/** Brush and eraser: what they paint with, and where it goes. */
import { Brush as BrushIcon, Eraser } from "lucide";
import type { Brush, Design } from "../document/index.ts";
import { withAsset } from "../state/design-edits.ts";
import { tellShownAlready } from "../state/mask-edits.ts";
import type { BrushKind } from "./brush-tool.ts";
import { mirrorOf } from "./mirror-setting.ts";
import { paintTargetOf, withStroke } from "./paint-target.ts";
import type { PixelProbe } from "./pixel-probe.ts";
import { type PaintGesture, StrokeGesture } from "./stroke-gesture.ts";
import type { ToolContext } from "./tool-context.ts";
import { type ToolSettings, withRecent } from "./tool-settings.ts";

const COMMON = ["size", "hardness", "flow", "opacity", "spacing", "stabiliser", "pressure", "mirror"] as const;

export function paintBrush(context: ToolContext, probe: PixelProbe): BrushKind {
  return {
    id: "brush",
    label: ({ tools }) => tools.brush,
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
    label: ({ tools }) => tools.eraser,
    icon: Eraser,
    shortcut: "E",
    options: COMMON,
    inner: () => context.tools.settings.hardness,
    begin: () => begin(context, true),
  };
}

function begin(context: ToolContext, erases: boolean): PaintGesture | null {
  const { session, store, board, tools, reach, bare, library } = context;
  const { strings } = board;
  const { selectedId, editingMask } = store.state;
  const target = paintTargetOf(session.recordedDesign, selectedId, erases, editingMask);
  if (target.kind === "refused") {
    const words = strings.tools.refusals[target.reason];
    board.info({ ...words, title: words.title(target.name) });
    return null;
  }
  const { settings } = tools;
  const { size, spacing, pressure, opacity, alphaLock, color, recent, mirror } = settings;
  tools.configure({ recent: erases ? recent : withRecent(recent, color) });
  const id = erases ? "eraser" : "brush";
  const stroke = new StrokeGesture({
    brush: brushIn(session.recordedDesign, settings, erases).brush,
    name: strings.tools[id],
    size: size ?? 1,
    aspect: erases ? 1 : aspectOf(settings.tip, library),
    spacing,
    pressure,
    opacity,
    erases,
    alphaLock: alphaLock && !erases,
    mirror: mirrorOf(mirror, store.state.model?.info ?? null),
    put: (before, layer) => {
      const { design, brush } = brushIn(before, settings, erases);
      return withStroke(design, target, { ...layer, brush }, strings);
    },
    session,
    reach,
    freeAbove: (...place) => context.viewer.surface.freeAbove(...place),
  });
  return {
    get full() {
      return stroke.full;
    },
    extend: (steps) => stroke.extend(steps),
    end: () => {
      const layerId = stroke.end(strings.tools.steps[id]);
      if (layerId === null) {
        bare.tell(stroke.bare);
        return;
      }
      if (store.state.selectedId !== layerId) session.select(layerId);
      board.announce(strings.tools.painted[id]);
      bare.tellTwins(stroke.materials);
      if (target.kind === "mask" && !erases) tellShownAlready(session.recordedDesign, layerId, board);
    },
    cancel: () => stroke.cancel(),
  };
}

/** A picture is printed in its own proportions. */
function aspectOf(tip: ToolSettings["tip"], library: ToolContext["library"]): number {
  const picture = library.get(tip?.asset);
  return picture ? picture.width / picture.height : 1;
}

/** What is painted with, and the design with the tip's picture among its assets. */
function brushIn(
  design: Design,
  { color, flow, hardness, tip, tinted }: ToolSettings,
  erases: boolean,
): { readonly design: Design; readonly brush: Brush } {
  if (erases) return { design, brush: { tip: "round", color: "#000000", hardness, flow } };
  if (tip === null) return { design, brush: { tip: "round", color, hardness, flow } };
  const { design: more, key } = withAsset(design, tip.name, tip.asset);
  return { design: more, brush: { tip: "picture", asset: key, color: tinted ? color : null, flow } };
}

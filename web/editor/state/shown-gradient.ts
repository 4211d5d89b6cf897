/** Which gradient the 3D view shows with handles, and what a drag of them does. */
import type { GradientPhase, GradientPlace } from "../../viewer/viewer-api.ts";
import { type FillLayer, type Gradient, walkLayers } from "../document/index.ts";
import { isLocked } from "../document/layer-tree.ts";
import { layerById } from "./design-edits.ts";
import type { EditorState } from "./editor-state.ts";
import type { LayerCommands } from "./layer-commands.ts";
import { maskFade } from "./mask-edits.ts";

/** The gradient of the mask that is painted on, else the selected fill's. */
function gradientLayer({
  design,
  selectedId,
  editingMask,
}: EditorState): (FillLayer & { gradient: Gradient }) | undefined {
  const layer = layerById(design, selectedId);
  if (editingMask !== null && editingMask === selectedId) return maskFade(layer);
  return layer?.type === "fill" && layer.gradient !== null ? { ...layer, gradient: layer.gradient } : undefined;
}

/** The gradient's, where it is shown and may be changed; else null. */
export function shownGradient(state: EditorState): GradientPlace | null {
  const { design } = state;
  const layer = gradientLayer(state);
  if (layer === undefined || isLocked(design, layer.id)) return null;
  for (const visit of walkLayers(design)) {
    if (visit.layer.id === layer.id && !visit.shown) return null;
  }
  const { gradient } = layer;
  return gradient.kind === "linear"
    ? { kind: "linear", from: gradient.from, to: gradient.to }
    : { kind: "radial", center: gradient.center, radius: gradient.radius };
}

/** Keeps the colours; `step` is what the history says. A drag is a step of its own; keys that follow each other closely are one. */
export function followGradient(
  state: EditorState,
  layers: LayerCommands,
  place: GradientPlace,
  phase: GradientPhase,
  step: string,
): void {
  const layer = gradientLayer(state);
  if (layer?.gradient.kind !== place.kind) return;
  if (phase === "cancel") {
    layers.cancelPreview();
    return;
  }
  const gradient = { ...place, stops: layer.gradient.stops };
  if (phase === "move") layers.preview(layer.id, { gradient });
  else layers.change(layer.id, { gradient }, step, phase === "step" ? `gradient:${layer.id}` : undefined);
}

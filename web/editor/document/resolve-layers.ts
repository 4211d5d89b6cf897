/** From the design's vocabulary to what the engine of today draws; what it cannot draw is refused by name. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type {
  EngineBrush,
  EngineFillLayer,
  EngineGradient,
  EngineGroupLayer,
  EngineLayer,
  EngineMask,
} from "../../engine/engine-api.ts";
import type {
  Brush,
  DecalLayer,
  Design,
  DesignLayer,
  FillLayer,
  Gradient,
  GroupLayer,
  LayerBase,
  Mirror,
  PaintLayer,
  StrokeLayer,
} from "./design.ts";
import { type DesignPath, describeValue, formatPath } from "./design-problem.ts";
import { parseHexColor } from "./hex-color.ts";
import { mirroredDabs, mirroredDecal, sameMirror } from "./mirror-layer.ts";

/**
 * The design's layers, bottom to top, as the engine takes them: paint layers as the groups that they are, and what has a
 * mirror with its twin inside the same layer.
 *
 * Hidden layers are checked too: a design that opens must not fail later, when a layer is shown.
 *
 * @param name The design's file name; errors name it.
 * @throws TexelcastError "unsupported": `field` is the path of the first feature that the engine cannot draw yet.
 */
export function resolveLayers(design: Design, name = "design"): EngineLayer[] {
  return resolveList(design.layers, ["layers"], name);
}

function resolveList(layers: readonly DesignLayer[], path: DesignPath, name: string): EngineLayer[] {
  return layers.map((layer, index) => resolveLayer(layer, [...path, index], name));
}

function resolveLayer(layer: DesignLayer, path: DesignPath, name: string): EngineLayer {
  const mask = resolveMask(layer, path, name);
  switch (layer.type) {
    case "text":
      throw unsupported(name, [...path, "type"], layer.type, "text layers", "every other type of layer");
    case "decal":
      return resolveDecal(layer, mask);
    case "stroke":
      return resolveStroke(layer, mask);
    case "fill":
      return resolveFill(layer, mask);
    case "group":
      return resolveGroup(layer, resolveList(layer.layers, [...path, "layers"], name), mask);
    case "paint":
      return resolvePaint(layer, mask, path, name);
  }
}

function resolveMask({ mask }: LayerBase, path: DesignPath, name: string): EngineMask | null {
  return mask === null ? null : { ...mask, layers: resolveList(mask.layers, [...path, "mask", "layers"], name) };
}

function resolveDecal(layer: DecalLayer, mask: EngineMask | null): EngineLayer {
  const { name: _shownName, locked: _locked, mirror, ...fields } = layer;
  const decal = { ...fields, mask };
  return mirror === null ? decal : mirroredDecal(decal, mirror);
}

function resolveStroke(layer: StrokeLayer, mask: EngineMask | null, outer: Mirror | null = null): EngineLayer {
  const { name: _shownName, locked: _locked, mirror, ...fields } = layer;
  const mirrors = [mirror, outer].filter((one) => one !== null);
  const [own, other] = mirrors;
  const different = own !== undefined && other !== undefined && sameMirror(own, other) ? [own] : mirrors;
  // The dabs' own objects: by them the engine knows what is new in a stroke that grows.
  return { ...fields, mask, brush: resolveBrush(layer.brush), dabs: mirroredDabs(layer.dabs, different) };
}

function resolveBrush(brush: Brush): EngineBrush {
  if (brush.tip === "round") return { ...brush, color: parseHexColor(brush.color) };
  return { ...brush, color: brush.color === null ? null : parseHexColor(brush.color) };
}

function resolveFill(layer: FillLayer, mask: EngineMask | null): EngineFillLayer {
  const { name: _shownName, locked: _locked, gradient, ...fields } = layer;
  return {
    ...fields,
    mask,
    color: parseHexColor(layer.color),
    gradient: gradient === null ? null : resolveGradient(gradient),
  };
}

function resolveGradient(gradient: Gradient): EngineGradient {
  const stops = gradient.stops.map(({ offset, color }) => ({ offset, color: parseHexColor(color) }));
  return { ...gradient, stops };
}

function resolveGroup(
  { id, visible, opacity, blend, blendSpace, lockAlpha, isolated }: GroupLayer,
  layers: readonly EngineLayer[],
  mask: EngineMask | null,
): EngineGroupLayer {
  return { id, type: "group", visible, opacity, blend, blendSpace, lockAlpha, isolated, layers, mask };
}

function resolvePaint(layer: PaintLayer, mask: EngineMask | null, path: DesignPath, name: string): EngineGroupLayer {
  const { id, visible, opacity, blend, blendSpace, lockAlpha } = layer;
  const layers = layer.strokes.map((stroke, index) =>
    resolveStroke(stroke, resolveMask(stroke, [...path, "strokes", index], name), layer.mirror),
  );
  return { id, type: "group", visible, opacity, blend, blendSpace, lockAlpha, isolated: true, layers, mask };
}

function unsupported(name: string, path: DesignPath, value: string, feature: string, works: string): TexelcastError {
  const field = formatPath(path);
  const shown = describeValue(value);
  return new TexelcastError("unsupported", `${field}: ${feature} cannot be drawn yet, is ${shown}`, {
    subject: name,
    field,
    value: shown,
    hint: `What works there: ${works}.`,
  });
}

/** From the design's vocabulary to what the engine of today draws; what it cannot draw is refused by name. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { EngineBrush, EngineLayer } from "../../engine/engine-api.ts";
import type { Brush, DecalLayer, Design, DesignLayer, FillLayer, StrokeLayer } from "./design.ts";
import { describeValue, formatPath } from "./design-problem.ts";
import { parseHexColor } from "./hex-color.ts";

/**
 * The design's layers, bottom to top, as the engine takes them.
 *
 * Hidden layers are checked too: a design that opens must not fail later, when a layer is shown.
 *
 * @param name The design's file name; errors name it.
 * @throws TexelcastError "unsupported": `field` is the path of the first feature that the engine cannot draw yet.
 */
export function resolveLayers(design: Design, name = "design"): EngineLayer[] {
  return design.layers.map((layer, index) => resolveLayer(layer, index, name));
}

function resolveLayer(layer: DesignLayer, index: number, name: string): EngineLayer {
  const place = ["layers", index];
  if (layer.type === "text") {
    throw unsupported(name, [...place, "type"], layer.type, "text layers", "decal, stroke and fill layers");
  }
  if (layer.type === "stroke") return resolveStroke(layer);
  return layer.type === "decal" ? resolveDecal(layer) : resolveFill(layer);
}

function resolveDecal(layer: DecalLayer): EngineLayer {
  const { name: _shownName, ...fields } = layer;
  return fields;
}

function resolveStroke(layer: StrokeLayer): EngineLayer {
  const { name: _shownName, ...fields } = layer;
  // The dabs' own objects: by them the engine knows what is new in a stroke that grows.
  return { ...fields, brush: resolveBrush(layer.brush) };
}

function resolveBrush(brush: Brush): EngineBrush {
  if (brush.tip === "round") return { ...brush, color: parseHexColor(brush.color) };
  return { ...brush, color: brush.color === null ? null : parseHexColor(brush.color) };
}

function resolveFill(layer: FillLayer): EngineLayer {
  const { name: _shownName, ...fields } = layer;
  return { ...fields, color: parseHexColor(layer.color) };
}

function unsupported(
  name: string,
  path: readonly (string | number)[],
  value: string,
  feature: string,
  works: string,
): TexelcastError {
  const field = formatPath(path);
  const shown = describeValue(value);
  return new TexelcastError("unsupported", `${field}: ${feature} cannot be drawn yet, is ${shown}`, {
    subject: name,
    field,
    value: shown,
    hint: `What works there: ${works}.`,
  });
}

/** From the design's vocabulary to what the engine of today draws; what it cannot draw is refused by name. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import type { EngineLayer } from "../../engine/engine-api.ts";
import type { DecalLayer, Design, DesignLayer, FillLayer } from "./design.ts";
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
  if (layer.type === "text" || layer.type === "stroke") {
    throw unsupported(name, [...place, "type"], layer.type, `${layer.type} layers`, "decal and fill layers");
  }
  return layer.type === "decal" ? resolveDecal(layer) : resolveFill(layer);
}

function resolveDecal(layer: DecalLayer): EngineLayer {
  const { name: _shownName, ...fields } = layer;
  return fields;
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

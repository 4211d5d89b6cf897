/** The print report: every printed layer measured on all the targets that it paints, and what follows from the numbers. */
import type { LayerMetrics } from "../core/abi.ts";
import type { LayerHandle } from "../core/target.ts";
import { perInch } from "./core-zones.ts";
import { materialsOf } from "./layer-materials.ts";
import { pictureOf } from "./layer-picture.ts";
import type { EnginePaintingLayer } from "./layer-tree.ts";
import { materialName } from "./model-info.ts";
import { OpenTarget } from "./open-target.ts";
import { findingsOf } from "./print-findings.ts";
import { printedLayers } from "./print-layers.ts";
import type { LayerPrint, PrintMeasures, PrintReport } from "./print-report.ts";
import { drawWhole, type PrintContext } from "./print-target.ts";
import { clipsMaterial } from "./zone-clip.ts";

const SQUARE_CENTIMETRES = 10_000;

/** Uses the targets that the page shows, and opens those that it does not at their own size. */
export async function measurePrint(context: PrintContext): Promise<PrintReport> {
  const layers = [...printedLayers(context.layers)];
  const opened: OpenTarget[] = [];
  const targets = new Map(context.targets);
  for (const target of targets.values()) target.checkDrawn();
  const unpaintable = new Map<number, string>();
  try {
    for (const material of new Set(layers.flatMap(materialsOf))) {
      if (targets.has(material)) continue;
      const { session, model, checkpoint } = context;
      const { paintStatus } = session.materialInfo(material);
      if (!session.core.isOk(paintStatus)) {
        unpaintable.set(material, session.core.statusMessage(paintStatus));
        continue;
      }
      const target = await OpenTarget.open({ material }, { session, model, checkpoint, onProgress: undefined });
      opened.push(target);
      targets.set(material, target);
      drawWhole(context, target);
    }
    const { materialCount } = context.session.modelInfo();
    const materials = Array.from({ length: materialCount }, (_, index) => materialName(context.model, index));
    const measured = layers.map((layer) => measureLayer(context, layer, targets));
    const missing = new Map(layers.map((layer) => [layer.id, missingOf(context, layer)]));
    const { violations, warnings } = findingsOf(context.zones, materials, measured, unpaintable, layers, missing);
    return {
      texelcastPrintReport: 1,
      printScale: context.zones.printScale,
      dpi: context.zones.dpi,
      layers: measured,
      whole: worstOf(measured),
      violations,
      warnings,
    };
  } finally {
    for (const target of opened) if (!context.session.core.crashed) target.destroy();
  }
}

function missingOf(context: PrintContext, layer: EnginePaintingLayer): readonly string[] {
  const picture = layer.type === "decal" ? pictureOf(layer) : null;
  return picture === null ? [] : context.missing(picture);
}

function measureLayer(
  { session, zones, isDrawn }: PrintContext,
  layer: EnginePaintingLayer,
  targets: ReadonlyMap<number, OpenTarget>,
): LayerPrint {
  const found = materialsOf(layer).flatMap((material) => {
    const handle = targets.get(material)?.handleOf(layer.id);
    return handle === undefined ? [] : [{ material, handle }];
  });
  const handles: LayerHandle[] = found.map(({ handle }) => handle);
  const { metrics, zoneShares } = session.measureLayer(handles, zones.zones.length);
  // What is cut off at the zones is not printed, and nobody pays for it.
  const cut = found.filter(({ material }) => clipsMaterial(zones, material)).map(({ handle }) => handle);
  const isAllCut = cut.length === handles.length;
  const ofCut = isAllCut || cut.length === 0 ? metrics : session.measureLayer(cut, zones.zones.length).metrics;
  const cutArea = cut.length === 0 ? 0 : ofCut.area * ofCut.outsideZones;
  const picture = layer.type === "decal" ? pictureOf(layer) : null;
  const shares = zones.zones.map(({ id }, index) => ({ id, share: zoneShares[index] ?? 0 }));
  return {
    id: layer.id,
    type: layer.type,
    materials: found.map(({ material }) => material),
    zones: shares.filter(({ share }) => share > 0),
    ...measuresOf({ ...metrics, area: metrics.area - cutArea }, (perMetre) => perInch(perMetre, zones), {
      hasPicture: picture !== null && metrics.paintedTexels > 0,
      isDrawn: picture !== null && isDrawn(picture),
      scale: zones.printScale,
    }),
  };
}

function measuresOf(
  metrics: LayerMetrics,
  inch: (perMetre: number) => number,
  of: { readonly hasPicture: boolean; readonly isDrawn: boolean; readonly scale: number },
): PrintMeasures {
  const least = of.isDrawn ? metrics.leastTexelsPerMetre : metrics.leastPixelsPerMetre;
  const mean = of.isDrawn ? metrics.meanTexelsPerMetre : metrics.meanPixelsPerMetre;
  return {
    dpi: of.hasPicture ? { least: inch(least), mean: inch(mean) } : null,
    stretch: of.hasPicture ? { greatest: metrics.greatestStretch * 100, mean: metrics.meanStretch * 100 } : null,
    clipped: metrics.clipped,
    hidden: metrics.hidden,
    outsideZones: metrics.outsideZones,
    inSafeMargin: metrics.inSafeMargin,
    overlapTexels: metrics.overlappingTexels,
    mirroredTexels: metrics.mirroredTexels,
    areaCm2: metrics.area * of.scale * of.scale * SQUARE_CENTIMETRES,
  };
}

function worstOf(layers: readonly LayerPrint[]): PrintMeasures {
  const greatest = (of: (layer: LayerPrint) => number): number => Math.max(0, ...layers.map(of));
  const sum = (of: (layer: LayerPrint) => number): number => layers.reduce((total, layer) => total + of(layer), 0);
  const dpi = layers.flatMap((layer) => (layer.dpi === null ? [] : [layer.dpi]));
  const stretch = layers.flatMap((layer) => (layer.stretch === null ? [] : [layer.stretch]));
  return {
    dpi: dpi.length === 0 ? null : { least: lowest(dpi, "least"), mean: lowest(dpi, "mean") },
    stretch:
      stretch.length === 0
        ? null
        : {
            greatest: Math.max(...stretch.map((one) => one.greatest)),
            mean: Math.max(...stretch.map((one) => one.mean)),
          },
    clipped: greatest((layer) => layer.clipped),
    hidden: greatest((layer) => layer.hidden),
    outsideZones: greatest((layer) => layer.outsideZones),
    inSafeMargin: greatest((layer) => layer.inSafeMargin),
    overlapTexels: sum((layer) => layer.overlapTexels),
    mirroredTexels: sum((layer) => layer.mirroredTexels),
    areaCm2: sum((layer) => layer.areaCm2),
  };
}

const lowest = (list: readonly { least: number; mean: number }[], key: "least" | "mean"): number =>
  Math.min(...list.map((one) => one[key]));

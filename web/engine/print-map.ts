/** Heat maps of the print: the density or the stretch of decals at each texel, as a picture in the texture's own form. */
import { PrintMaps } from "../core/abi.ts";
import { checkValue, oneOf } from "./check-value.ts";
import { perInch } from "./core-zones.ts";
import type { Picture } from "./engine-api.ts";
import { pictureOf } from "./layer-picture.ts";
import type { OpenTarget } from "./open-target.ts";
import { printedLayers } from "./print-layers.ts";
import type { PrintMapKind } from "./print-report.ts";
import { drawWhole, type PrintContext, withTarget } from "./print-target.ts";

/** Most texels that are copied out of the core at once. */
const COPY_TEXELS = 1 << 21;
/** Percent of stretch that is all red. */
const WORST_STRETCH = 100;

type Rgb = readonly [number, number, number];
const RED: Rgb = [214, 48, 49];
const AMBER: Rgb = [240, 176, 40];
const GREEN: Rgb = [32, 150, 96];

/** RGBA, straight alpha: clear where no decal lies. */
export async function drawPrintMap(context: PrintContext, material: number, kind: PrintMapKind): Promise<Picture> {
  checkValue(kind, oneOf("dpi", "stretch"), "kind");
  const shown = context.targets.get(material);
  shown?.checkDrawn();
  if (shown !== undefined) return draw(context, shown, kind);
  return withTarget(context, { material }, null, (target) => {
    drawWhole(context, target);
    return draw(context, target, kind);
  });
}

function draw(context: PrintContext, target: OpenTarget, kind: PrintMapKind): Picture {
  const { width, height } = target.info;
  const layers = [...printedLayers(context.layers)].flatMap((layer) => {
    const picture = layer.type === "decal" ? pictureOf(layer) : null;
    const handle = picture === null ? undefined : target.handleOf(layer.id);
    if (picture === null || handle === undefined) return [];
    const byPixels = context.isDrawn(picture) ? PrintMaps.texels : PrintMaps.pixels;
    return [{ handle, map: kind === "dpi" ? byPixels : PrintMaps.stretch }];
  });
  const rgba = new Uint8Array(width * height * 4);
  const rowsAtOnce = Math.max(1, Math.floor(COPY_TEXELS / width));
  for (let row = 0; row < height; row += rowsAtOnce) {
    const count = Math.min(rowsAtOnce, height - row);
    const worst = new Float32Array(width * count);
    for (const { handle, map } of layers) {
      target.core.printMap(handle, map, row, count).forEach((value, texel) => {
        const before = worst[texel] as number;
        if (value === 0) return;
        worst[texel] = before === 0 ? value : kind === "dpi" ? Math.min(before, value) : Math.max(before, value);
      });
    }
    worst.forEach((value, texel) => {
      if (value === 0) return;
      const goodness =
        kind === "dpi" ? goodnessOfDpi(perInch(value, context.zones), context) : goodnessOfStretch(value);
      rgba.set([...colorOf(goodness), 255], (row * width + texel) * 4);
    });
  }
  return { width, height, rgba };
}

/** 0 at the least DPI and below, 1 at good DPI and above. */
function goodnessOfDpi(dpi: number, { zones }: PrintContext): number {
  const { least, good } = zones.dpi;
  if (dpi < least) return 0;
  return dpi >= good ? 1 : 0.25 + (0.75 * (dpi - least)) / (good - least);
}

const goodnessOfStretch = (ratio: number): number => Math.max(0, 1 - ((ratio - 1) * 100) / WORST_STRETCH);

function colorOf(goodness: number): Rgb {
  const [from, to, share] = goodness < 0.5 ? [RED, AMBER, goodness * 2] : [AMBER, GREEN, goodness * 2 - 1];
  const mix = (channel: 0 | 1 | 2): number => Math.round(from[channel] + (to[channel] - from[channel]) * share);
  return [mix(0), mix(1), mix(2)];
}

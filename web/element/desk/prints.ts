/** What a shop gets of a design: the texture as it is printed, and what the printer would say of it. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { findLayer } from "../../editor/document/layer-tree.ts";
import type { PrintZones } from "../../engine/print-zones.ts";
import type { MapPicture } from "../../viewer/viewer-api.ts";
import type { ExportedTexture, ExportTextureOptions, LayerArea, PrintReport } from "../element-api.ts";
import type { AtDesk } from "../mode.ts";
import type { DeskSettings } from "./desk-settings.ts";
import { addressOf, type Fetching, fetchBytes, nameOf } from "./read-model.ts";

/** Options with what the element says in the place of what was left out. */
export function printOptions(
  mode: AtDesk,
  options: ExportTextureOptions,
  settings: DeskSettings,
): ExportTextureOptions {
  const { size } = settings;
  const ownSize = options.size === undefined && options.dpi === undefined && size !== null;
  const ownMaterial = options.material === undefined && options.zone === undefined;
  return { ...(ownMaterial && { material: mode.desk.material }), ...(ownSize && { size }), ...options };
}

export async function exportTexture(mode: AtDesk, options: ExportTextureOptions): Promise<ExportedTexture> {
  await mode.idle();
  return await mode.desk.engine.exportPrint(options);
}

export async function printReport(mode: AtDesk): Promise<PrintReport> {
  await mode.idle();
  return await mode.desk.engine.printReport();
}

/** What each layer of the design prints, as a report of it says. */
export function layerAreas({ desk }: AtDesk, report: PrintReport): readonly LayerArea[] {
  return report.layers.flatMap(({ id, areaCm2 }) => {
    const layer = findLayer(desk.design, id);
    return layer ? [{ id, name: layer.name, type: layer.type, area: areaCm2 }] : [];
  });
}

/** Reads a zones file, or what is in one. Rejects with "bad-zones", "missing-file". */
export async function readZones(input: string | object, base: string, fetching: Fetching): Promise<PrintZones> {
  const { parseZones } = await import("../../editor/document/zones.ts");
  if (input instanceof URL) return await readZones(input.href, base, fetching);
  if (typeof input !== "string") return parseZones(plain(input));
  if (input.trimStart().startsWith("{")) return parseZones(input);
  const url = addressOf(input, base, fetching.words);
  return parseZones(new TextDecoder().decode(await fetchBytes(url, fetching)), nameOf(url));
}

function plain(data: object): unknown {
  try {
    return JSON.parse(JSON.stringify(data)) as unknown;
  } catch (cause) {
    throw new TexelcastError("bad-zones", "The zones are not plain data.", { cause });
  }
}

/** What no decal covers, in a heat map: neither good nor bad. */
const NEUTRAL = [214, 217, 222] as const;

/** The density of the decals on every open material: red is too coarse, green sharp, grey no decal. */
export async function heatMaps(mode: AtDesk): Promise<ReadonlyMap<number, MapPicture>> {
  const { engine, store } = mode.desk;
  await mode.idle();
  const maps = new Map<number, MapPicture>();
  for (const material of store.state.targets.keys()) {
    const { width, height, rgba } = await engine.printMap(material, "dpi");
    for (let at = 0; at < rgba.length; at += 4) {
      const alpha = (rgba[at + 3] ?? 0) / 255;
      for (const channel of [0, 1, 2] as const) {
        rgba[at + channel] = Math.round((rgba[at + channel] ?? 0) * alpha + NEUTRAL[channel] * (1 - alpha));
      }
      rgba[at + 3] = 255;
    }
    maps.set(material, { width, height, rgba });
  }
  return maps;
}

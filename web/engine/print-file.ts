/**
 * Print files: what a customer approves and what a shop prints come from here, in the browser and in Node, so that they
 * are the same bytes. The page's own targets have no say in it: every print is drawn by itself.
 */
import { sha256 } from "@noble/hashes/sha2.js";
import { bytesToHex } from "@noble/hashes/utils.js";
import { MAX_TEXTURE_SIZE } from "../core/sizes.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { checkPrintOptions } from "./check-print-options.ts";
import { METRES_PER_INCH } from "./core-zones.ts";
import { nextTurn } from "./event-loop.ts";
import { type FlatBounds, type FlatMap, flatBounds, flatMap, sampleFlat } from "./flat-art.ts";
import { materialsOf } from "./layer-materials.ts";
import { paintingLayers } from "./layer-tree.ts";
import { PngStream } from "./png-stream.ts";
import { type PrintRaster, paintBands } from "./print-raster.ts";
import type { PrintFile, PrintFileOptions } from "./print-report.ts";
import { DEFAULT_DPI, type PrintSurvey, type Size, surveyPrint } from "./print-size.ts";
import { type PrintContext, printBase, withTarget } from "./print-target.ts";
import type { PrintZone } from "./print-zones.ts";
import type { TexelRect } from "./zone-clip.ts";

/** Texels of a zone that are held at once to be laid out flat: 384 MiB. */
const MOST_FLAT_TEXELS = 96 * 2 ** 20;
/** Of a picture that is compressed before others have their turn. */
const BYTES_A_TURN = 4 * 2 ** 20;
/** Pixels of flat art. */
const MOST_ART_PIXELS = 256 * 2 ** 20;

/**
 * Makes a print file.
 *
 * @param windowSide Side of the windows in which the texture is painted; for tests, as it changes no byte.
 * @throws TexelcastError "bad-argument" (an unknown zone, `flattened` without a zone), "no-material" (of a layer), "bad-size",
 * "bad-zones", "out-of-budget", "cancelled", and what is wrong with layers and their pictures.
 */
export async function makePrintFile(
  context: PrintContext,
  options: PrintFileOptions,
  windowSide?: number,
): Promise<PrintFile> {
  checkPrintOptions(options);
  const zone = findZone(context, options);
  const material = options.material ?? zone?.material ?? 0;
  checkOptions(options, zone, material);
  checkMaterials(context);
  const survey = await surveyPrint(context, material, zone, options);
  const base = await printBase(context, material, options.base ?? "model");
  const [width, height] = survey.size;
  const print: PrintRaster = {
    material,
    size: survey.size,
    base,
    raster: survey.raster,
    rect: { x: 0, y: 0, width, height },
    zone: null,
    windowSide,
  };
  if (zone === null) return writeRows(context, print, survey.dpi);
  const cut = { ...print, rect: zoneRect(survey), zone: context.zones.zones.indexOf(zone) };
  return options.flattened
    ? writeFlat(context, cut, survey, options.dpi ?? DEFAULT_DPI)
    : writeRows(context, cut, survey.dpi);
}

function findZone({ zones }: PrintContext, { zone }: PrintFileOptions): PrintZone | null {
  if (zone === undefined) return null;
  const found = zones.zones.find(({ id }) => id === zone);
  if (found) return found;
  const known = zones.zones.map(({ id }) => `“${id}”`).join(", ");
  throw badOption(
    "zone",
    zone,
    `There is no zone “${zone}”: ${known === "" ? "there are none" : `there are ${known}`}.`,
  );
}

/** Of every layer, hidden ones included: a server takes a design whole or not at all, and what is approved here must be printed there. */
function checkMaterials({ session, layers }: PrintContext): void {
  for (const material of new Set(paintingLayers(layers).flatMap(materialsOf))) session.materialInfo(material);
}

function checkOptions({ flattened }: PrintFileOptions, zone: PrintZone | null, material: number): void {
  if (flattened && zone === null) throw badOption("flattened", "true", "Only a zone can be laid out flat: name one.");
  if (zone !== null && material !== zone.material) {
    const message = `The zone “${zone.name}” is one of material ${zone.material}, not of ${material}.`;
    throw badOption("material", String(material), message);
  }
}

const badOption = (field: string, value: string, message: string): TexelcastError =>
  new TexelcastError("bad-argument", message, { field, value });

/** The zone's rectangle in the texture, from where the survey saw it: two of its texels more on every side. */
function zoneRect({ surface, size, surveyed }: PrintSurvey): TexelRect {
  const [scaleX, scaleY] = [size[0] / surveyed[0], size[1] / surveyed[1]];
  const x = Math.max(0, Math.floor((surface.firstX - 2) * scaleX));
  const y = Math.max(0, Math.floor((surface.firstY - 2) * scaleY));
  const endX = Math.min(size[0], Math.ceil((surface.endX + 2) * scaleX));
  const endY = Math.min(size[1], Math.ceil((surface.endY + 2) * scaleY));
  return { x, y, width: endX - x, height: endY - y };
}

async function writeRows(context: PrintContext, print: PrintRaster, dpi: Size): Promise<PrintFile> {
  const { width, height } = print.rect;
  const png = new PngStream(width, height, dpi);
  await paintBands(context, print, (rows) => addInTurns(png, rows, width * 4));
  return finished(png, [width, height], dpi);
}

async function writeFlat(
  context: PrintContext,
  print: PrintRaster,
  survey: PrintSurvey,
  dpi: number,
): Promise<PrintFile> {
  const { rect } = print;
  if (rect.width * rect.height > MOST_FLAT_TEXELS) {
    const found = `${rect.width} × ${rect.height}`;
    throw new TexelcastError("out-of-budget", `The zone takes ${found} texels, too many to be laid out flat at once.`, {
      field: "size",
      value: found,
      hint: "Ask for fewer DPI or a smaller size, or print the zone as it lies in the texture.",
    });
  }
  const map = flatMap(survey.surface);
  const bounds = await measureFlat(context, print, survey, map);
  const size = artSize(bounds, dpi, context);
  const rgba = new Uint8Array(rect.width * rect.height * 4);
  let at = 0;
  await paintBands(context, print, (rows) => {
    rgba.set(rows, at);
    at += rows.length;
  });
  const png = new PngStream(size[0], size[1], [dpi, dpi]);
  sampleFlat({ width: rect.width, height: rect.height, rgba }, rect, map, bounds, size, (row) => png.addRows(row));
  return finished(png, size, [dpi, dpi]);
}

/** By the cover on the surveyed texture, in texels of the print's. */
async function measureFlat(
  context: PrintContext,
  print: PrintRaster,
  { size, surveyed }: PrintSurvey,
  map: FlatMap,
): Promise<FlatBounds> {
  const [width, height] = surveyed;
  const [scaleX, scaleY] = [size[0] / width, size[1] / height];
  const scaled = { xx: map.xx * scaleX, xy: map.xy * scaleX, yx: map.yx * scaleY, yy: map.yy * scaleY };
  const options = { material: print.material, width, height, gutter: 0, base: [0, 0, 0, 0] as const };
  const cover = await withTarget(context, options, null, (target) => target.core.zoneMask(print.zone, 0, height));
  const bounds = flatBounds(cover, { x: 0, y: 0, width, height }, scaled);
  if (bounds === null) throw new TexelcastError("bad-zones", "The zone is too small to be printed.", { field: "zone" });
  return bounds;
}

function artSize({ left, right, top, bottom }: FlatBounds, dpi: number, { zones }: PrintContext): Size {
  const pixels = (metres: number): number =>
    Math.max(1, Math.round((metres * zones.printScale * dpi) / METRES_PER_INCH));
  const size: Size = [pixels(right - left), pixels(bottom - top)];
  if (Math.max(...size) <= MAX_TEXTURE_SIZE * 2 && size[0] * size[1] <= MOST_ART_PIXELS) return size;
  throw new TexelcastError("bad-size", `At ${dpi} DPI the zone would be ${size[0]} × ${size[1]} pixels.`, {
    field: "dpi",
    value: String(dpi),
    hint: "Ask for fewer DPI, or look whether the zones file has the right print scale.",
  });
}

/** The thread must not seem to hang. */
async function addInTurns(png: PngStream, rows: Uint8Array, rowBytes: number): Promise<void> {
  const step = Math.max(1, Math.floor(BYTES_A_TURN / rowBytes)) * rowBytes;
  for (let at = 0; at < rows.length; at += step) {
    png.addRows(rows.subarray(at, at + step));
    await nextTurn();
  }
}

function finished(png: PngStream, [width, height]: Size, dpi: Size): PrintFile {
  const bytes = png.finish();
  return { bytes, sha256: bytesToHex(sha256(bytes)), width, height, dpi };
}

/**
 * Printing and checking designs on a server: `renderPrint` gives the bytes that the page's `exportPrint` gives for the same
 * design, files, model and options, so that what a customer approved is what is printed.
 */
import { types } from "node:util";
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { formatPath } from "../web/editor/document/design-problem.ts";
import { type Design, parseDesign, parseZones, resolveLayers } from "../web/editor/document/index.ts";
import { checkPrintOptions } from "../web/engine/check-print-options.ts";
import type { ModelSource } from "../web/engine/engine-api.ts";
import { cancelled } from "../web/engine/engine-faults.ts";
import { materialsIn } from "../web/engine/layer-tree.ts";
import type { PrintFile, PrintFileOptions, PrintReport } from "../web/engine/print-report.ts";
import { checkAssetBytes, checkCheckArguments, checkRenderArguments } from "./print-arguments.ts";
import { type PrintJob, withPrintJob } from "./print-job.ts";
import { checkPrintedMaterial } from "./printed-material.ts";
import { readDataUri } from "./read-design.ts";
import { decodeText } from "./read-file.ts";
import { readModel } from "./read-model.ts";

export type { PrintFile, PrintFileOptions, PrintReport } from "../web/engine/print-report.ts";

/** A file that a design names. */
export interface PrintAsset {
  /** As in the design's `uri`. */
  readonly name: string;
  readonly bytes: Uint8Array;
}

/** Bytes of a file by the `uri` that the design names it with, and by the asset's key; null: there is no such file. */
export type AssetReader = (uri: string, key: string) => Uint8Array | null | Promise<Uint8Array | null>;

/** What errors call a design that has no file. */
const DESIGN_NAME = "design";

export interface PrintSubject {
  /** A path, the bytes of a .glb, or a model with its side files. */
  readonly model: string | Uint8Array | ModelSource;
  /** A design document: JSON text, its bytes, or what it holds. */
  readonly design: unknown;
  /** The design's files, or who has them. Those in `data:` addresses and fonts that come with Texelcast need none. */
  readonly assets?: readonly PrintAsset[] | AssetReader;
  /** A zones file: JSON text, its bytes, or what it holds. */
  readonly zones?: unknown;
}

export interface RenderPrintOptions extends PrintSubject, PrintFileOptions {
  /** Ends the print as "cancelled", also while it waits for the design's files. */
  readonly signal?: AbortSignal;
  /** 0 to 1. */
  readonly onProgress?: (share: number) => void;
}

export interface CheckPrintOptions extends PrintSubject {
  /** Texels of the square textures on which is measured; default: the materials' own. */
  readonly size?: number;
}

/**
 * Makes a print file.
 *
 * @throws TexelcastError "bad-design", "bad-zones", "bad-model", "no-material", "no-uvs" (and what else keeps a material from
 * being painted), "missing-file" (an asset), "bad-picture", "bad-argument", "bad-size", "out-of-budget", "cancelled".
 */
export async function renderPrint(options: RenderPrintOptions): Promise<PrintFile> {
  const { model, design, assets, zones, signal, onProgress, ...print } = checkRenderArguments(options);
  checkPrintOptions(print);
  if (signal?.aborted) throw cancelled();
  const job = await printJob({ model, design, ...(assets && { assets }), zones });
  return withPrintJob({ ...job, signal }, (engine, info) => {
    checkPrintedMaterial(info, print, job.zones, { material: { file: info.name, field: "material" }, zones: "zones" });
    return engine.exportPrint(print, onProgress, signal);
  });
}

/** Measures what becomes of each layer on the surface (docs/print-truth.md). Throws as `renderPrint` does. */
export async function checkPrint(options: CheckPrintOptions): Promise<PrintReport> {
  const { size, ...subject } = checkCheckArguments(options);
  const job = await printJob(subject);
  return withPrintJob(job, async (engine, info) => {
    if (size === undefined) return engine.printReport();
    const materials = new Set(job.layers.filter((layer) => layer.visible).flatMap(materialsIn));
    // Of what lies on the others the report tells that it is not printed.
    const paintable = [...materials].filter((material) => info.materials[material]?.refusal === null);
    for (const material of paintable) await engine.openTarget({ material, width: size, height: size });
    return engine.printReport();
  });
}

async function printJob({ model, design, assets, zones }: PrintSubject): Promise<PrintJob> {
  const document = parseDesign(textOf(design, "bad-design", "the design"));
  return {
    model: await modelSource(model),
    design: document,
    file: DESIGN_NAME,
    layers: resolveLayers(document),
    readAsset: (key) => readAsset(document, key, assets ?? []),
    zones: zones === undefined || zones === null ? null : parseZones(textOf(zones, "bad-zones", "the zones file")),
  };
}

/** As `readFile` gives a file without being asked for text. A path in its place, as the model may be given, is told what it is. */
function textOf(given: unknown, code: string, what: string): unknown {
  if (typeof given === "string" && /^[^{[\n]+\.json$/i.test(given)) {
    throw new TexelcastError(code, `“${given}” is a path: ${what} is given as what is in its file`, {
      hint: `await readFile("${given}", "utf8")`,
    });
  }
  if (!types.isUint8Array(given)) return given;
  return decodeText(given, { code, what, file: what, hint: "It is a JSON file: save it as UTF-8." });
}

async function modelSource(model: PrintSubject["model"]): Promise<ModelSource> {
  if (typeof model === "string") {
    return await readModel(model).catch((thrown: unknown) => {
      if (!(thrown instanceof TexelcastError) || thrown.message.includes(model)) throw thrown;
      // The command line says the file before the message; what a server logs is the message.
      throw new TexelcastError(thrown.code, `“${model}”: ${thrown.message}`, { ...thrown.toJSON(), cause: thrown });
    });
  }
  return types.isUint8Array(model) ? { name: "model.glb", bytes: model } : model;
}

async function readAsset(
  design: Design,
  key: string,
  assets: NonNullable<PrintSubject["assets"]>,
): Promise<{ name: string; bytes: Uint8Array }> {
  const uri = design.assets[key]?.uri ?? "";
  const field = formatPath(["assets", key, "uri"]);
  if (/^data:/i.test(uri)) return { name: key, bytes: readDataUri(uri, DESIGN_NAME, field) };
  const given =
    typeof assets === "function" ? await assets(uri, key) : assets.find((asset) => asset.name === uri)?.bytes;
  const bytes = checkAssetBytes(given, uri);
  if (bytes) return { name: uri, bytes };
  throw new TexelcastError("missing-file", `The file “${uri}” of the asset “${key}” was not given.`, {
    subject: uri,
    field: `assets.${key}`,
    hint: "Give it among `assets`, under the name that the design has for it.",
  });
}

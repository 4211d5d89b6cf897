/** `texelcast print`: a design on a model as a file for the printer. */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { materialsIn } from "../../web/engine/layer-tree.ts";
import { isSizedTwice } from "../../web/engine/print-options.ts";
import type { PrintFileOptions } from "../../web/engine/print-report.ts";
import { missingCharacters } from "../missing-characters.ts";
import { withPrintJob } from "../print-job.ts";
import { checkPrintedMaterial, printedMaterial } from "../printed-material.ts";
import { Progress } from "../progress.ts";
import { assetFilesOf, readAsset, readDesign } from "../read-design.ts";
import { readModel } from "../read-model.ts";
import { formatCount, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";
import { readZones } from "./check.ts";

export interface PrintOptions extends Omit<PrintFileOptions, "size" | "base"> {
  readonly out: string;
  readonly zones?: string;
  readonly size?: { readonly width: number; readonly height: number };
  /** False: the layers alone. */
  readonly base: boolean;
}

/** Writes the file and prints its hash. @throws TexelcastError for what cannot be read, printed or written */
export async function print(modelFile: string, designFile: string, options: PrintOptions): Promise<void> {
  const { out, zones: zonesFile, size, base, ...rest } = options;
  checkOptions(options);
  await checkOutputFile(out, [modelFile, designFile, ...(zonesFile === undefined ? [] : [zonesFile])]);
  const zones = zonesFile === undefined ? null : await readZones(zonesFile);
  const design = await readDesign(designFile);
  const model = await readModel(modelFile);
  await checkOutputFile(out, [...(await assetFilesOf(design)), ...model.files]);
  const job = { ...design, model, readAsset: (key: string) => readAsset(design, key), zones };
  const wanted: PrintFileOptions = {
    ...rest,
    ...(size && { size: [size.width, size.height] }),
    base: base ? "model" : "none",
  };
  const progress = new Progress();
  const files = new PendingFiles();
  try {
    const { file, missing } = await withPrintJob(job, async (engine, info) => {
      checkPrintedMaterial(info, rest, zones, { zones: zonesFile ?? "" });
      const file = await engine.exportPrint(wanted, (share) => progress.report("Printing", share));
      const material = printedMaterial(rest, zones);
      const printed = job.layers.filter((layer) => layer.visible && materialsIn(layer).includes(material));
      return { file, missing: await missingCharacters(engine, printed) };
    }).catch((error: unknown) => {
      throw namingOptions(error, zonesFile);
    });
    await files.write(out, file.bytes);
    await files.commit();
    progress.end();
    process.stderr.write(missing);
    const dpi = file.dpi.map((dots) => dots.toFixed(0)).join(" x ");
    const what = `${file.width} x ${file.height} pixels, ${dpi} DPI, ${formatCount(file.bytes.length)} bytes`;
    process.stdout.write(`${printable(out)}: ${what}\nsha256 ${file.sha256}\n`);
  } finally {
    progress.end();
    await files.discard();
  }
}

/** What is asked of a zone asks for one, and no texture has two sizes. @throws TexelcastError "bad-argument" */
function checkOptions({ zones, zone, flattened, size, dpi }: PrintOptions): void {
  const wrong = (option: string, why: string, hint: string) =>
    new TexelcastError("bad-argument", `--${option}: ${why}`, { field: option, hint });
  if (zone !== undefined && zones === undefined) {
    throw wrong(
      "zone",
      `there is no zone ${JSON.stringify(zone)} without a zones file`,
      "Name that file with --zones.",
    );
  }
  if (flattened && zone === undefined) {
    throw wrong(
      "flattened",
      "only a zone can be laid out flat",
      "Name the zones file with --zones and one of its zones with --zone.",
    );
  }
  if (isSizedTwice({ size, dpi, flattened })) {
    throw wrong(
      "dpi",
      `--size has said already how many texels are printed, so ${dpi} DPI cannot be kept`,
      "Give one of the two.",
    );
  }
}

/** The engine knows no files and no options: those that a print was asked for by are named here. */
function namingOptions(error: unknown, file: string | undefined): unknown {
  if (!(error instanceof TexelcastError)) return error;
  if (error.code === "bad-size" && error.field === "dpi") {
    return new TexelcastError(error.code, `--dpi: ${error.message}`, { ...error.toJSON(), cause: error });
  }
  if (file === undefined) return error;
  const details = { ...error.toJSON(), subject: file, cause: error };
  if (error.code === "bad-zones" && error.field === "zone")
    return new TexelcastError(error.code, error.message, details);
  if (error.code !== "bad-argument") return error;
  if (error.field === "zone") {
    const hint = "Check the id; upper and lower case differ.";
    return new TexelcastError(error.code, `--zone: ${error.message}`, { ...details, hint });
  }
  if (error.field === "material") {
    // No wrong usage: which material the zone is on stands in the file.
    const hint = "Leave --material out: the zone's own is taken.";
    return new TexelcastError("no-material", `--material: ${error.message}`, { ...details, hint });
  }
  return error;
}

/** `texelcast unwrap`: the model with texture coordinates in which no two triangles of a material share a texel. */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { ModelSource } from "../../web/engine/engine-api.ts";
import { SHARED_TEXELS } from "../../web/engine/shared-texels.ts";
import { type UnwrappedMaterial, unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { findMaterial } from "../find-material.ts";
import { inspectModel, type MaterialReport, type ModelReport } from "../inspect-model.ts";
import { openEngine } from "../open-engine.ts";
import { Progress } from "../progress.ts";
import { readModel } from "../read-model.ts";
import { formatCount, formatShare, plural, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";

export interface UnwrapCommandOptions {
  readonly out: string;
  /** Side of the new textures, texels. */
  readonly size: number;
  /** Without it, all that share texels or have no texture coordinates of use. */
  readonly material?: number;
}

/** Writes the file and tells what has become of each material. @throws TexelcastError for what cannot be read, unwrapped or written */
export async function unwrap(file: string, { out, size, material }: UnwrapCommandOptions): Promise<void> {
  await checkOutputFile(out, [file]);
  const model = await readModel(file);
  await checkOutputFile(out, model.files);
  const engine = openEngine();
  const progress = new Progress();
  const files = new PendingFiles();
  try {
    const measure = (source: ModelSource): Promise<ModelReport> =>
      inspectModel(engine, source, (index, share) => progress.report(`Measuring material ${index}`, share));
    progress.report("Reading the model");
    if (material !== undefined) findMaterial(await engine.loadModel(model), material);
    const before = await measure(model);
    const materials = material === undefined ? needing(before) : [material];
    const result = await unwrapModel(model, {
      materials,
      size,
      onProgress: (share) => progress.report("Unwrapping", share),
    });
    const after = await measure({ name: out, bytes: result.glb });
    await files.write(out, result.glb);
    await files.commit();
    progress.end();
    process.stdout.write(describe(out, result.glb.length, size, result.materials, before, after));
  } finally {
    progress.end();
    await files.discard();
    engine.dispose();
  }
}

/** @throws TexelcastError "no-material" where there is none. */
function needing({ file, materials }: ModelReport): number[] {
  const found = materials.filter(
    ({ refusal, uv }) =>
      refusal?.code === "no-uvs" ||
      refusal?.code === "bad-uvs" ||
      (uv.measured !== null && uv.measured.overlap > SHARED_TEXELS),
  );
  if (found.length > 0) return found.map(({ index }) => index);
  throw new TexelcastError("no-material", "no material shares texels or lacks texture coordinates of use", {
    subject: file,
    field: "--material",
    hint: "Name one with --material to unwrap it all the same.",
  });
}

function describe(
  out: string,
  byteCount: number,
  size: number,
  unwrapped: readonly UnwrappedMaterial[],
  before: ModelReport,
  after: ModelReport,
): string {
  const lines = unwrapped.flatMap(({ material, triangles, charts, withoutPlace, texCoord }) => {
    const was = before.materials[material];
    const is = after.materials[material];
    const name = was?.name ? ` "${printable(was.name)}"` : "";
    return [
      `  material ${material}${name}: ${plural(triangles, "triangle")} in ${plural(charts, "chart")}, ${size} x ${size} texels, TEXCOORD_${texCoord}`,
      `    overlap ${shareOf(was)} before, ${shareOf(is)} now; coverage ${formatShare(is?.uv.measured?.coverage ?? 0)}`,
      ...(withoutPlace > 0 ? [`    ${plural(withoutPlace, "triangle")} without area got no place`] : []),
    ];
  });
  return `${printable(out)}: ${formatCount(byteCount)} bytes\n${lines.join("\n")}\n`;
}

const shareOf = (report: MaterialReport | undefined): string =>
  report?.uv.measured ? formatShare(report.uv.measured.overlap) : "-";

/** `texelcast variant`: the model with another variant of its materials (KHR_materials_variants). */
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Variants, variantsOf, withVariant } from "../../web/engine/material-variants.ts";
import { readModel } from "../read-model.ts";
import { formatCount, printable } from "../terminal-text.ts";
import { checkOutputFile, PendingFiles } from "../write-files.ts";

export interface VariantCommandOptions {
  readonly out: string;
  /** As the model calls it. */
  readonly name: string;
}

/** Writes the file and tells which materials took which place. @throws TexelcastError for what cannot be read or written, "bad-argument" */
export async function variant(file: string, { out, name }: VariantCommandOptions): Promise<void> {
  await checkOutputFile(out, [file]);
  const model = await readModel(file);
  await checkOutputFile(out, model.files);
  const { glb, moved } = withVariant(model, placeOf(name, variantsOf(model), file));
  const files = new PendingFiles();
  try {
    await files.write(out, glb);
    await files.commit();
  } finally {
    await files.discard();
  }
  const lines = [...moved].map(([before, now]) => `  material ${now.join(", ")} in place of ${before}\n`);
  process.stdout.write(`${printable(out)}: ${formatCount(glb.length)} bytes\n${lines.join("")}`);
}

/** @throws TexelcastError "bad-argument" naming those that there are */
function placeOf(name: string, variants: Variants | null, file: string): number {
  const place = variants?.names.indexOf(name) ?? -1;
  if (place >= 0) return place;
  const missing = variants ? `no such variant, “${name}”` : `no variants, so not “${name}” either`;
  throw new TexelcastError("bad-argument", `--name: the model has ${missing}`, {
    subject: file,
    field: "--name",
    value: name,
    ...(variants && { hint: `Name one of ${variants.names.map((each) => `“${each}”`).join(", ")}.` }),
  });
}

/** The model that an address means by what stands behind its "#". Loaded where there is one, and for archives. */
import type { ModelSource } from "./engine-api.ts";
import { inVariant } from "./variant-look.ts";
import { isZip } from "./zip-signature.ts";

/** An address without the variant that it asks for; null: it asks for none. */
export function splitVariant(name: string): { readonly address: string; readonly variant: string | null } {
  const [, address = name, variant = null] = /^(.*?)#variant=(.*)$/s.exec(name) ?? [];
  return { address, variant };
}

/**
 * Of an archive the model in it (`unzipModel`), and of a model the look of the variant that its name ends with, as in
 * "shoe.glb#variant=street" (`inVariant`), called without it. Any other model is given back as it is.
 *
 * @throws TexelcastError "bad-archive", "bad-container", "bad-model"
 */
export async function chosenModel(given: ModelSource): Promise<ModelSource> {
  const { address: name, variant } = splitVariant(given.name);
  const named = variant === null ? given : { ...given, name };
  const source = isZip(given.bytes) ? (await import("./zipped-model.ts")).unzipModel(named) : named;
  return variant === null ? source : inVariant(source, variant);
}

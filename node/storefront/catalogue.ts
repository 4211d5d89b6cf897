/** The products that the shop sells, from its file, and their models. */
import { readFile } from "node:fs/promises";
import path from "node:path";
import * as v from "valibot";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { formatPath } from "../../web/editor/document/design-problem.ts";
import { parseJson } from "../../web/editor/document/parse-json.ts";
import { filledText, numberBetween, strict } from "../../web/editor/document/schema-parts.ts";
import type { ModelSource } from "../../web/engine/engine-api.ts";
import type { Product } from "../../web/storefront/api/shop-api.ts";
import { decodeText, readFileBytes } from "../read-file.ts";
import { boxSurface } from "./design-work.ts";

const line = filledText(1000);
const amount = v.pipe(numberBetween(0, 1e9), v.integer("must be a whole number"));
/** Below the folder of the shop's files. */
const address = v.pipe(
  line,
  v.regex(/^(?:[\w-]+\/)*[\w-]+(?:\.[\w-]+)+$/, "must be a plain relative address, as demo/mug.glb"),
);

const products = v.pipe(
  v.array(
    strict({
      id: v.pipe(line, v.regex(/^[a-z0-9-]+$/, "must be small letters, digits and dashes")),
      name: line,
      tagline: line,
      description: line,
      facts: v.array(strict({ name: line, value: line })),
      model: address,
      zones: address,
      picture: address,
      poster: address,
      material: v.pipe(numberBetween(0, 65_535), v.integer("must be a whole number")),
      camera: v.pipe(line, v.regex(/^[-\w.%]+ [-\w.%]+ [-\w.%]+$/, "must be two angles and a distance")),
      price: strict({
        currency: v.pipe(line, v.regex(/^[A-Z]{3}$/, "must be a currency of three letters")),
        base: amount,
        perDecal: amount,
        perSquareCentimetre: amount,
      }),
    }),
    "must be a list of products",
  ),
  v.nonEmpty("must hold a product"),
  v.check((list) => new Set(list.map(({ price }) => price.currency)).size === 1, "must all have one currency"),
);

export interface Catalogue {
  readonly products: ReadonlyMap<string, Product>;
  readonly currency: string;
  /** Files are read when first asked for, and kept. */
  modelOf(product: Product): Promise<ModelSource>;
  /** The text of the product's zones file. */
  zonesOf(product: Product): Promise<string>;
  /** Square metres of what of it is printed, about; measured when first asked for. */
  surfaceOf(product: Product): Promise<number>;
}

/**
 * @param folder with `shop/products.json` and what it names
 * @throws TexelcastError "missing-file" without that list, "bad-argument" naming the field that is wrong in it.
 */
export async function readCatalogue(folder: string): Promise<Catalogue> {
  const file = path.join(folder, "shop", "products.json");
  const about = {
    code: "bad-argument",
    what: "the list of products",
    file,
    hint: "It comes with the shop's built pages.",
  };
  const text = decodeText(await readFileBytes(file, about), about);
  const list = parseJson(text, file, about.what, about.code);
  const result = v.safeParse(products, list, { abortEarly: true });
  if (!result.success) {
    const [issue] = result.issues;
    const field = formatPath((issue.path ?? []).map((item) => item.key as string | number));
    throw new TexelcastError("bad-argument", `${field}: ${issue.message}`, { subject: file, field });
  }
  const files = new Map<string, Promise<Uint8Array>>();
  const bytesOf = (name: string) => keptIn(files, name, () => readFile(path.join(folder, name)));
  const modelOf = async ({ model }: Product): Promise<ModelSource> => ({ name: model, bytes: await bytesOf(model) });
  const surfaces = new Map<Product, Promise<number>>();
  return {
    products: new Map(result.output.map((product) => [product.id, product])),
    currency: (result.output[0] as Product).price.currency,
    modelOf,
    zonesOf: async ({ zones }) => new TextDecoder().decode(await bytesOf(zones)),
    surfaceOf: (product) => keptIn(surfaces, product, async () => measured(await modelOf(product), product.material)),
  };
}

/** What was made of a key before, or is made now. What fails is not kept: the next one who asks tries anew. */
function keptIn<Key, Value>(kept: Map<Key, Promise<Value>>, key: Key, make: () => Promise<Value>): Promise<Value> {
  const there = kept.get(key);
  if (there !== undefined) return there;
  const made = make();
  kept.set(key, made);
  made.catch(() => kept.delete(key));
  return made;
}

async function measured(model: ModelSource, material: number): Promise<number> {
  const { createEngineHost } = await import("../../web/engine/engine-host.ts");
  const engine = createEngineHost();
  try {
    const { boundsMin, boundsMax, materials } = await engine.loadModel(model);
    const printed = materials[material] ?? { boundsMin, boundsMax };
    return boxSurface(printed.boundsMin, printed.boundsMax);
  } finally {
    engine.dispose();
  }
}

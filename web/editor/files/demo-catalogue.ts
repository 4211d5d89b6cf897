/** The demo models and decals that come with the page, as `demo/demo.json` lists them. */

import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { fetchWhole } from "./fetch-whole.ts";

export interface DemoModel {
  readonly id: string;
  readonly name: string;
  /** Address relative to the page. */
  readonly model: string;
  /** The design that it opens with: a document, still to be parsed, whose addresses are relative to the catalogue. */
  readonly design: unknown;
}

/** A model without a design, to begin on. */
export interface DemoTemplate {
  readonly id: string;
  readonly name: string;
  readonly hint: string;
  /** Addresses relative to the page. */
  readonly model: string;
  readonly picture: string;
  /** Width and height of its texture, texels. */
  readonly size: readonly [number, number];
}

export interface DemoDecal {
  readonly id: string;
  readonly name: string;
  /** Address relative to the page. */
  readonly picture: string;
}

export interface DemoCatalogue {
  /** Of the catalogue and of the page. */
  readonly url: string;
  readonly page: string;
  readonly models: readonly DemoModel[];
  readonly templates: readonly DemoTemplate[];
  readonly decals: readonly DemoDecal[];
}

/** Rejects with a TexelcastError of code "missing-file" when the demos were not built or cannot be reached. */
export async function loadDemoCatalogue(page: string, strings: Strings): Promise<DemoCatalogue> {
  const url = new URL("demo/demo.json", page).href;
  const response = await fetch(url).catch(() => undefined);
  const list: unknown = response?.ok ? await response.json().catch(() => undefined) : undefined;
  if (typeof list !== "object" || list === null) {
    throw new ToldError("missing-file", strings.errors.noDemos, {
      subject: url,
      hint: strings.errors.noDemosHint,
    });
  }
  const { models = [], templates = [], decals = [] } = list as Partial<DemoCatalogue>;
  const { named } = strings;
  return {
    ...{ url, page },
    models: models.map((model) => ({ ...model, name: named(model.name) })),
    templates: templates.map((each) => ({ ...each, name: named(each.name), hint: named(each.hint) })),
    decals: decals.map((decal) => ({ ...decal, name: named(decal.name) })),
  };
}

/** Rejects with a TexelcastError of code "missing-file". */
export async function fetchBytes(address: string, base: string): Promise<Uint8Array> {
  const bytes = await fetchWhole(new URL(address, base));
  if (!bytes) {
    const details = { subject: address, reason: "not-loaded" };
    throw new TexelcastError("missing-file", `${address} could not be fetched.`, details);
  }
  return bytes;
}

/** Reads a design document: text or plain data in, a `Design` with every field set out, or an error that says all. */
import * as v from "valibot";
import { isShippedFontAddress } from "../../engine/font-address.ts";
import { SHIPPED_FONTS, shippedFontOf } from "../../engine/shipped-fonts.ts";
import { DESIGN_FORMAT, DESIGN_VERSION, type Design, type DesignLayer, freeLayerNumber, layerIdOf } from "./design.ts";
import { type DesignPath, type DesignProblem, describeValue, designError, formatPath } from "./design-problem.ts";
import { DESIGN_LIMITS, designSchema, type ParsedDesign, type ParsedLayer } from "./design-schema.ts";
import { parseJson } from "./parse-json.ts";

/** Turns the plain data of a version into that of the version after it. May throw a TexelcastError. */
export type Migration = (document: Readonly<Record<string, unknown>>) => Record<string, unknown>;

/** By the version that they start from. Version 1 is the first, so there are none yet. */
const MIGRATIONS: ReadonlyMap<number, Migration> = new Map();

/** Reading goes on past a fault so that an author sees all of them at once, but a file of faults only is not worth it. */
const ENOUGH_REFERENCE_PROBLEMS = 50;

/**
 * Reads a design (spec.md, 8).
 *
 * @param source JSON text, or the data that such text holds.
 * @param name The file's name as the user knows it; errors name it.
 * @throws TexelcastError "bad-design": `field` and `value` are those of the first problem, the message tells them all.
 */
export function parseDesign(source: unknown, name = "design"): Design {
  const data = typeof source === "string" ? parseJson(source, name, "the design", "bad-design") : source;
  const current = migrateDesign(data, name, MIGRATIONS);
  checkSize(current, name);
  const result = v.safeParse(designSchema, current);
  if (!result.success) throw designError(name, problemsOf(result.issues));
  const problems = referenceProblems(result.output);
  if (problems.length > 0) throw designError(name, problems);
  return complete(result.output);
}

/**
 * Checks format and version, and brings an older version up to today's. Exported for its tests.
 *
 * @throws TexelcastError "bad-design" for another format, and for a version that is unknown or newer than ours.
 */
export function migrateDesign(data: unknown, name: string, migrations: ReadonlyMap<number, Migration>): unknown {
  const refuse = (path: DesignPath, message: string, value: unknown, hint: string) => {
    throw designError(name, [{ path, message, value }], hint);
  };
  if (typeof data !== "object" || data === null || Array.isArray(data)) {
    refuse([], "must be a JSON object", data, 'A design begins { "format": "texelcast-design", "version": 1, … }.');
  }
  let document = data as Record<string, unknown>;
  const { format } = document;
  if (format !== DESIGN_FORMAT) {
    refuse(["format"], `must be "${DESIGN_FORMAT}"`, format, "The file may be JSON of another program.");
  }
  for (;;) {
    const { version } = document;
    if (version === DESIGN_VERSION) return document;
    const migration = typeof version === "number" ? migrations.get(version) : undefined;
    if (migration === undefined) {
      const newer = typeof version === "number" && Number.isInteger(version) && version > DESIGN_VERSION;
      const hint = newer ? "A newer Texelcast made this design: update to open it." : "The only version is 1.";
      refuse(["version"], `must be ${DESIGN_VERSION}`, version, hint);
      return document;
    }
    document = migration(document);
  }
}

function problemsOf(issues: readonly v.BaseIssue<unknown>[]): DesignProblem[] {
  return issues.map((issue) => {
    const path = (issue.path ?? []).map((item) => item.key as string | number);
    const unknownField = issue.type === "strict_object" && issue.expected === "never";
    // A check of several fields has been given all of them; which one it names, its path knows.
    const value = issue.path ? issue.path.at(-1)?.value : issue.input;
    // The value of an unknown field says nothing about the fault; its name, in the path, does.
    return { path, message: issue.message, ...(unknownField ? {} : { value }) };
  });
}

/** A list of layers in data that nothing is known of yet; `from` and `key` tell where it stands. */
interface RawList {
  readonly value: readonly unknown[];
  readonly key: DesignPath;
  readonly from: { readonly list: RawList; readonly index: number } | null;
  readonly depth: number;
}

/**
 * Counts layers and depth before any schema follows them down: a hostile file must not use up the stack. What is no list
 * or no layer is left to the schema.
 */
function checkSize(document: unknown, name: string): void {
  const pathOf = ({ key, from }: RawList): DesignPath =>
    from === null ? key : [...pathOf(from.list), from.index, ...key];
  const lists: RawList[] = [];
  const meet = (value: unknown, key: DesignPath, from: RawList["from"], depth: number): void => {
    if (Array.isArray(value)) lists.push({ value, key, from, depth });
  };
  meet(fieldOf(document, "layers"), ["layers"], null, 1);
  let count = 0;
  for (let list = lists.pop(); list !== undefined; list = lists.pop()) {
    if (list.value.length === 0) continue;
    if (list.depth > DESIGN_LIMITS.depth) {
      const message = `must not hold layers: they would lie more than ${DESIGN_LIMITS.depth} deep`;
      throw designError(name, [{ path: pathOf(list), message, value: list.value }]);
    }
    count += list.value.length;
    if (count > DESIGN_LIMITS.layers) {
      const message = `must not hold more than ${DESIGN_LIMITS.layers} layers, those within others included`;
      throw designError(name, [{ path: pathOf(list), message, value: list.value }]);
    }
    for (const [index, layer] of list.value.entries()) {
      const from = { list, index };
      meet(fieldOf(fieldOf(layer, "mask"), "layers"), ["mask", "layers"], from, list.depth + 1);
      meet(fieldOf(layer, "layers"), ["layers"], from, list.depth + 1);
      meet(fieldOf(layer, "strokes"), ["strokes"], from, list.depth + 1);
    }
  }
}

const fieldOf = (value: unknown, key: string): unknown =>
  typeof value === "object" && value !== null ? (value as Record<string, unknown>)[key] : undefined;

/** What one layer's schema cannot see: ids that collide, and assets that are not there or of the wrong kind. */
function referenceProblems(design: ParsedDesign): DesignProblem[] {
  const problems: DesignProblem[] = [];
  const firstUse = new Map<string, DesignPath>();
  const check = (layers: readonly ParsedLayer[], listPath: DesignPath): void => {
    layers.forEach((layer, index) => {
      if (problems.length >= ENOUGH_REFERENCE_PROBLEMS) return;
      const path = [...listPath, index];
      if (layer.id !== undefined) {
        const first = firstUse.get(layer.id);
        if (first === undefined) firstUse.set(layer.id, path);
        else {
          const message = `must be unique: ${formatPath(first)} has the same id`;
          problems.push({ path: [...path, "id"], message, value: layer.id });
        }
      }
      if (layer.type === "decal") problems.push(...assetProblems(design, [...path, "asset"], layer.asset, "image/"));
      if (layer.type === "stroke" && layer.brush.tip === "picture")
        problems.push(...assetProblems(design, [...path, "brush", "asset"], layer.brush.asset, "image/"));
      if (layer.type === "text") problems.push(...assetProblems(design, [...path, "font"], layer.font, "font/"));
      if (layer.mask !== null) check(layer.mask.layers, [...path, "mask", "layers"]);
      if (layer.type === "group") check(layer.layers, [...path, "layers"]);
      if (layer.type === "paint") check(layer.strokes, [...path, "strokes"]);
    });
  };
  check(design.layers, ["layers"]);
  return [...problems, ...addressProblems(design)];
}

/** Addresses of our own that lead nowhere. */
function addressProblems(design: ParsedDesign): DesignProblem[] {
  return Object.entries(design.assets).flatMap(([key, { type, uri }]) => {
    if (!isShippedFontAddress(uri)) return [];
    if (shippedFontOf(uri) === undefined) {
      const known = describeNames(Object.keys(SHIPPED_FONTS));
      return [{ path: ["assets", key, "uri"], message: `must name a font that there is (${known})`, value: uri }];
    }
    const message = `must be "font/ttf", as its address is that of a font`;
    return type === "font/ttf" ? [] : [{ path: ["assets", key, "type"], message, value: type }];
  });
}

function assetProblems(design: ParsedDesign, path: DesignPath, key: string, kind: "image/" | "font/"): DesignProblem[] {
  const asset = Object.hasOwn(design.assets, key) ? design.assets[key] : undefined;
  if (asset === undefined) {
    const names = Object.keys(design.assets);
    const known = names.length === 0 ? "there are none" : `there are: ${describeNames(names)}`;
    return [{ path, message: `must name one of the design's assets (${known})`, value: key }];
  }
  if (asset.type.startsWith(kind)) return [];
  const noun = kind === "image/" ? "a picture" : "a font";
  return [{ path, message: `must name ${noun}, but that asset's type is ${describeValue(asset.type)}`, value: key }];
}

function describeNames(names: readonly string[]): string {
  const shown = names.slice(0, 8).map((name) => describeValue(name));
  return names.length > shown.length ? `${shown.join(", ")} and ${names.length - shown.length} more` : shown.join(", ");
}

/** Gives ids and names to the layers that have none: the same file always gets the same ones. */
function complete(design: ParsedDesign): Design {
  const taken = new Set<string>();
  const collect = (layers: readonly ParsedLayer[]): void => {
    for (const layer of layers) {
      if (layer.id !== undefined) taken.add(layer.id);
      if (layer.mask !== null) collect(layer.mask.layers);
      if (layer.type === "group") collect(layer.layers);
      if (layer.type === "paint") collect(layer.strokes);
    }
  };
  collect(design.layers);
  // Counting never goes back, so that a file which takes many such ids on purpose costs no more than its length.
  let number = 0;
  let met = 0;
  const completeLayer = (layer: ParsedLayer): DesignLayer => {
    met += 1;
    if (layer.id === undefined) number = freeLayerNumber(taken, Math.max(number + 1, met));
    const named = { ...layer, id: layer.id ?? layerIdOf(number), name: layer.name ?? defaultName(layer) };
    const mask = layer.mask === null ? null : { ...layer.mask, layers: layer.mask.layers.map(completeLayer) };
    const whole = { ...named, mask } as DesignLayer;
    if (layer.type === "group") return { ...whole, layers: layer.layers.map(completeLayer) } as DesignLayer;
    if (layer.type === "paint") return { ...whole, strokes: layer.strokes.map(completeLayer) } as DesignLayer;
    return whole;
  };
  return { ...design, layers: design.layers.map(completeLayer) };
}

function defaultName(layer: ParsedLayer): string {
  if (layer.type === "decal") return layer.asset;
  return { text: "Text", stroke: "Stroke", fill: "Fill", group: "Group", paint: "Paint" }[layer.type];
}

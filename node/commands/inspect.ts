/** `texelcast inspect`: can this model take decals, and how well is it unwrapped? */
import { printJson } from "../../web/editor/document/print-json.ts";
import { inspectModel, type MaterialReport, type ModelReport } from "../inspect-model.ts";
import { openEngine } from "../open-engine.ts";
import { Progress } from "../progress.ts";
import { readModel } from "../read-model.ts";
import { formatBounds, formatCount, formatShare, formatTable, plural, printable } from "../terminal-text.ts";

export interface InspectOptions {
  readonly json?: boolean;
}

/** Prints the table or the JSON. @throws TexelcastError for a model that cannot be read */
export async function inspect(file: string, { json = false }: InspectOptions): Promise<void> {
  const model = await readModel(file);
  const engine = openEngine();
  const progress = new Progress();
  try {
    progress.report("Reading the model");
    const report = await inspectModel(engine, model, (material, share) => {
      progress.report(`Measuring material ${material}`, share);
    });
    progress.end();
    process.stdout.write(json ? printJson(report) : describeModel(report));
  } finally {
    progress.end();
    engine.dispose();
  }
}

const HEADING = [
  "material",
  "name",
  "triangles",
  "texture",
  "UV coverage",
  "overlap",
  "out of range",
  "degenerate",
  "decals",
];
const RIGHT_ALIGNED = [true, false, true, true, true, true, true, true, false];

function describeModel({ file, triangles, vertices, bounds, materials, variants }: ModelReport): string {
  const rows = materials.map(describeMaterial);
  const refusals = materials.flatMap(({ index, refusal }) =>
    refusal === null ? [] : [`material ${index} cannot take decals: ${refusal.message} (${refusal.code})`],
  );
  return [
    `${printable(file)}: ${plural(triangles, "triangle")}, ${formatCount(vertices)} vertices, ${plural(materials.length, "material")}`,
    `bounds ${formatBounds(bounds.min, bounds.max)}`,
    ...(variants === undefined
      ? []
      : [`variants ${variants.names.map((name) => describeVariant(name, variants)).join(", ")}`]),
    "",
    formatTable([HEADING, ...rows], RIGHT_ALIGNED),
    ...(refusals.length === 0 ? [] : ["", ...refusals.map(printable)]),
    "",
  ].join("\n");
}

const describeVariant = (name: string, { shown }: NonNullable<ModelReport["variants"]>): string =>
  `${name === "" ? "-" : printable(name)}${name === shown ? " (shown)" : ""}`;

function describeMaterial({ index, name, canTakeDecals, triangles, textureSize, uv }: MaterialReport): string[] {
  return [
    String(index),
    name === "" ? "-" : printable(name),
    formatCount(triangles),
    textureSize === null ? "none" : textureSize.join(" x "),
    uv.measured === null ? "-" : formatShare(uv.measured.coverage),
    uv.measured === null ? "-" : formatShare(uv.measured.overlap),
    formatCount(uv.outOfRangeTriangles),
    formatCount(uv.degenerateTriangles),
    canTakeDecals ? "yes" : "NO",
  ];
}
